// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementWorkers.h"

namespace geodesic
{

void RefinementWorkers::resize(std::size_t count)
{
  while (this->workers_.size() < count)
  {
    this->workers_.push_back(std::make_unique<RefinementWorker>(this->field_, this->triangles_));
  }
}

Deviation RefinementWorkers::deviation(Id edge)
{
  if (edge >= this->edges_.size())
  {
    this->edges_.resize(this->triangles_.numberOfEdges());
  }
  if (!this->edges_[edge].isMeasured)
  {
    this->edges_[edge] = { this->first().distances.ofEdge(edge), true };
  }
  return this->measured(edge);
}

void RefinementWorkers::measure(const std::vector<Id>& edges)
{
  this->edges_.resize(this->triangles_.numberOfEdges());
  std::vector<Id> unknown;
  for (const Id edge : edges)
  {
    if (!this->edges_[edge].isMeasured)
    {
      this->edges_[edge].isMeasured = true; // set early: an edge may occur twice
      unknown.push_back(edge);
    }
  }
  this->run(unknown.size(),
    [&](RefinementWorker& worker, std::size_t i)
    { this->edges_[unknown[i]].deviation = worker.distances.ofEdge(unknown[i]); });
}

void RefinementWorkers::forgetNewEdges()
{
  if (this->edges_.size() > this->triangles_.numberOfEdges())
  {
    this->edges_.resize(this->triangles_.numberOfEdges());
  }
}

}
