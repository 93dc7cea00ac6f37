// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceInFace_h
#define geodesic_SourceInFace_h

#include "mesh/HalfedgeFrame.h"

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
