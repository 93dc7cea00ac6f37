// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceInFace_h
#define geodesic_SourceInFace_h

#include "mesh/HalfedgeFrame.h"
#include "source/SourceCurve.h"

#include <vector>

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

/// The segments of a curve in their order, each in its face or, if it runs along an edge, in all
/// faces at that edge.
///
/// \param number of the curve.
/// \param places the places of its points.
std::vector<SourceInFace> segmentsInFaces(
  const TriangleMesh& mesh, const SourceCurve& curve, Id number, const std::vector<double>& places);

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
