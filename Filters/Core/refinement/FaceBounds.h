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

/// A bound of |distance - linear interpolant| in a face from its size: distances change by no more
/// than the length moved, so the longest edge is a bound. Infinity if that exceeds the limit.
double errorBySize(const TriangleMesh& mesh, Id face, double limit);

/// A quick bound of |distance - linear interpolant| in a face of a field, with the sources in it;
/// Infinity if it exceeds the limit. It is not computed if the face's size shows that the bound is
/// at most `known`.
double quickErrorOfFace(const DistanceField& field, Id face, double limit, double known);

}

#endif
