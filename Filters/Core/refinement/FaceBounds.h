// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceBounds_h
#define geodesic_FaceBounds_h

#include "field/DistanceField.h"

#include <array>

namespace geodesic
{

/// Bounds over a whole input face of how far the distance is above and below the linear interpolant
/// of its corners. Bounds.md explains why they hold.
struct FaceBounds
{
  double above = Infinity;
  double below = Infinity;
};

/// How much more than along the halfedges the distance can deviate inside a face, because the
/// interpolant's gradient is not a unit vector.
struct GradientSlack
{
  /// Below the interpolant, if the gradient is longer.
  double below;
  /// Above the interpolant, if the gradient is shorter.
  double above;
};

/// \param shape of a face with area.
/// \param d distances at its corners.
GradientSlack slackOf(const FaceShape& shape, const std::array<double, 3>& d);

/// The same for any triangle. The edges e1 and e2 from corner 0 are given by their dot products,
/// the function by its rise along each.
///
/// \param area2 twice the area, positive.
/// \param longest the triangle's longest edge.
GradientSlack slackOf(
  double e1e1, double e1e2, double e2e2, double area2, double rise1, double rise2, double longest);

/// Whether the interpolant rises from the line of halfedge k into the face: ways against the
/// gradient leave through such a halfedge.
bool risesFrom(std::size_t k, const FaceShape& shape, const std::array<double, 3>& d);

/// Bounds from the windows of the face's halfedges, without computing envelopes. The face contains
/// no source, and `d` are the distances at its corners. Infinite if a bound exceeds the limit.
FaceBounds boundsOfFace(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<WindowRuns, 3>& windows, double limit);

/// How far the distance through windows of one halfedge can be below the interpolant, anywhere in
/// the face.
double belowThroughHalfedge(
  const TriangleMesh& mesh, Id halfedge, const std::array<double, 3>& d, const WindowRuns& windows);

/// Bounds of |distance - linear interpolant| in a face of a field that need no envelopes. Infinite
/// where they exceed the tolerance less the rounding.
struct QuickError
{
  /// Of the distances at the corners; to be added to the bounds.
  double rounding = 0.0;
  /// From the face's size: distances change by no more than the length moved, so the longest edge
  /// is a bound.
  double bySize = Infinity;
  /// From the windows and sources, too; not computed if bySize is at most a bound that is known to
  /// occur anyway.
  double byWindows = Infinity;
};

QuickError quickErrorOfFace(const DistanceField& field, Id face, double tolerance, double known);

}

#endif
