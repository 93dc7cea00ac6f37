// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceBounds_h
#define geodesic_FaceBounds_h

#include "field/DistanceField.h"
#include "front/Retention.h"

#include <array>
#include <memory_resource>
#include <vector>

namespace geodesic
{

/// Bounds over a whole input face of how far the distance is above and below the linear interpolant
/// of its corners. Bounds.md explains why they hold.
struct FaceBounds
{
  double above = Infinity;
  double below = Infinity;
};

/// How much more than along the halfedges the distance can deviate inside a face: below the
/// interpolant if its gradient is longer than a unit vector, above it if it is shorter.
struct GradientSlack
{
  double below;
  double above;
};

/// \param shape of a face.
/// \param d distances at its corners.
GradientSlack slackOf(const FaceShape& shape, const std::array<double, 3>& d);

/// A triangle by the dot products of its edges e1 and e2 from corner 0.
struct TriangleMetric
{
  double e1e1;
  double e1e2;
  double e2e2;
  /// cross(e1, e2), positive.
  double area2;
  double longestEdge;
};

/// The same for any triangle and a function that rises along e1 and e2.
GradientSlack slackOf(const TriangleMetric& triangle, double rise1, double rise2);

/// Bounds from the windows of the face's halfedges, without computing envelopes. The face contains
/// no source, and `d` are the distances at its corners. Infinite if a bound exceeds the limit.
FaceBounds boundsOfFace(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<WindowRuns, 3>& windows, double limit);

/// A bound of |distance - linear interpolant| in a face of a field, with rounding, that needs no
/// envelopes. Infinite if it exceeds the tolerance.
double quickBoundOfFace(const DistanceField& field, Id face, double tolerance);

/// A passed list, and whether its windows stay in a band around the line between the distances at
/// the ends of its halfedge.
struct MeasuredList
{
  PassedList list;
  /// No window is below the band.
  bool hasNoneBelow = false;
  /// The windows cover the halfedge except for small gaps, and none is above the band.
  bool hasNoneAbove = false;
};

/// The lists that have passed through a face, in this order.
using MeasuredLists = std::pmr::vector<MeasuredList>;

/// Measures a list while its windows are in the cache.
///
/// \param tolerance of the refinement.
MeasuredList measuredList(const TriangleMesh& mesh, const PassedList& list, double tolerance);

/// Wide bounds, from what was found about all lists of a face as they passed. Infinite if some list
/// leaves its band, or if the distances at the corners have changed since.
///
/// \param tolerance for which the lists were measured.
FaceBounds boundsByBand(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const MeasuredLists& lists, double tolerance);

/// Whether the distance in a face is linear: whether a bound of how far any closure by triangles
/// between points of the edges can be from the distance is within the tolerance (Bounds.md).
struct LinearFaceTest
{
  /// Infinite if the face is not linear.
  double bound = Infinity;
  /// Whether the face is close enough to linear that one split of its edges suffices.
  bool isSplitOnce = true;
};

/// \param d distances at the corners, all finite; the face contains no source.
/// \param lists all that have passed through the face, measured with this tolerance.
/// \param known a bound that is reported anyway: smaller bounds need not be sharp.
LinearFaceTest testLinear(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const MeasuredLists& lists, double tolerance, double known);

}

#endif
