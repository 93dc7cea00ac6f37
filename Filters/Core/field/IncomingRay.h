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

/// Whether the ray's direction is one in space: the halfedge's face has a plane, or the ray runs
/// along the halfedge.
bool isInSpace(const TriangleMesh& mesh, const IncomingRay& ray);

/// The same ray in the next face at the edge of the halfedge.
IncomingRay acrossEdge(const TriangleMesh& mesh, const IncomingRay& ray);

/// Follows the ray back from its end to the first face in which its direction is one in space. If
/// the way back ends at the boundary, or goes in a circle of faces without area, the result is the
/// ray as it enters the last of these faces.
IncomingRay backToDirectionInSpace(const TriangleMesh& mesh, IncomingRay ray);

}

#endif
