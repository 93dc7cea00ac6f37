// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IncomingSegment_h
#define geodesic_IncomingSegment_h

#include "field/WaysIntoFace.h"

namespace geodesic
{

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
  FaceDirection ray;
  /// The corner (MeshPartition::globalId()) or the window's origin (Window::origin). Of a window
  /// also the start of the ray (Window::startOf()), the ray in the frame of the window's halfedge,
  /// and where it crosses the halfedge, and in which direction.
  RayOrigin origin = {};
  RayStart start = {};
  Vec2 rayOfWindow = {};
  double x = 0.0;
  Vec2 atX = {};
  /// The corner; NoId if the piece does not come from one.
  Id corner = NoId;
  /// The source, and how far along it the piece begins: nearestAlongSource().
  SourceInFace source;
  double along = 0.0;
};

/// \param field with arrivals (FrontOptions::keepArrivals) and, unless the point is a vertex, with
///        the windows of a face around the point.
/// \throws Error where these were not kept.
IncomingSegment incomingSegmentTo(const DistanceField& field, const SurfacePoint& point);

/// The same through this rank's faces around the point: of a point beside a corner the piece may
/// have no length.
IncomingSegment incomingSegmentThrough(const DistanceField& field, const SurfacePoint& point);

/// The gradient of the distance at a point whose shortest path ends with this piece: a unit vector
/// in the plane of the face that the path comes through; zero on the source and if there is no
/// piece.
Vec3 gradientOf(const TriangleMesh& mesh, const IncomingSegment& piece);

}

#endif
