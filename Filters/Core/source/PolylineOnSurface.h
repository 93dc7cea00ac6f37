// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolylineOnSurface_h
#define geodesic_PolylineOnSurface_h

#include "Progress.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"
#include "source/SourceCurve.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace geodesic
{

/// A polyline in space whose points have been located on the surface (the caller has the locator).
struct LocatedPolyline
{
  /// The points in space as the user gave them.
  std::vector<Vec3> points;
  /// The faces that are equally close to each (one at least; more where the surface touches or
  /// overlaps itself), the first choice first.
  std::vector<std::vector<Id>> faces;
  /// Whether the last point joins the first.
  bool closed = false;
  /// Name for error messages, such as "line 3 of the source".
  std::string name;
  /// SourceCurve::source of its curves.
  Id source = 0;
};

/// How located points are put onto the surface.
struct SnapOptions
{
  /// Relative precision of the curve's coordinates: epsilon of float for 32-bit points, of double
  /// for 64-bit ones.
  double coordinatePrecision = std::numeric_limits<double>::epsilon();
};

/// The curves as they lie on the surface.
struct SourceCurves
{
  std::vector<SourceCurve> curves;
  /// The farthest that a point of the source was from the place it was put to, in space.
  double snapDistance = 0.0;
  /// Points equal to their predecessor on the surface, which were left out.
  Id repeatedPoints = 0;
};

/// Finds a shortest path on the surface between two points that share no face: the first point, a
/// point on every edge that it crosses, the vertices that it passes, the second point; empty where
/// no path joins them. Progress is called now and then with a fraction done; where it returns
/// false, Aborted is thrown. The engine's own is joinByShortestPaths (paths/JoinPoints.h): it needs
/// a distance field, which is made after its source.
using JoinPoints = std::function<std::vector<SurfacePoint>(
  const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)>;

/// Puts polylines onto the surface: each point goes to the closest point of its face, and onto a
/// vertex or an edge when within a tolerance of it (Tolerance.h); consecutive points in one face
/// are joined straight, others as `join` has it, cut at every edge that is crossed. Points that
/// their precision cannot tell apart are one.
///
/// Where a point has several faces, those are taken in which consecutive points share a face
/// (choosePlaces); a single point takes a vertex before an edge before a face.
///
/// One curve a polyline, in their order, or several: where a polyline passes from one sheet of the
/// surface to another that touches it there and is not connected with it in the point, a curve ends
/// and the next begins.
///
/// \param join a shortest path between points that share no face.
/// \param progress called now and then with a fraction done; returning false throws Aborted.
/// \throws SourceError where a polyline has no points, a point is not finite or has no face, or
///         consecutive points are in different components; Aborted.
SourceCurves putOntoSurface(const TriangleMesh& mesh, const std::vector<LocatedPolyline>& polylines,
  const SnapOptions& options, const JoinPoints& join, const ProgressCallback& progress = {});

}

#endif
