// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathTracer_h
#define geodesic_PathTracer_h

#include "Errors.h"
#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// A path that could not be followed to its end, or has come out longer than it is: it ran so close
/// to vertices that rounding has decided about its way. A field with all windows kept tells it.
class PathLost : public Error
{
public:
  using Error::Error;
};

/// Traces shortest paths of a field that was solved with FrontOptions::keepArrivals.
///
/// Between its bends a shortest path is straight in the unfolding, and each vertex remembers the
/// direction in which its own comes: so a path is followed as a ray, face by face, as far as the
/// pseudo-source that its windows left or the source. No windows are needed for that, save in the
/// faces of the point that the path begins at, and in those around edges of three and more faces,
/// where they tell in which one it goes on: RetentionAround keeps these.
class PathTracer
{
public:
  /// The field must outlive the tracer.
  explicit PathTracer(const DistanceField& field)
    : field_(field)
    , mesh_(field.mesh())
  {
  }

  /// The shortest path from a point to the source, one of them where there are several: the point,
  /// a point on every edge that it crosses, the vertices that it passes, its end on the source.
  /// Empty where the point was not reached. Thread-safe.
  ///
  /// \throws PathLost where the path cannot be followed, such as from a face whose windows were not
  ///         kept.
  std::vector<SurfacePoint> trace(const SurfacePoint& from) const;

private:
  /// A straight piece across one face, away from the point traced.
  struct Leg
  {
    /// Its ends in the frame of a halfedge of the face.
    Id frame = NoId;
    Vec2 from;
    Vec2 to;
    /// The halfedge that it leaves the face through, and the ray behind it as a linear window
    /// without width, in the leaving frame: the x axis runs against the halfedge.
    Id exit = NoId;
    Window ray = {};
    /// The vertex that the path comes straight from; NoId where it comes straight from a source.
    Id origin = NoId;
  };
  /// A path as far as it was followed.
  struct Path
  {
    std::vector<SurfacePoint> points;
    /// Length that is left from the last point, and that of the whole.
    double left = 0.0;
    double whole = 0.0;
    bool isWhole = false;
  };

  void requireLength(const Path& path) const;
  void goOn(Path& path) const;
  void goOnFromVertex(Id vertex, Path& path) const;
  void goOnThroughWindows(Id without, Path& path) const;
  void follow(Leg leg, Path& path) const;

  Leg legTo(Vec2 from, const Arrival& arrival) const;
  Leg legBeyond(const Leg& leg, Id sibling) const;
  SurfacePoint exitOf(const Leg& leg) const;
  Id cornerOn(const Leg& leg, const Path& path) const;

  double slack(Id face, const Path& path) const;
  bool endInFace(Id face, Path& path) const;
  void goToVertex(Id vertex, Path& path) const;
  void goToNeighbour(Id vertex, Path& path) const;

  const DistanceField& field_;
  const TriangleMesh& mesh_;
};

}

#endif
