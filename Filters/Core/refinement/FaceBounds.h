// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceBounds_h
#define geodesic_FaceBounds_h

#include "field/DistanceField.h"

#include <array>

namespace geodesic
{

/// Bounds over a whole input face: how far the distance is over the linear interpolant of its
/// corners, and how far under it. Why they hold: Bounds.md.
struct FaceBounds
{
  double above = Infinity;
  double below = Infinity;
};

/// How much more than along the halfedges the distance can differ inside a face, because the
/// interpolant's gradient is not a unit vector.
struct GradientSlack
{
  /// Under the interpolant, where the gradient is longer.
  double below;
  /// Over it, where it is shorter.
  double above;
};

/// \param shape of a face with area.
/// \param d distances at its corners.
GradientSlack slackOf(const FaceShape& shape, const std::array<double, 3>& d);

/// Whether the interpolant rises from the line of halfedge k into the face: paths against the
/// gradient leave through such a halfedge.
bool risesFrom(std::size_t k, const FaceShape& shape, const std::array<double, 3>& d);

/// Bounds from the windows of the face's halfedges as they are, no source being in the face and `d`
/// being the distances at its corners. Infinite where one would be over the limit, which says
/// nothing.
FaceBounds boundsOfFace(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<WindowRuns, 3>& windows, double limit);

/// How far the distance through windows of one halfedge can be under the interpolant, anywhere in
/// the face.
double belowThroughHalfedge(
  const TriangleMesh& mesh, Id halfedge, const std::array<double, 3>& d, const WindowRuns& windows);

/// The distance changes by no more than the way: |distance - linear interpolant| in a face is at
/// most its longest edge. Infinity where that is over the limit.
double errorBySize(const TriangleMesh& mesh, Id face, double limit);

/// A quick bound of |distance - linear interpolant| in a face of a field, with the sources in it;
/// Infinity where it would be over the limit, which says nothing. Not looked for when a face of
/// this size cannot have more than `known`.
double quickErrorOfFace(const DistanceField& field, Id face, double limit, double known);

}

#endif
