// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/HalfedgeFrame.h"

#include <algorithm>

namespace geodesic
{

Vec2 inHalfedgeFrame(const TriangleMesh& mesh, Id halfedge, const Barycentric& point)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  const std::size_t k = TriangleMesh::indexInFace(halfedge);
  const std::size_t next = (k + 1) % 3;
  const std::size_t previous = (k + 2) % 3;
  const double length = shape.length[k];
  if (length == 0.0)
  {
    return { 0.0, point[previous] * shape.length[next] };
  }
  return { point[next] * length + point[previous] * shape.cornerDot[k] / length,
    point[previous] * shape.area2 / length };
}

Vec2 wayInFrame(
  const TriangleMesh& mesh, Id halfedge, const Barycentric& from, const Barycentric& to)
{
  Barycentric way;
  for (std::size_t k = 0; k < 3; ++k)
  {
    way[k] = to[k] - from[k];
  }
  const auto largest =
    static_cast<std::size_t>(std::max_element(to.begin(), to.end()) - to.begin());
  way[largest] = -way[(largest + 1) % 3] - way[(largest + 2) % 3];
  return inHalfedgeFrame(mesh, halfedge, way);
}

Barycentric fromHalfedgeFrame(const TriangleMesh& mesh, Id halfedge, Vec2 point)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  const std::size_t k = TriangleMesh::indexInFace(halfedge);
  const double length = shape.length[k];
  Barycentric weights{};
  if (length > 0.0)
  {
    const double height = shape.area2 / length;
    const double atApex = height > 0.0 ? point.y / height : 0.0;
    weights[(k + 2) % 3] = atApex;
    weights[(k + 1) % 3] = (point.x - atApex * shape.cornerDot[k] / length) / length;
  }
  weights[k] = 1.0 - weights[(k + 1) % 3] - weights[(k + 2) % 3];
  return weights;
}

// Rotates by the cosine and the sine of the angle between the two halfedges.
Vec2 turned(const TriangleMesh& mesh, Vec2 direction, Id fromHalfedge, Id toHalfedge)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(fromHalfedge));
  const std::size_t from = TriangleMesh::indexInFace(fromHalfedge);
  const std::size_t to = TriangleMesh::indexInFace(toHalfedge);
  const double scale = shape.length[from] * shape.length[to];
  if (from == to || !(scale > 0.0))
  {
    return direction;
  }
  const bool isNext = from == (to + 1) % 3;
  const Vec2 axis = { -shape.cornerDot[isNext ? from : to] / scale,
    (isNext ? shape.area2 : -shape.area2) / scale };
  return { direction.x * axis.x - direction.y * axis.y,
    direction.x * axis.y + direction.y * axis.x };
}

Id longestHalfedge(const TriangleMesh& mesh, Id face)
{
  return TriangleMesh::halfedgeOf(face, mesh.shape(face).longestEdge());
}

double distanceInFace(const TriangleMesh& mesh, Id face, const Barycentric& a, const Barycentric& b)
{
  const Id halfedge = longestHalfedge(mesh, face);
  return norm(inHalfedgeFrame(mesh, halfedge, a) - inHalfedgeFrame(mesh, halfedge, b));
}

Vec3 inSpace(const TriangleMesh& mesh, Id halfedge, Vec2 direction)
{
  const Vec3& origin = mesh.point(mesh.origin(halfedge));
  const double length = mesh.length(halfedge);
  const double size = norm(direction);
  if (!(length > 0.0) || !(size > 0.0))
  {
    return {};
  }
  const Vec3 x = (1.0 / length) * (mesh.point(mesh.destination(halfedge)) - origin);
  const Vec2 apex = apexOf(mesh, halfedge);
  Vec3 result = (direction.x / size) * x;
  if (apex.y > 0.0)
  {
    const Vec3 y = (1.0 / apex.y) * (mesh.point(mesh.opposite(halfedge)) - origin - apex.x * x);
    result = result + (direction.y / size) * y;
  }
  const double unit = norm(result);
  return unit > 0.0 ? (1.0 / unit) * result : Vec3{};
}

}
