// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LinearFaceTest_h
#define geodesic_LinearFaceTest_h

#include "refinement/FaceBounds.h"
#include "refinement/PassedLists.h"

namespace geodesic
{

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
  struct Result
  {
    /// Whether A + B is within the tolerance.
    bool isLinear = false;
    /// A + B with all rounding, and A, if linear.
    double bound = Infinity;
    float above = 0.0F;
    /// Whether the face is close enough to linear that one split of its edges suffices.
    bool isSplitOnce = false;
    /// The bounds from the bands alone, which may be wide.
    double boundByBand = Infinity;
    float aboveByBand = 0.0F;

    /// The result if a bound `known` is reported anyway: smaller bounds need not be sharp.
    Result boundUnlessDominated(double known) const
    {
      return this->boundByBand <= known ? Result{ true, this->boundByBand, this->aboveByBand, true }
                                        : *this;
    }
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
  /// \param known a bound that is reported anyway: smaller bounds need not be sharp.
  Result test(
    Id face, const std::array<double, 3>& d, const PassedLists& lists, double known) const;

  /// A + B of a linear face after another list has passed. A stays valid, as later windows only
  /// reduce the distance.
  double boundWith(const PassedList& late, float above, const std::array<double, 3>& d) const;

private:
  FaceBounds boundsByBand(Id face, const std::array<double, 3>& d, const PassedLists& lists) const;
  FaceBounds boundsByWindows(
    Id face, const std::array<double, 3>& d, const PassedLists& lists, double limit) const;

  const TriangleMesh& mesh_;
  double tolerance_;
};

}

#endif
