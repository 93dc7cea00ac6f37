// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Arrival_h
#define geodesic_Arrival_h

#include "mesh/TriangleMesh.h"
#include "window/RayOrigin.h"

namespace geodesic
{

/// How a path arrives at a vertex. Its last straight segment runs through the face of `halfedge`,
/// which is opposite the vertex, from the point at x on that halfedge. If x is 0 or the halfedge's
/// length, the segment runs along an edge.
struct Arrival
{
  /// NoId if unknown, and if the segment comes from a source in a face at the vertex.
  Id halfedge = NoId;
  /// Where the segment begins, possibly some faces farther away: Window::origin.
  RayOrigin origin = {};
  double x = 0.0;
  /// The direction of the segment in the halfedge's frame, of any length; zero along an edge. If
  /// the vertex is close to the halfedge, the two points determine the direction badly.
  Vec2 direction = {};
  /// Where it starts there: Window::startOf().
  RayStart start = {};

  /// Whether an arrival is known. Without a halfedge the segment comes from a source in a face at
  /// the vertex.
  bool isKnown() const { return this->halfedge != NoId || this->origin.isKnown(); }
  /// Whether the segment came through a window, not along an edge or from a source in a face.
  bool isThroughWindow() const
  {
    return this->halfedge != NoId && (this->direction.x != 0.0 || this->direction.y != 0.0);
  }
};

/// Whether a path bends that comes along a ray and goes on along a way. It does not if both have
/// one direction but for the rounding of places in a face with this longest edge. A ray as short as
/// that rounding has no direction: such a path is taken for bent.
bool bends(Vec2 ray, Vec2 way, double longest);

/// Whether the segment of an arrival through a window does not run along the window's ray: the path
/// bends at the end of the window.
bool isBent(const TriangleMesh& mesh, const Arrival& arrival);

}

#endif
