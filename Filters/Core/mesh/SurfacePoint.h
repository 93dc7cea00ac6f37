// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfacePoint_h
#define geodesic_SurfacePoint_h

#include "mesh/HalfedgeFrame.h"

#include <tuple>

namespace geodesic
{

/// A point of the surface: a vertex, a point inside an edge, or a point inside a face. Sources,
/// queries and paths all use it. Its kind states where a point lies; coordinates are never compared
/// to find out.
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

  /// To compare points bit by bit; see samePlace().
  auto members() const { return std::tie(this->kind, this->id, this->u, this->v); }

  static SurfacePoint atVertex(Id vertex) { return { Kind::Vertex, vertex, 0.0, 0.0 }; }
  static SurfacePoint onEdge(Id halfedge, double fraction)
  {
    return { Kind::Edge, halfedge, fraction, 0.0 };
  }
  static SurfacePoint inFace(Id face, double u, double v) { return { Kind::Face, face, u, v }; }
};

/// The point of a face with these barycentric coordinates (of its corners 0, 1, 2; their sum may
/// differ from one): a vertex or edge point if coordinates are zero.
SurfacePoint fromBarycentric(const TriangleMesh& mesh, Id face, const Barycentric& coordinates);

/// The same point with the kind that matches its coordinates: a face point with a coordinate that
/// is zero (or negative, by rounding) lies on an edge, an edge point at 0 or 1 is a vertex.
SurfacePoint normalized(const TriangleMesh& mesh, const SurfacePoint& point);

/// The point at a fraction of the way along a halfedge; a vertex where the fraction is 0 or 1, or
/// beyond by rounding.
SurfacePoint placeOnHalfedge(const TriangleMesh& mesh, Id halfedge, double fraction);
/// The same, but a vertex already where the point is no farther from it than the distance for
/// snapping.
SurfacePoint placeOnHalfedge(
  const TriangleMesh& mesh, Id halfedge, double fraction, double snapDistance);

/// Barycentric coordinates of the point in a face that contains it, see contains().
Barycentric barycentric(const TriangleMesh& mesh, const SurfacePoint& point, Id face);

/// The point in the frame of a halfedge of a face that contains it.
Vec2 inHalfedgeFrame(const TriangleMesh& mesh, Id halfedge, const SurfacePoint& point);

/// A point by the corners of a face that contains it. Ranks send points in this form: it is the
/// same on every mesh that has the face.
struct FacePoint
{
  SurfacePoint::Kind kind;
  /// The corner at the point or at the beginning of its halfedge; unused inside the face.
  Id corner;
  /// As SurfacePoint's.
  double u;
  double v;
};

/// \param point of the face; one on an edge names a halfedge of the face.
FacePoint toFacePoint(const TriangleMesh& mesh, Id face, const SurfacePoint& point);
SurfacePoint fromFacePoint(const TriangleMesh& mesh, Id face, const FacePoint& point);

/// Whether the point lies in the (closed) face.
bool contains(const TriangleMesh& mesh, Id face, const SurfacePoint& point);

/// One face that contains the point; NoId for an isolated vertex.
Id someFace(const TriangleMesh& mesh, const SurfacePoint& point);

/// Calls visit(face) once for every face that contains the point.
template <typename Visitor>
void forEachFace(const TriangleMesh& mesh, const SurfacePoint& point, Visitor&& visit)
{
  switch (point.kind)
  {
    case SurfacePoint::Kind::Vertex:
      for (const Id corner : mesh.cornersAt(point.id))
      {
        visit(TriangleMesh::faceOf(corner));
      }
      break;
    case SurfacePoint::Kind::Edge:
    {
      Id halfedge = point.id;
      do
      {
        visit(TriangleMesh::faceOf(halfedge));
        halfedge = mesh.nextSibling(halfedge);
      } while (halfedge != point.id);
      break;
    }
    case SurfacePoint::Kind::Face:
      visit(point.id);
      break;
  }
}

/// The lowest-numbered face that contains both points; NoId if there is none.
Id commonFace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// Whether two points are the same by kind, element and coordinates. An edge point is the same from
/// every halfedge of its edge, up to rounding of 1 - u.
bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// Coordinates in space. Use distanceInSpace() to measure: far from the origin the rounding of
/// coordinates is not small compared to a face.
Vec3 position(const TriangleMesh& mesh, const SurfacePoint& point);

/// The straight distance in space between two points, or between a place in space and a point. It
/// is measured from corners of the points' faces, so the position of the origin does not matter.
double distanceInSpace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);
double distanceInSpace(const TriangleMesh& mesh, const Vec3& place, const SurfacePoint& point);

}

#endif
