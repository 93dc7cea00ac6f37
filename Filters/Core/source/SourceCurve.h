// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceCurve_h
#define geodesic_SourceCurve_h

#include "Progress.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <string>
#include <vector>

namespace geodesic
{

/// A polyline on the surface, cut so that each segment lies in one face (paper, section 4.2). A
/// single point is a curve without segments.
struct SourceCurve
{
  /// Consecutive points; a closed curve repeats its first point at the end.
  std::vector<SurfacePoint> points;
  /// The face that holds points i and i + 1; one fewer than points.
  std::vector<Id> faces;
  /// Whether point i only cuts a straight segment at a mesh edge: no wedge and no circular windows
  /// there. One a point.
  std::vector<std::uint8_t> isCut;

  bool isClosed() const;
};

/// A polyline in space whose points have been located on the surface (the caller has the locator).
struct LocatedPolyline
{
  /// The points in space as the user gave them.
  std::vector<Vec3> points;
  /// The face with the closest point of the surface to each.
  std::vector<Id> faces;
  /// Whether the last point joins the first.
  bool closed = false;
  /// Name for error messages, such as "line 3 of the source".
  std::string name;
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

/// Puts polylines onto the surface: each point goes to the closest point of its face, and onto a
/// vertex or an edge when within a tolerance of it (Tolerance.h); consecutive points in one face
/// are joined straight, others by the shortest geodesic, cut at every edge it crosses. Points that
/// their precision cannot tell apart are one. One curve a polyline, in their order.
///
/// \param progress called now and then with a fraction done; returning false throws Aborted.
/// \throws SourceError where a polyline has no points, a point is not finite or has no face, or
///         consecutive points are in different components; Aborted.
SourceCurves putOntoSurface(const TriangleMesh& mesh, const std::vector<LocatedPolyline>& polylines,
  const SnapOptions& options, const ProgressCallback& progress = {});

/// The whole boundary of the surface: one closed curve along mesh edges a loop. Where not exactly
/// two boundary edges meet at a vertex, curves end there (they may begin there, too). Every
/// boundary edge is in one curve, once. Empty for a closed surface.
std::vector<SourceCurve> boundaryCurves(const TriangleMesh& mesh);

}

#endif
