// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceInFace_h
#define geodesic_SourceInFace_h

#include "mesh/HalfedgeFrame.h"
#include "mesh/SurfacePoint.h"

namespace geodesic
{

/// A source inside a face: a segment, or a point if both ends are equal.
struct SourceInFace
{
  Id face = NoId;
  Barycentric a = {};
  Barycentric b = {};
  /// The number of its curve's chain (CurveChains), and the places of the ends along the chain.
  Id curve = 0;
  double placeOfA = 0.0;
  double placeOfB = 0.0;
};

/// Whether a segment from a to b of a face runs along its halfedge k.
inline bool runsAlong(std::size_t k, const Barycentric& a, const Barycentric& b)
{
  return a[(k + 2) % 3] == 0.0 && b[(k + 2) % 3] == 0.0;
}

/// Calls visit(Id face) for the face of a segment from p to q, or, if the segment runs along an
/// edge, for all faces at that edge.
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

/// Where along a segment (a at 0, b at 1) the point nearest to a given point of its face is, by
/// straight distance in the face.
double nearestAlongSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

/// The nearest point of the source.
Barycentric nearestOnSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

/// The distance to the nearest point of the source.
double distanceToSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

}

#endif
