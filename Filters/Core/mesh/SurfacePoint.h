// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfacePoint_h
#define geodesic_SurfacePoint_h

#include "Types.h"

namespace geodesic
{

class TriangleMesh;

/// A point of the surface: a vertex, a point inside an edge, or a point inside a face. Sources,
/// queries and paths all use it. What a point is follows from its kind, never from comparing
/// coordinates.
struct SurfacePoint
{
  enum class Kind : std::uint8_t
  {
    Vertex,
    Edge,
    Face
  };

  Kind kind = Kind::Vertex;
  /// The vertex, one halfedge of the edge (3 * face + k, from corner k to corner k + 1), or the
  /// face.
  Id id = NoId;
  /// Edge: the fraction of the way along the halfedge, in (0, 1). Face: the barycentric coordinate
  /// of corner 1.
  double u = 0.0;
  /// Face: the barycentric coordinate of corner 2; corner 0 has 1 - u - v.
  double v = 0.0;

  static SurfacePoint atVertex(Id vertex) { return { Kind::Vertex, vertex, 0.0, 0.0 }; }
  static SurfacePoint onEdge(Id halfedge, double fraction)
  {
    return { Kind::Edge, halfedge, fraction, 0.0 };
  }
  static SurfacePoint inFace(Id face, double u, double v) { return { Kind::Face, face, u, v }; }
};

/// The point of a face with these barycentric coordinates (of its corners 0, 1, 2; they need not
/// sum to one exactly): a vertex or edge point where coordinates are zero. A face without area has
/// no inside: its points lie on its longest edge.
SurfacePoint fromBarycentric(
  const TriangleMesh& mesh, Id face, const std::array<double, 3>& coordinates);

/// The same point with the kind that its coordinates ask for: a face point with a coordinate that
/// is zero (or below, by rounding) lies on an edge, an edge point at 0 or 1 is a vertex.
SurfacePoint normalized(const TriangleMesh& mesh, const SurfacePoint& point);

/// Barycentric coordinates of the point in a face that holds it. The point must lie in the face,
/// see contains().
std::array<double, 3> barycentric(const TriangleMesh& mesh, const SurfacePoint& point, Id face);

/// Whether the point lies in the (closed) face.
bool contains(const TriangleMesh& mesh, Id face, const SurfacePoint& point);

/// One face that holds the point; NoId for an isolated vertex.
Id someFace(const TriangleMesh& mesh, const SurfacePoint& point);

/// Calls visit(face) for every face that holds the point, each once.
template <typename Visitor>
void forEachFace(const TriangleMesh& mesh, const SurfacePoint& point, Visitor&& visit);

/// The lowest-numbered face that holds both points; NoId where there is none.
Id commonFace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// Whether two points are the same place of the surface by kind, element and coordinates (an edge
/// point is the same from every halfedge of its edge, up to rounding of 1 - u).
bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// Coordinates in space. What is measured between points is measured by distanceInSpace(): far from
/// the origin the rounding of coordinates is no longer small beside a face.
Vec3 position(const TriangleMesh& mesh, const SurfacePoint& point);

/// The straight distance in space between two points, or from a place to a point. Measured from
/// corners of the points' faces, so that it does not depend on where the origin is.
double distanceInSpace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);
double distanceInSpace(const TriangleMesh& mesh, const Vec3& place, const SurfacePoint& point);

}

#include "mesh/SurfacePoint.txx"

#endif
