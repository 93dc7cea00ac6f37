// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/CutEdges.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

// The halfedge along which an edge runs, by where its origin and its apex lie, as ranks have faces
// in another order than one process. If two apexes are at one place, their order decides.
//
// \param first of the edge (TriangleMesh::edgeOf).
Id directionOf(const TriangleMesh& mesh, Id first)
{
  const auto key = [&mesh](Id h)
  { return std::pair(mesh.point(mesh.origin(h)), mesh.point(mesh.opposite(h))); };
  Id least = first;
  for (Id s = mesh.nextSibling(first); s != first; s = mesh.nextSibling(s))
  {
    least = key(s) < key(least) ? s : least;
  }
  return least;
}

} // anonymous namespace

Id CutEdges::ensure(Id halfedge)
{
  const Id first = this->mesh_.edgeOf(halfedge);
  const auto [found, isNew] = this->numbers_.emplace(first, this->size());
  if (isNew)
  {
    const Id along = directionOf(this->mesh_, first);
    this->edges_.push_back({ along, {}, { Deviation::unknown() } });
  }
  return found->second;
}

std::vector<Id> CutEdges::pointsAlong(Id halfedge) const
{
  const auto found = this->numbers_.find(this->mesh_.edgeOf(halfedge));
  if (found == this->numbers_.end())
  {
    return {};
  }
  const CutEdge& edge = this->edges_[found->second];
  std::vector<Id> points = edge.points;
  if (this->mesh_.origin(edge.halfedge) != this->mesh_.origin(halfedge))
  {
    std::reverse(points.begin(), points.end());
  }
  return points;
}

SurfacePoint CutEdges::placeOf(Id number) const
{
  if (this->isVertex(number))
  {
    return SurfacePoint::atVertex(number);
  }
  const PointOnEdge& on = this->point(number);
  return SurfacePoint::onEdge(this->edges_[on.edge].halfedge, on.at);
}

Id CutEdges::endOfPiece(Id edge, Id end) const
{
  const CutEdge& e = this->edges_[edge];
  return end == 0               ? this->mesh_.origin(e.halfedge)
    : end == e.numberOfPieces() ? this->mesh_.destination(e.halfedge)
                                : e.points[end - 1];
}

double CutEdges::placeOfEnd(Id edge, Id end) const
{
  const CutEdge& e = this->edges_[edge];
  return end == 0 ? 0.0 : end == e.numberOfPieces() ? 1.0 : this->point(e.points[end - 1]).at;
}

double CutEdges::lengthOfPiece(Id edge, Id piece) const
{
  return (this->placeOfEnd(edge, piece + 1) - this->placeOfEnd(edge, piece)) *
    this->mesh_.length(this->edges_[edge].halfedge);
}

Id CutEdges::pieceAt(Id edge, double at) const
{
  const std::vector<Id>& points = this->edges_[edge].points;
  const auto behind = std::upper_bound(points.begin(), points.end(), at,
    [this](double place, Id point) { return place < this->point(point).at; });
  return static_cast<Id>(behind - points.begin());
}

void CutEdges::split(const EdgeSplit& split)
{
  const Id edge = split.edge;
  CutEdge& e = this->edges_[edge];
  const double from = this->placeOfEnd(edge, split.piece);
  const double to = this->placeOfEnd(edge, split.piece + 1);
  const Id number = this->firstPoint_ + static_cast<Id>(this->points_.size());
  this->points_.push_back({ edge, from + split.weight * (to - from), split.distance,
    { this->endOfPiece(edge, split.piece), this->endOfPiece(edge, split.piece + 1) }, split.weight,
    split.reason == SplitReason::Shape });
  const auto piece = static_cast<std::ptrdiff_t>(split.piece);
  e.points.insert(e.points.begin() + piece, number);
  e.pieces[split.piece] = Deviation::unknown();
  e.pieces.insert(e.pieces.begin() + piece, Deviation::unknown());
}

}
