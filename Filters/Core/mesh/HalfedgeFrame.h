// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_HalfedgeFrame_h
#define geodesic_HalfedgeFrame_h

#include "mesh/TriangleMesh.h"

namespace geodesic
{

/// Barycentric coordinates of a point of a face.
using Barycentric = std::array<double, 3>;

/// The barycentric coordinates of corner k.
inline Barycentric cornerWeights(std::size_t k)
{
  Barycentric weights{};
  weights[k] = 1.0;
  return weights;
}

/// The point at a fraction t of the way from a to b.
inline Barycentric between(const Barycentric& a, const Barycentric& b, double t)
{
  Barycentric point;
  for (std::size_t k = 0; k < 3; ++k)
  {
    point[k] = (1.0 - t) * a[k] + t * b[k];
  }
  return point;
}

/// A point of a face in the frame of one of its halfedges: the halfedge lies along the x axis from
/// its origin, the face above it.
Vec2 inHalfedgeFrame(const TriangleMesh& mesh, Id halfedge, const Barycentric& point);

/// The way from one point of a face to another in that frame. It has relative precision near a
/// corner, as it does not use the corner's weight, which is close to 1 there.
Vec2 wayInFrame(
  const TriangleMesh& mesh, Id halfedge, const Barycentric& from, const Barycentric& to);

/// The inverse of inHalfedgeFrame(): the coordinates of a point of the plane, some of which are
/// negative outside of the face. In a face without height, the coordinates of the nearest point on
/// the halfedge's line.
Barycentric fromHalfedgeFrame(const TriangleMesh& mesh, Id halfedge, Vec2 point);

/// The apex in that frame: the vertex opposite the halfedge, whose length must not be 0.
inline Vec2 apexOf(const TriangleMesh& mesh, Id halfedge)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  const std::size_t k = TriangleMesh::indexInFace(halfedge);
  const double length = shape.length[k];
  return { shape.cornerDot[k] / length, shape.area2 / length };
}

/// A direction in the frame of another halfedge of the same face.
Vec2 turned(const TriangleMesh& mesh, Vec2 direction, Id fromHalfedge, Id toHalfedge);

/// A direction in a face: in the frame of one of its halfedges.
struct FaceDirection
{
  Id halfedge = NoId;
  Vec2 vector = {};
};
inline Vec2 turned(const TriangleMesh& mesh, const FaceDirection& direction, Id toHalfedge)
{
  return turned(mesh, direction.vector, direction.halfedge, toHalfedge);
}

/// The direction in the frame of another halfedge of the edge, whose face is laid out behind it.
inline FaceDirection acrossEdge(const TriangleMesh& mesh, const FaceDirection& from, Id sibling)
{
  const bool isOpposed = mesh.origin(sibling) == mesh.destination(from.halfedge);
  return { sibling, { isOpposed ? -from.vector.x : from.vector.x, -from.vector.y } };
}

/// A direction in the frame of a halfedge as a unit vector in space; zero where it has no length.
Vec3 inSpace(const TriangleMesh& mesh, Id halfedge, Vec2 direction);

Id longestHalfedge(const TriangleMesh& mesh, Id face);

/// The straight distance within a face.
double distanceInFace(
  const TriangleMesh& mesh, Id face, const Barycentric& a, const Barycentric& b);

}

#endif
