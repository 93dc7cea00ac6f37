// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/BarrierClosure.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

std::unordered_map<Id, Id> barriersAtEdges(const PolyDataSurface& surface)
{
  std::unordered_map<Id, Id> count;
  for (const Id triangle : surface.barrierTriangles())
  {
    const Triangle vertices = surface.verticesOf(surface.triangle(triangle));
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id halfedge = surface.mesh().halfedgeBetween(vertices[k], vertices[(k + 1) % 3]);
      if (halfedge != NoId)
      {
        ++count[surface.mesh().edgeOf(halfedge)];
      }
    }
  }
  return count;
}

BarrierClosure::BarrierClosure(
  const PolyDataSurface& surface, RefinedMesh& refined, TrianglePoints& points)
  : surface_(surface)
  , refined_(refined)
  , points_(points)
{
  for (const auto& [edge, count] : barriersAtEdges(surface))
  {
    this->splits_[edge];
  }
  if (this->splits_.empty())
  {
    return;
  }
  const TriangleMesh& mesh = surface.mesh();
  for (std::size_t i = 0; i < refined.points.size(); ++i)
  {
    const SurfacePoint& place = refined.points[i].place;
    const auto rim = place.kind == SurfacePoint::Kind::Edge
      ? this->splits_.find(mesh.edgeOf(place.id))
      : this->splits_.end();
    if (rim != this->splits_.end())
    {
      rim->second.push_back(refined.numberOfInputPoints + static_cast<Id>(i));
    }
  }
  const auto along = [&](Id point)
  { return refined.points[point - refined.numberOfInputPoints].place.u; };
  for (auto& [edge, splits] : this->splits_)
  {
    // Where faces around the edge have points of their own there are several in one place.
    std::stable_sort(splits.begin(), splits.end(), [&](Id a, Id b) { return along(a) < along(b); });
    splits.erase(
      std::unique(splits.begin(), splits.end(), [&](Id a, Id b) { return along(a) == along(b); }),
      splits.end());
  }
}

const BarrierClosure::Splits* BarrierClosure::splitsBetween(Id a, Id b) const
{
  const Id halfedge = this->surface_.mesh().halfedgeBetween(a, b);
  const auto rim = halfedge == NoId ? this->splits_.end()
                                    : this->splits_.find(this->surface_.mesh().edgeOf(halfedge));
  return rim == this->splits_.end() ? nullptr : &rim->second;
}

Id BarrierClosure::count(const Triangle& triangle) const
{
  const Triangle vertices = this->surface_.verticesOf(triangle);
  std::size_t count = 1;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Splits* splits = this->splitsBetween(vertices[k], vertices[(k + 1) % 3]);
    count += splits ? splits->size() : 0;
  }
  return static_cast<Id>(count);
}

/// From corner k to corner k + 1, as the triangle's own points.
BarrierClosure::Splits BarrierClosure::splitsAlong(const Triangle& triangle, std::size_t k)
{
  const Id from = this->surface_.vertexOf(triangle[k]);
  const Id to = this->surface_.vertexOf(triangle[(k + 1) % 3]);
  const Splits* known = this->splitsBetween(from, to);
  Splits splits;
  if (known)
  {
    for (const Id point : *known)
    {
      splits.push_back(this->points_.like(point));
    }
    const TriangleMesh& mesh = this->surface_.mesh();
    if (mesh.origin(mesh.edgeOf(mesh.halfedgeBetween(from, to))) != from)
    {
      std::reverse(splits.begin(), splits.end());
    }
  }
  return splits;
}

void BarrierClosure::close(const Triangle& triangle, std::vector<Triangle>& triangles)
{
  this->points_.begin(triangle);
  std::array<Splits, 3> splits;
  for (std::size_t k = 0; k < 3; ++k)
  {
    splits[k] = this->splitsAlong(triangle, k);
  }
  this->cut(triangle, splits, triangles);
}

Vec3 BarrierClosure::position(Id point) const
{
  const Id inputPoints = this->refined_.numberOfInputPoints;
  return point < inputPoints ? this->surface_.mesh().point(this->surface_.vertexOf(point))
                             : this->refined_.points[point - inputPoints].position;
}

/// The longest that has splits, for the shapes; 3 where none has. Of equally long ones that which
/// any order of the corners gives, so that copies of a barrier are cut as it is.
std::size_t BarrierClosure::edgeToCut(
  const Triangle& corners, const std::array<Splits, 3>& splits) const
{
  std::size_t best = 3;
  std::pair<double, Vec3> order;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!splits[k].empty())
    {
      const Vec3 from = this->position(corners[k]);
      const Vec3 to = this->position(corners[(k + 1) % 3]);
      const std::pair<double, Vec3> own(norm(to - from), this->position(corners[(k + 2) % 3]));
      if (best == 3 || own > order)
      {
        best = k;
        order = own;
      }
    }
  }
  return best;
}

void BarrierClosure::cut(const Triangle& corners, const std::array<Splits, 3>& splits,
  std::vector<Triangle>& triangles) const
{
  const std::size_t k = this->edgeToCut(corners, splits);
  if (k == 3)
  {
    triangles.push_back(corners);
    return;
  }
  const std::size_t next = (k + 1) % 3;
  const std::size_t previous = (k + 2) % 3;
  // The middle one from either end.
  const std::size_t count = splits[k].size();
  const bool isForward = this->position(corners[k]) < this->position(corners[next]);
  const auto middle = static_cast<std::ptrdiff_t>(isForward ? (count - 1) / 2 : count / 2);
  const auto at = splits[k].begin() + middle;
  this->cut({ corners[k], *at, corners[previous] },
    { Splits(splits[k].begin(), at), {}, splits[previous] }, triangles);
  this->cut({ *at, corners[next], corners[previous] },
    { Splits(at + 1, splits[k].end()), splits[next], {} }, triangles);
}

}
