// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SurfacePoint.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The corner (0, 1, 2) of the face at a vertex; NoId if the vertex is not in the face.
Id cornerWith(const TriangleMesh& mesh, Id face, Id vertex)
{
  const Triangle& corners = mesh.triangle(face);
  const auto corner = std::find(corners.begin(), corners.end(), vertex);
  return corner != corners.end() ? static_cast<Id>(corner - corners.begin()) : NoId;
}

/// A point of the surface: a corner of its face, and the ways from there along two edges.
struct FromCorner
{
  Vec3 corner;
  Vec3 first{};
  Vec3 second{};

  Vec3 offset() const { return this->first + this->second; }
};

FromCorner fromCorner(const TriangleMesh& mesh, const SurfacePoint& point)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return { mesh.point(point.id) };
  }
  if (point.kind == SurfacePoint::Kind::Edge)
  {
    const Vec3& origin = mesh.point(mesh.origin(point.id));
    return { origin, point.u * (mesh.point(mesh.destination(point.id)) - origin) };
  }
  const Triangle& corners = mesh.triangle(point.id);
  const Vec3& origin = mesh.point(corners[0]);
  return { origin, point.u * (mesh.point(corners[1]) - origin),
    point.v * (mesh.point(corners[2]) - origin) };
}

}

SurfacePoint fromBarycentric(const TriangleMesh& mesh, Id face, const Barycentric& coordinates)
{
  Barycentric weights;
  for (std::size_t k = 0; k < 3; ++k)
  {
    weights[k] = std::max(coordinates[k], 0.0);
  }
  const double sum = weights[0] + weights[1] + weights[2];
  const auto largest = std::max_element(weights.begin(), weights.end());
  if (*largest == sum) // rounding makes the others vanish
  {
    return SurfacePoint::atVertex(
      mesh.triangle(face)[static_cast<std::size_t>(largest - weights.begin())]);
  }
  const double u = weights[1] / sum;
  const double v = weights[2] / sum;
  // Corner 0's coordinate is stored as 1 - u - v: if rounding loses it there, it is zero.
  const std::array<bool, 3> isZero = { weights[0] == 0.0 || 1.0 - u - v <= 0.0, u == 0.0,
    v == 0.0 };

  const auto zero = std::find(isZero.begin(), isZero.end(), true);
  if (zero != isZero.end())
  {
    const auto begin = static_cast<std::size_t>(zero - isZero.begin() + 1) % 3;
    const double end = weights[(begin + 1) % 3];
    return placeOnHalfedge(
      mesh, TriangleMesh::halfedgeOf(face, begin), end / (weights[begin] + end));
  }
  return SurfacePoint::inFace(face, u, v);
}

SurfacePoint placeOnHalfedge(const TriangleMesh& mesh, Id halfedge, double fraction)
{
  return !(fraction > 0.0) ? SurfacePoint::atVertex(mesh.origin(halfedge))
    : !(fraction < 1.0)    ? SurfacePoint::atVertex(mesh.destination(halfedge))
                           : SurfacePoint::onEdge(halfedge, fraction);
}

SurfacePoint placeOnHalfedge(
  const TriangleMesh& mesh, Id halfedge, double fraction, double snapDistance)
{
  const double length = mesh.length(halfedge);
  return fraction * length <= snapDistance      ? SurfacePoint::atVertex(mesh.origin(halfedge))
    : (1.0 - fraction) * length <= snapDistance ? SurfacePoint::atVertex(mesh.destination(halfedge))
                                                : SurfacePoint::onEdge(halfedge, fraction);
}

SurfacePoint normalized(const TriangleMesh& mesh, const SurfacePoint& point)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return point;
  }
  const Id face = someFace(mesh, point);
  return fromBarycentric(mesh, face, barycentric(mesh, point, face));
}

