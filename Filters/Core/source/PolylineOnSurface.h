// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolylineOnSurface_h
#define geodesic_PolylineOnSurface_h

#include "Job.h"
#include "source/PartName.h"
#include "source/SourceCurve.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// A polyline in space, with the faces closest to its points, which the caller has located.
struct LocatedPolyline
{
  std::vector<Vec3> points;
  /// For each point the equally close faces, in order of preference: at least one, and several
  /// where the surface touches or overlaps itself.
  std::vector<std::vector<Id>> faces;
  /// The vertex that each point is, which tells apart several at one place; NoId for points whose
  /// place has to be found. Empty if all places have to be found.
  std::vector<Id> vertices = {};
  /// Whether the last point joins the first.
  bool closed = false;
  /// What messages call it: "line 3 of the source".
  PartName name;
  /// What messages call its points; empty where these are "point 7 of line 3 of the source".
  std::vector<PartName> pointNames = {};
  /// SourceCurve::source of its curves.
  Id source = 0;

  Id vertexOf(std::size_t i) const { return this->vertices.empty() ? NoId : this->vertices[i]; }
  PartName nameOfPoint(std::size_t i) const
  {
    return this->pointNames.empty() ? this->name.part("point", i) : this->pointNames[i];
  }
  /// The segment from point i to the next one. In a line joined from several cells, point i's own
  /// name tells where the segment is.
  std::string nameOfSegment(std::size_t i) const
  {
    return this->pointNames.empty() ? this->name.part("segment", i).withoutInput()
                                    : "the segment from " + this->pointNames[i].withoutInput();
  }
};

/// The segment from point `segment` of a given polyline to its next point.
struct SegmentOfPolyline
{
  std::size_t polyline = 0;
  std::size_t segment = 0;
};

/// The curves as they lie on the surface.
struct SourceCurves
{
  std::vector<SourceCurve> curves;
  /// The largest distance in space from a point of the source to its place.
  double snapDistance = 0.0;
  /// Number of omitted points, equal to their predecessors on the surface.
  Id repeatedPoints = 0;
  /// For each segment of each curve that was a polyline: the given segment that it belongs to.
  /// Other curves may follow these.
  std::vector<std::vector<SegmentOfPolyline>> given;
  /// The segments that are detours on the surface (tolerance::Detour), and the largest ratio of
  /// their lengths to the straight distances between their ends.
  std::vector<SegmentOfPolyline> detours;
  double largestDetour = 0.0;
};

/// Finds a shortest path on the surface between two points that share no face: the first point, a
/// point on every crossed edge, the vertices on the way, the second point. It is empty if no path
/// joins the points. The engine's own function is joinByShortestPaths (paths/JoinPoints.h), which
/// needs a distance field and therefore a later room. It may be called twice for the same points:
/// JoinedPaths there remembers their path.
using JoinPoints = std::function<std::vector<SurfacePoint>(
  const SurfacePoint& first, const SurfacePoint& second, const Job& job)>;

/// Puts polylines onto the surface. Each point goes to the closest point of its face, and onto a
/// vertex or an edge within a tolerance of it (Tolerance.h). Consecutive points in one face are
/// joined by a straight segment, others by the path from `join`, cut at every crossed edge. Points
/// that are equal within their precision become one.
///
/// If a point has several faces, choosePlaces() selects those in which consecutive points share a
/// face; a single point prefers a vertex to an edge to a face.
///
/// Each polyline becomes one curve, in their order, or several: if it passes from one sheet of the
/// surface to another that touches it there without being connected, a curve ends and the next one
/// begins.
///
/// \param coordinatePrecision relative precision of the points' coordinates: epsilon of float for
///        32-bit points, of double for 64-bit ones.
/// \param join a shortest path between points that share no face.
/// \throws SourceError if a polyline has no points, a point is not finite or has no face, or
/// consecutive points are in different components; Aborted.
SourceCurves putOntoSurface(const TriangleMesh& mesh, const std::vector<LocatedPolyline>& polylines,
  double coordinatePrecision, const JoinPoints& join, const Job& job = {});

}

#endif
