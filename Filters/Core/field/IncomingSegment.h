// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IncomingSegment_h
#define geodesic_IncomingSegment_h

#include "field/WaysIntoFace.h"

namespace geodesic
{

/// A direction in a face, of any length, in the frame of one of the face's halfedges.
struct IncomingRay
{
  Id halfedge = NoId;
  Vec2 direction = {};
};

/// The last straight piece of a shortest path to a point of the surface. If there are several
/// shortest paths, it is that of one of them.
struct IncomingSegment
{
  /// None: the point was not reached, or there is no piece: a vertex on the source.
  using Kind = WayIntoFace::Kind;

  Kind kind = Kind::None;
  double distance = Infinity;
  /// The direction in which the path comes to the point; zero if the piece has no length. The
  /// halfedge is one of the last face on the path.
  IncomingRay ray;
  /// The corner (MeshPartition::globalId()) or the window's origin (Window::origin). Of a window
  /// also the start of the ray (Window::startOf()), and the ray in the frame of the window's
  /// halfedge.
  RayOrigin origin = {};
  RayStart start = {};
  Vec2 rayOfWindow = {};
  /// The source, and how far along it the piece begins: nearestAlongSource().
  SourceInFace source;
  double along = 0.0;
};

/// \param field with arrivals (FrontOptions::keepArrivals) and, unless the point is a vertex, with
///        the windows of a face around the point.
/// \throws Error where these were not kept.
IncomingSegment incomingSegmentTo(const DistanceField& field, const SurfacePoint& point);

/// The way from x on a halfedge to a point p of its face, of a path that crosses the halfedge along
/// a ray.
struct WayFrom
{
  /// Whether the path bends at x, as at a corner where a window ends, or begins there.
  bool isBent = false;
  /// The direction in which the path comes to p: that of the ray, unless the path bends or the ray
  /// is far shorter than the way from x to p.
  Vec2 direction = {};
  /// The ray's own direction, better known if the ray is as short.
  Vec2 ray = {};
};

/// \param longest edge of the face.
WayFrom wayFrom(double x, Vec2 p, Vec2 ray, double longest);

/// The end of the arrival's halfedge at which the path crosses it, but for rounding; NoId if it
/// crosses between the ends.
Id cornerCrossed(const TriangleMesh& mesh, const Arrival& arrival);

/// The gradient of the distance at a point whose shortest path ends with this piece: a unit vector
/// in the plane of the face that the path comes through; zero on the source and if there is no
/// piece.
Vec3 gradientOf(const TriangleMesh& mesh, const IncomingSegment& piece);

}

#endif
