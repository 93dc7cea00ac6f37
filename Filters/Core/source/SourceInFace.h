// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceInFace_h
#define geodesic_SourceInFace_h

#include "mesh/HalfedgeFrame.h"
#include "mesh/SurfacePoint.h"

namespace geodesic
{

/// A segment of a source that lies in a face, or a point where both ends are the same.
struct SourceInFace
{
  Id face = NoId;
  Barycentric a = {};
  Barycentric b = {};
  /// The number of the chain that its curve is in (CurveChains), and where along it the ends are.
  Id curve = 0;
  double placeOfA = 0.0;
  double placeOfB = 0.0;
};

/// Whether a segment from a to b of a face runs along its halfedge k.
inline bool runsAlong(std::size_t k, const Barycentric& a, const Barycentric& b)
{
  return a[(k + 2) % 3] == 0.0 && b[(k + 2) % 3] == 0.0;
}

/// Calls visit(Id face) for the face of a segment from p to q, and where it runs along an edge for
/// the other faces there: it is one of all of them.
template <typename Visit>
void forEachFaceOfSegment(
  const TriangleMesh& mesh, Id face, const SurfacePoint& p, const SurfacePoint& q, Visit&& visit)
{
  visit(face);
  const Barycentric a = barycentric(mesh, p, face);
  const Barycentric b = barycentric(mesh, q, face);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = 3 * face + static_cast<Id>(k);
    for (Id s = mesh.nextSibling(halfedge); runsAlong(k, a, b) && s != halfedge;
         s = mesh.nextSibling(s))
    {
      visit(TriangleMesh::faceOf(s));
    }
  }
}

/// How far along a segment, from a at 0 to b at 1, the point is that is nearest to a point of its
/// face, by straight distance in the face.
double nearestAlongSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

/// That point.
Barycentric nearestOnSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

/// The distance to it.
double distanceToSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

}

#endif
