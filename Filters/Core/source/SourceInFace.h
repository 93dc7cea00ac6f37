// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceInFace_h
#define geodesic_SourceInFace_h

#include "mesh/HalfedgeFrame.h"

namespace geodesic
{

/// A segment of a source that lies in a face, or a point where both ends are the same.
struct SourceInFace
{
  Id face;
  Barycentric a;
  Barycentric b;
};

/// The source's point that is nearest to a point of its face, by straight distance in the face.
Barycentric nearestOnSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

/// That distance.
double distanceToSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

}

#endif
