// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/LeafClosings.h"

#include "Tolerance.h"

#include <algorithm>
#include <array>
#include <utility>

namespace geodesic
{

std::vector<LeafClosings::Check> LeafClosings::findBest(const std::vector<Id>& leaves)
{
  this->measureEdges(leaves);
  std::vector<Check> best(leaves.size());
  this->workers_.run(leaves.size(),
    [&](RefinementWorker& worker, std::size_t i) { best[i] = this->findBest(worker, leaves[i]); });
  return best;
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
      const Id edge = this->triangles_.ensureEdge(leaf, k);
      this->triangles_.forEachPartOf(edge, [&edges](Id part) { edges.push_back(part); });
    }
  }
  this->workers_.measure(edges);
}

LeafClosings::Check LeafClosings::findBest(RefinementWorker& worker, Id leaf) const
{
  const Id ways = this->triangles_.waysToClose(leaf);
  if (ways == 1)
  {
    return this->check(worker, leaf, 0, false);
  }
  const double allowed = this->rules_.allowedAngle(leaf);
  std::array<std::pair<double, Id>, 4> order;
  order.fill({ Infinity, ways }); // unused places come last
  for (Id way = 0; way < ways; ++way)
  {
    order[way] = { -this->rules_.smallestAngle(leaf, way), way };
  }
  std::sort(order.begin(), order.end());
  Check best = this->check(worker, leaf, order[0].second, false);
  for (Id i = 1; i < ways && !best.passed && -order[i].first >= allowed; ++i)
  {
    const Check check = this->check(worker, leaf, order[i].second, false);
    if (check.passed || check.sample < best.sample)
    {
      best = check;
    }
  }
  return best;
}

double LeafClosings::tightBound(Id leaf)
{
  this->measureEdges({ leaf });
  return this->check(this->workers_.first(), leaf, this->triangles_.wayOf(leaf), true).bound;
}

LeafClosings::Check LeafClosings::check(RefinementWorker& worker, Id leaf, Id way, bool tight) const
{
  Check worst;
  worst.way = way;
  if (this->triangles_.isThin(leaf) && !tight)
  {
    // If the edges need more points, the triangles between them have yet to be found.
    worst.sample = this->worstPartOfEdges(leaf);
    if (worst.sample > this->tolerance_)
    {
      worst.passed = false;
      worst.limit = this->tolerance_;
      return worst;
    }
  }
  const FaceDistance& face = worker.distances.face(this->triangles_.faceOf(leaf));
  const RedGreenMesh::Closing closing = this->triangles_.closing(leaf, way);
  Across across;
  for (const std::array<Id, 3>& triangle : closing.triangles)
  {
    const Check one = this->checkTriangle(worker, face, closing, triangle, across, tight);
    worst.bound = std::max(worst.bound, one.bound);
    worst.sample = std::max(worst.sample, one.sample);
    worst.limit = std::min(worst.limit, one.limit);
    worst.passed = worst.passed && one.passed;
  }
  return worst;
}

double LeafClosings::worstPartOfEdges(Id leaf) const
{
  double worst = 0.0;
  this->triangles_.forEachPartOfEdges(
    leaf, [&](Id edge) { worst = std::max(worst, this->workers_.deviation(edge).largest()); });
  return worst;
}

// In an approximate field the faces around a point differ by what merging has changed, which no
// refinement can undo. The triangle gets the rest of the tolerance, but at least half of it.
// Refinement ends whatever rounding does: distances change by no more than the length moved, so a
// triangle as small as the tolerance passes.
LeafClosings::Check LeafClosings::checkTriangle(RefinementWorker& worker, const FaceDistance& face,
  const RedGreenMesh::Closing& closing, const std::array<Id, 3>& t, Across& across,
  bool tight) const
{
  LinearPiece linear;
  double largest = 0.0;
  double difference = 0.0;
  Deviation onEdges;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id corner = closing.points[t[k]];
    const double distance = worker.distances.atPoint(corner);
    linear.corners[k] = this->triangles_.inPlane(corner, face.face());
    linear.values[k] = worker.distances.atPoint(corner, face, linear.corners[k]);
    largest = std::max(largest, distance);
    difference = std::max(difference, std::abs(linear.values[k] - distance));
    // The side runs along an edge of the mesh or across the leaf.
    const Id end = t[(k + 1) % 3];
    const Id edge = closing.edgeBetween(t[k], end);
    if (edge != NoId)
    {
      onEdges.widen(this->workers_.deviation(edge));
    }
    else
    {
      // independent of the direction, to the last digit
      const std::pair<Id, Id> ends = std::minmax(corner, closing.points[end]);
      auto known = std::find_if(
        across.begin(), across.end(), [&ends](const auto& one) { return one.first == ends; });
      if (known == across.end())
      {
        across.push_back({ ends, worker.distances.between(ends.first, ends.second, face) });
        known = across.end() - 1;
      }
      onEdges.widen(known->second);
    }
  }
  const double rounding = tolerance::FaceRounding * largest;
  Check result;
  result.limit = std::max(this->tolerance_ - difference - rounding, 0.5 * this->tolerance_);
  const bool small = longestEdge(linear.corners) <= result.limit;
  if (onEdges.largest() > result.limit && !small && !tight)
  {
    result.sample = onEdges.largest();
    result.passed = false;
    return result;
  }
  const ErrorInside inside = worker.error.of(face, linear, onEdges, result.limit, tight || small);
  const double own = std::max(inside.bound, onEdges.largest());
  result.bound = own + rounding + difference;
  result.sample = inside.sample;
  result.passed = small || own <= result.limit;
  return result;
}

}
