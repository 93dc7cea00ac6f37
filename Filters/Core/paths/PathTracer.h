// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathTracer_h
#define geodesic_PathTracer_h

#include "field/IncomingSegment.h"

#include <vector>

namespace geodesic
{

/// How far a path was followed, as one rank tells another.
struct PathState
{
  /// What to do next.
  enum class Next : std::uint8_t
  {
    /// Continue from the last point, which is a vertex or the first point.
    Point,
    /// Continue behind the exit.
    BehindExit,
    /// Find the face, of those around the last point on an edge, that the path comes through.
    Search,
    /// Nothing: the path is complete.
    End,
    /// Nothing: the path could not be followed to its end, or has become longer than the distance.
    /// It runs so close to vertices that rounding decides about its way. pathInWindows() finds it.
    Lost
  };

  /// The length from the last point to the source, the length of the whole path, and the length of
  /// the part that was followed.
  double left = 0.0;
  double whole = 0.0;
  double length = 0.0;
  /// The number of points added.
  std::uint64_t steps = 0;
  Next next = Next::Point;
  /// The halfedge through which the path leaves a face, and its ray behind that halfedge: a linear
  /// window without width in the leaving frame, whose x axis runs against the halfedge.
  Id exit = NoId;
  Window ray = {};
  /// The straight piece that the path is on.
  IncomingSegment piece;

  bool isOnItsWay() const { return this->next != Next::End && this->next != Next::Lost; }
};

/// A path as far as it was followed, from a point to the source: the point, a point on every edge
/// that it crosses, the vertices that it passes, its end on the source.
struct TracedPath : PathState
{
  /// The points, each with a face that holds it and the point before.
  std::vector<SurfacePoint> points;
  std::vector<Id> faces;
  /// Another rank's face where it continues. NoId if it is not on its way, or has to search around
  /// its last point (PathState::Next::Search) in faces of several ranks.
  Id elsewhere = NoId;
};

/// A path before its first step. If the point was not reached, it is complete and has no points.
TracedPath beginPath(const DistanceField& field, const SurfacePoint& from);

/// Follows a path until it is complete or lost, or as far as it goes through this rank's faces.
///
/// Between bends a shortest path is straight in the unfolding, and each vertex stores the direction
/// in which its own path arrives. So a path is followed as a ray, face by face, to the
/// pseudo-source where it bends, or to the source. Windows are needed in few faces only: around the
/// first point, and around edges of three and more faces, where they determine in which face the
/// path continues. RetentionAround keeps these.
///
/// \param field that was solved with FrontOptions::keepArrivals.
void followPath(const DistanceField& field, TracedPath& path);

/// Continues from a search (PathState::Next::Search) through the best of this rank's faces.
///
/// \returns the length of the path from the last point through these; infinite if there is none.
double continueOnThisRank(const DistanceField& field, TracedPath& path);

}

#endif
