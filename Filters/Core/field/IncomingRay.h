// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IncomingRay_h
#define geodesic_IncomingRay_h

#include "mesh/HalfedgeFrame.h"

namespace geodesic
{

/// The ray of a shortest path that crosses a halfedge.
struct IncomingRay
{
  Id halfedge = NoId;
  /// Whether it leaves the halfedge's face there. If not, it comes into the face.
  bool leaves = false;
  /// Where it crosses, and its direction of any length, in the halfedge's frame.
  double x = 0.0;
  Vec2 direction = {};
};

/// Whether a face has an area that is more than rounding of its corners, so that it has a plane.
bool hasPlane(const TriangleMesh& mesh, Id face);

/// Whether the ray's direction is one in space: where the halfedge's face has a plane, or where the
/// ray runs along the halfedge.
bool isInSpace(const TriangleMesh& mesh, const IncomingRay& ray);

/// The same ray in the next face at the edge of the halfedge.
IncomingRay acrossEdge(const TriangleMesh& mesh, const IncomingRay& ray);

/// The ray in the face nearest to its end, on the way back, in which its direction is one in space.
/// Where the boundary comes before, or the way back goes in a circle of faces without area, the ray
/// as it comes into the last of these.
IncomingRay backToDirectionInSpace(const TriangleMesh& mesh, IncomingRay ray);

}

#endif