Barycentric barycentric(const TriangleMesh& mesh, const SurfacePoint& point, Id face)
{
  Barycentric result = { 0.0, 0.0, 0.0 };
  switch (point.kind)
  {
    case SurfacePoint::Kind::Vertex:
      result[cornerWith(mesh, face, point.id)] = 1.0;
      break;
    case SurfacePoint::Kind::Edge:
      // By vertex, as the halfedges of an edge may run in either direction.
      result[cornerWith(mesh, face, mesh.origin(point.id))] = 1.0 - point.u;
      result[cornerWith(mesh, face, mesh.destination(point.id))] = point.u;
      break;
    case SurfacePoint::Kind::Face:
      result = { 1.0 - point.u - point.v, point.u, point.v };
      break;
  }
  return result;
}

Vec2 inHalfedgeFrame(const TriangleMesh& mesh, Id halfedge, const SurfacePoint& point)
{
  return inHalfedgeFrame(mesh, halfedge, barycentric(mesh, point, TriangleMesh::faceOf(halfedge)));
}

FacePoint toFacePoint(const TriangleMesh& mesh, Id face, const SurfacePoint& point)
{
  const Id corner = point.kind == SurfacePoint::Kind::Vertex ? cornerWith(mesh, face, point.id)
                                                             : TriangleMesh::indexInFace(point.id);
  return { point.kind, corner, point.u, point.v };
}

SurfacePoint fromFacePoint(const TriangleMesh& mesh, Id face, const FacePoint& point)
{
  const Id id = point.kind == SurfacePoint::Kind::Vertex ? mesh.triangle(face)[point.corner]
    : point.kind == SurfacePoint::Kind::Edge ? TriangleMesh::halfedgeOf(face, point.corner)
                                             : face;
  return { point.kind, id, point.u, point.v };
}

bool contains(const TriangleMesh& mesh, Id face, const SurfacePoint& point)
{
  switch (point.kind)
  {
    case SurfacePoint::Kind::Vertex:
      return cornerWith(mesh, face, point.id) != NoId;
    case SurfacePoint::Kind::Edge:
      return cornerWith(mesh, face, mesh.origin(point.id)) != NoId &&
        cornerWith(mesh, face, mesh.destination(point.id)) != NoId;
    case SurfacePoint::Kind::Face:
      break;
  }
  return face == point.id;
}

Id someFace(const TriangleMesh& mesh, const SurfacePoint& point)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    const IdRange corners = mesh.cornersAt(point.id);
    return corners.size() == 0 ? NoId : TriangleMesh::faceOf(*corners.begin());
  }
  return point.kind == SurfacePoint::Kind::Edge ? TriangleMesh::faceOf(point.id) : point.id;
}

Id commonFace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  Id lowest = NoId;
  forEachFace(mesh, a,
    [&](Id face)
    {
      if (face < lowest && contains(mesh, face, b))
      {
        lowest = face;
      }
    });
  return lowest;
}

bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  if (a.kind != SurfacePoint::Kind::Edge || b.kind != SurfacePoint::Kind::Edge)
  {
    return a.members() == b.members();
  }
  return mesh.edgeOf(a.id) == mesh.edgeOf(b.id) &&
    (mesh.origin(a.id) == mesh.origin(b.id) ? a.u == b.u
                                            : std::abs(a.u - (1.0 - b.u)) <= tolerance::Rounding);
}

double distanceInSpace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  const FromCorner first = fromCorner(mesh, a);
  const FromCorner second = fromCorner(mesh, b);
  return norm((second.corner - first.corner) + (second.offset() - first.offset()));
}

double distanceInSpace(const TriangleMesh& mesh, const Vec3& place, const SurfacePoint& point)
{
  const FromCorner there = fromCorner(mesh, point);
  return norm((there.corner - place) + there.offset());
}

Vec3 position(const TriangleMesh& mesh, const SurfacePoint& point)
{
  const FromCorner there = fromCorner(mesh, point);
  return point.kind == SurfacePoint::Kind::Vertex ? there.corner
                                                  : there.corner + there.first + there.second;
}

}
