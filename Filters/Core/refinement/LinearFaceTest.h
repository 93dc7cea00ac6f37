// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LinearFaceTest_h
#define geodesic_LinearFaceTest_h

#include "front/Retention.h"
#include "refinement/FaceBounds.h"

#include <array>
#include <forward_list>
#include <vector>

namespace geodesic
{

/// Whether the windows of a list stay in a band around the line between two values at the ends of
/// their halfedge. The test may fail although they do.
struct ListInBand
{
  /// No window is below the band.
  bool staysAboveBand = false;
  /// The windows cover the halfedge except for small gaps, and none is above the band.
  bool staysBelowBand = false;
};

/// Tests a list whose windows are in the cache; fast, as it needs no square roots.
///
/// \param limit half the width of the band.
ListInBand listInBand(
  const WindowRange& windows, double length, double atOrigin, double atDestination, double limit);

/// Bounds for a face none of whose lists is below a band of this half width. `staysBelowBand` marks
/// the halfedges that a list covers without being above the band. The bounds may be infinite.
FaceBounds boundsFromBands(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<bool, 3>& staysBelowBand, double limit);

/// A passed list, and whether it is in the band around the line between the distances at its ends.
struct MeasuredList
{
  PassedList list;
  ListInBand inBand;
};

/// The lists that have passed through a face, in this order.
using MeasuredLists = std::forward_list<MeasuredList>;

/// Decides from the lists that have passed through a face whether the distance in it is linear
/// within a tolerance, so that the face need not be refined.
///
/// Let A and B bound how far the distance is above and below the linear interpolant of the face's
/// corners. If triangles between points of its edges close the face, the values at these points are
/// exact, so the closure is above the interpolant by at most A and below it by at most B: it
/// differs from the distance by at most A + B (Bounds.md).
class LinearFaceTest
{
public:
  struct Sum
  {
    /// A + B with all rounding, and A.
    double bound = Infinity;
    float above = 0.0F;
  };
  /// The face is linear if one of the sums is within the tolerance.
  struct Result
  {
    /// From the bands alone; may be wide. Good enough if a bound of this size is reported anyway.
    Sum byBand;
    /// Not computed if byBand is good enough; infinite if the face is not linear.
    Sum byWindows;
    /// Whether the face is close enough to linear that one split of its edges suffices.
    bool isSplitOnce = true;
  };

  /// \param mesh must outlive this.
  /// \param tolerance of the refinement.
  LinearFaceTest(const TriangleMesh& mesh, double tolerance)
    : mesh_(mesh)
    , tolerance_(tolerance)
  {
  }

  /// A list, and what is measured while its windows are in the cache.
  MeasuredList measure(const PassedList& list) const;

  /// \param d distances at the corners, all finite; the face contains no source.
  /// \param lists all that have passed through the face.
  /// \param known a bound that is reported anyway: smaller bounds need not be sharp.
  Result test(
    Id face, const std::array<double, 3>& d, const MeasuredLists& lists, double known) const;

  /// A + B of a linear face after another list has passed. A stays valid, as later windows only
  /// reduce the distance.
  double boundWith(const PassedList& late, float above, const std::array<double, 3>& d) const;

private:
  FaceBounds boundsByBand(
    Id face, const std::array<double, 3>& d, const MeasuredLists& lists) const;
  FaceBounds boundsByWindows(
    Id face, const std::array<double, 3>& d, const MeasuredLists& lists, double limit) const;

  const TriangleMesh& mesh_;
  double tolerance_;
};

}

#endif
