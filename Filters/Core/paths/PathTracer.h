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

/// A straight piece of a path across one face, away from the point traced.
struct PathLeg
{
  /// Its ends in the frame of a halfedge of the face.
  Id frame = NoId;
  Vec2 from;
  Vec2 to;
  /// The halfedge that it leaves the face through, and the ray behind it as a linear window
  /// without width, in the leaving frame: the x axis runs against the halfedge.
  Id exit = NoId;
  Window ray = {};
  /// What the path comes straight from: Window::origin, or NoId.
  Id origin = NoId;
};

/// How far a path was followed.
struct PathState
{
  /// What to do next.
  enum class Next : std::uint8_t
  {
    /// Continue from the last point, which is a vertex or the first point.
    Point,
    /// Follow the leg through its face.
    Leg,
    /// Continue behind the leg's exit.
    BehindExit,
    /// Find the face, of those around the last point on an edge, that the path comes through.
    Search,
    /// Nothing: the path is complete.
    End
  };

  /// The length from the last point to the source, the length of the whole path, and the length of
  /// the part that was followed.
  double left = 0.0;
  double whole = 0.0;
  double length = 0.0;
  /// The number of points added, and of faces crossed since the path should have ended.
  std::uint64_t steps = 0;
  int stepsBesideEnd = 0;
  Next next = Next::Point;

  bool isWhole() const { return this->next == Next::End; }
};

/// A path as far as it was followed.
struct TracedPath : PathState
{
  /// The points, each with a face that holds it and the point before.
  std::vector<SurfacePoint> points;
  std::vector<Id> faces;
  PathLeg leg;
  /// The face that the path has come from, which a search leaves out; NoId if there is none.
  Id without = NoId;
};

/// Traces shortest paths of a field that was solved with FrontOptions::keepArrivals.
///
/// Between its bends a shortest path is straight in the unfolding, and each vertex remembers the
/// direction in which its own comes: so a path is followed as a ray, face by face, as far as the
/// pseudo-source that its windows left or the source. No windows are needed for that, save in the
/// faces of the point that the path begins at, and in those around edges of three and more faces,
/// where they tell in which one it goes on: RetentionAround keeps these.
///
/// Where ranks have the surface together, each follows paths through the faces that it owns.
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

  /// A path before its first step; its points are empty where the point was not reached.
  TracedPath begin(const SurfacePoint& from) const;
  /// Follows it to its end, or on a part of a surface as far as this rank can.
  ///
  /// \returns the face where it goes on; NoId where it is whole, or has to search around its last
  ///          point (TracedPath::Next::Search) in faces of several ranks.
  /// \throws PathLost
  Id follow(TracedPath& path) const;
  /// How long a path is that comes to the last point through one of this rank's faces, the one of
  /// a search left out.
  double searchHere(const TracedPath& path) const;
  /// Goes on from a search through the best of this rank's faces.
  void goOnHere(TracedPath& path) const;

private:
  Id placeToGoOn(const TracedPath& path) const;
  void requireLength(const TracedPath& path) const;
  void add(TracedPath& path, Id face, const SurfacePoint& point) const;
  void goOn(TracedPath& path) const;
  void goOnFromVertex(Id vertex, TracedPath& path) const;
  void search(TracedPath& path) const;
  void crossFace(TracedPath& path) const;

  void startLeg(Vec2 from, const Arrival& arrival, TracedPath& path) const;
  PathLeg legBeyond(const PathLeg& leg, Id sibling) const;
  SurfacePoint exitOf(const PathLeg& leg) const;
  Id cornerOn(const PathLeg& leg, const TracedPath& path) const;

  double slack(Id face, const TracedPath& path) const;
  bool endInFace(Id face, TracedPath& path) const;
  void goToVertex(Id vertex, Id face, TracedPath& path) const;
  void goToNeighbour(Id vertex, TracedPath& path) const;

  const DistanceField& field_;
  const TriangleMesh& mesh_;
};

}

#endif
