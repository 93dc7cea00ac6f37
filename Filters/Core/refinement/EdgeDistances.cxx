// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/EdgeDistances.h"

namespace geodesic
{

Deviation EdgeDistances::deviation(Id edge)
{
  if (edge >= this->ofEdge_.size())
  {
    this->ofEdge_.resize(this->triangles_.numberOfEdges());
  }
  Measured& measured = this->ofEdge_[edge];
  if (!measured.known)
  {
    measured = { this->workers_.first().distances.ofEdge(edge), true };
  }
  return measured.deviation;
}

void EdgeDistances::measure(const std::vector<Id>& edges)
{
  this->ofEdge_.resize(this->triangles_.numberOfEdges());
  this->unknown_.clear();
  for (const Id edge : edges)
  {
    if (!this->ofEdge_[edge].known)
    {
      this->ofEdge_[edge].known = true; // set early: an edge may occur twice
      this->unknown_.push_back(edge);
    }
  }
  this->workers_.run(this->unknown_.size(),
    [this](RefinementWorker& worker, std::size_t i)
    {
      const Id edge = this->unknown_[i];
      this->ofEdge_[edge].deviation = worker.distances.ofEdge(edge);
    });
}

void EdgeDistances::forget(Id firstEdge)
{
  if (firstEdge < this->ofEdge_.size())
  {
    this->ofEdge_.resize(firstEdge);
  }
}

}
