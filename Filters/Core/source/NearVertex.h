// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NearVertex_h
#define geodesic_NearVertex_h

#include "mesh/HalfedgeFrame.h"

namespace geodesic
{

/// A vertex so near to a source's point that the point's windows, whose ends are rounded, cannot
/// represent the directions around it (tolerance::NearVertex).
struct NearVertex
{
  Id vertex = NoId;
  /// From the point.
  double distance = Infinity;
  /// The straight line from the vertex over the point meets this halfedge, opposite the vertex, at
  /// x. NoId if the faces around the vertex are no fan, or not far larger than the distance.
  Id halfedge = NoId;
  double x = 0.0;

  bool hasFan() const { return this->halfedge != NoId; }
};

/// \param corner at a vertex that is near the point.
/// \param point of the corner's face.
NearVertex nearVertexAt(const TriangleMesh& mesh, Id corner, const Barycentric& point);

/// The way from a corner to a point of its face, in the frame of the corner's first edge. Beside
/// the corner it has relative precision.
Vec2 fromCorner(const TriangleMesh& mesh, Id corner, const Barycentric& point);

}

#endif
