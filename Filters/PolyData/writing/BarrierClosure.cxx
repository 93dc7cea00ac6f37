// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/BarrierClosure.h"

#include "PolyData/writing/GlobalFaces.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// A face at the edge counts it, where it is owned.
std::unordered_map<Id, Id> barriersAtEdgesOfPieces(const PolyDataSurface& surface)
{
  std::vector<Triangle> edges;
  for (const Id triangle : surface.barrierTriangles())
  {
    const Triangle vertices = surface.verticesOf(surface.triangle(triangle));
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges.push_back(GlobalFaces::edge(vertices[k], vertices[(k + 1) % 3]));
    }
  }
  const GlobalFaces faces(surface);
  const std::vector<FaceOfWhole> found = faces.find(edges);
  Exchange& exchange = surface.partition().exchange();
  std::vector<Message> messages = exchange.noMessages();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i].isThere())
    {
      put(messages[rankIndex(found[i].address.rank)],
        3 * found[i].address.id + found[i].edgeOn(faces.numbersOf(edges[i])));
    }
  }
  std::unordered_map<Id, Id> count;
  readEach(exchange.step(std::move(messages)),
    [&](int, MessageReader& reader) { ++count[surface.mesh().edgeOf(reader.get<Id>())]; });
  return count;
}

} // anonymous namespace

std::unordered_map<Id, Id> barriersAtEdges(const PolyDataSurface& surface)
{
  if (surface.barriersOnRanks())
  {
    return barriersAtEdgesOfPieces(surface);
  }
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
  SplitTriangle{ triangle, splits, [this](Id point) { return this->position(point); } }.cut(
    triangles);
}

Vec3 BarrierClosure::position(Id point) const
{
  const Id inputPoints = this->refined_.numberOfInputPoints;
  return point < inputPoints ? this->surface_.mesh().point(this->surface_.vertexOf(point))
                             : this->refined_.points[point - inputPoints].position;
}

}
