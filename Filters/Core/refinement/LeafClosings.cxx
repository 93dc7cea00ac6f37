// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/LeafClosings.h"

#include <algorithm>
#include <array>
#include <utility>

namespace geodesic
{

const std::vector<LeafClosings::Closed>& LeafClosings::findBest(const std::vector<Id>& leaves)
{
  this->measureEdges(leaves);
  this->best_.resize(leaves.size());
  this->workers_.run(leaves.size(),
    [&](RefinementWorker& worker, std::size_t i)
    { this->best_[i] = this->findBest(worker, leaves[i]); });
  return this->best_;
}

// Afterwards all edges of the leaves, and the halves of split ones, exist and are measured, so that
// several threads can examine the leaves.
void LeafClosings::measureEdges(const std::vector<Id>& leaves)
{
  std::vector<Id> edges;
  for (const Id leaf : leaves)
  {
    for (Id k = 0; k < 3; ++k)
    {
      const Id edge = this->triangles_.edge(leaf, k);
      edges.push_back(edge);
      if (this->triangles_.isSplit(edge))
      {
        const Id halves = this->triangles_.edgeData(edge).halves;
        edges.push_back(halves);
        edges.push_back(halves + 1);
      }
    }
  }
  this->edges_.measure(edges);
}

LeafClosings::Closed LeafClosings::findBest(RefinementWorker& worker, Id leaf) const
{
  const Id ways = RedGreenMesh::waysToClose(this->triangles_.splitEdges(leaf));
  if (ways == 1)
  {
    return { 0, this->check_.check(worker, leaf, this->triangles_.closing(leaf, 0), false) };
  }
  const Id face = this->triangles_.faceOf(leaf);
  const double allowed = this->shapes_.allowedAngle(face, this->largestAround(leaf));
  std::array<std::pair<double, Id>, 4> order;
  order.fill({ Infinity, ways }); // unused places come last
  for (Id way = 0; way < ways; ++way)
  {
    const double angle = this->shapes_.smallestAngle(face, this->triangles_.closing(leaf, way));
    order[way] = { -angle, way };
  }
  std::sort(order.begin(), order.end());
  Closed best;
  for (Id i = 0; i < ways && (i == 0 || -order[i].first >= allowed); ++i)
  {
    const Id way = order[i].second;
    const ClosingCheck::Result check =
      this->check_.check(worker, leaf, this->triangles_.closing(leaf, way), false);
    if (i == 0 || check.passed || check.sample < best.check.sample)
    {
      best = { way, check };
    }
    if (best.check.passed)
    {
      break;
    }
  }
  return best;
}

double LeafClosings::largestAround(Id leaf) const
{
  double largest = 0.0;
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->triangles_.existingEdge(leaf, k);
    largest = std::max(largest, this->edges_.measured(edge).largest());
  }
  return largest;
}

double LeafClosings::tightBound(Id leaf)
{
  this->measureEdges({ leaf });
  const RedGreenMesh::Closing closing =
    this->triangles_.closing(leaf, this->triangles_.wayOf(leaf));
  return this->check_.check(this->workers_.first(), leaf, closing, true).bound;
}

}
