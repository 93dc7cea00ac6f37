// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathTracer_h
#define geodesic_PathTracer_h

#include "Errors.h"
#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// A path could not be followed to its end, or has become longer than the distance: it runs so
/// close to vertices that rounding decides about its way. pathInWindows() finds it.
class PathLost : public Error
{
public:
  using Error::Error;
};

/// A straight piece of a path across one face, on the way from the traced point to the source.
struct PathLeg
{
  /// Its ends in the frame of a halfedge of the face.
  Id frame = NoId;
  Vec2 from;
  Vec2 to;
  /// The halfedge through which it leaves the face, and the ray behind that halfedge: a linear
  /// window without width in the leaving frame, whose x axis runs against the halfedge.
  Id exit = NoId;
  Window ray = {};
  /// What the path comes straight from: Window::origin, or NoId.
  Id origin = NoId;
};

/// How far a path was followed, as one rank tells another.
struct PathState
{
  /// What to do next.
  enum class Next : std::uint8_t
  {
    /// Continue from the last point, which is a vertex or the first point.
    Point,
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
  /// The last leg, if the path continues behind its exit.
  PathLeg leg;

  bool isWhole() const { return this->next == Next::End; }
};

/// A path as far as it was followed.
struct TracedPath : PathState
{
  /// The points, each with a face that holds it and the point before.
  std::vector<SurfacePoint> points;
  std::vector<Id> faces;
  /// The face that the path has come from, which a search leaves out; NoId if there is none.
  Id without = NoId;
};

/// Traces shortest paths of a field that was solved with FrontOptions::keepArrivals.
///
/// Between bends a shortest path is straight in the unfolding, and each vertex stores the direction
/// in which its own path arrives. So a path is followed as a ray, face by face, to the
/// pseudo-source where it bends, or to the source. Windows are needed in few faces only: around the
/// first point, and around edges of three and more faces, where they determine in which face the
/// path continues. RetentionAround keeps these.
///
/// If ranks share the surface, each rank follows paths through the faces that it owns.
class PathTracer
{
public:
  /// The field must outlive the tracer.
  explicit PathTracer(const DistanceField& field)
    : field_(field)
    , mesh_(field.mesh())
  {
  }

  /// A shortest path from a point to the source: the point, a point on every edge that it crosses,
  /// the vertices that it passes, its end on the source. Empty if the point was not reached.
  /// Thread-safe.
  ///
  /// \throws PathLost if the path cannot be followed, for example from a face whose windows were
  ///         not kept.
  std::vector<SurfacePoint> trace(const SurfacePoint& from) const;

  /// A path before its first step; it has no points if the point was not reached.
  TracedPath begin(const SurfacePoint& from) const;
  /// Follows a path to its end, or as far as it goes through this rank's faces.
  ///
  /// \returns another rank's face where it continues; NoId if it is complete, or has to search
  ///          around its last point (PathState::Next::Search) in faces of several ranks.
  /// \throws PathLost
  Id follow(TracedPath& path) const;
  /// The length of the shortest path that comes to the last point through this rank's faces, except
  /// TracedPath::without; infinite if there is none.
  double searchHere(const TracedPath& path) const;
  /// Continues from a search through the best of this rank's faces.
  void goOnHere(TracedPath& path) const;

private:
  Id placeToGoOn(const TracedPath& path) const;
  void requireLength(const TracedPath& path) const;
  void add(TracedPath& path, Id face, const SurfacePoint& point) const;
  void goOnFromVertex(Id vertex, TracedPath& path) const;
  void search(TracedPath& path) const;

  void startLeg(Vec2 from, const Arrival& arrival, TracedPath& path) const;
  void followLeg(TracedPath& path) const;
  PathLeg legBeyond(const PathLeg& leg, Id sibling) const;
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
