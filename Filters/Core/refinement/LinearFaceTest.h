// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LinearFaceTest_h
#define geodesic_LinearFaceTest_h

#include "refinement/FaceBounds.h"
#include "refinement/PassedLists.h"

namespace geodesic
{

/// Tells from the lists that have passed through a face whether the distance in it is linear within
/// a tolerance, so that the face need not be refined.
///
/// Let A and B bound how far the distance is over and under the linear interpolant of a face's
/// corners. Where the face is closed by triangles between points of its edges, their values are
/// exact, so that the closure is over the interpolant by at most A and under it by at most B: it
/// differs from the distance by at most A + B (Bounds.md).
class LinearFaceTest
{
public:
  /// What is known about a face.
  struct Result
  {
    /// Whether A + B is within the tolerance.
    bool isLinear = false;
    /// A + B with all rounding, and A, where it is.
    double bound = Infinity;
    float above = 0.0F;
    /// Whether the face is near enough to linear to get along with one split of its edges.
    bool isSplitOnce = false;
    /// The same by the bands alone, which need not be sharp.
    double boundByBand = Infinity;
    float aboveByBand = 0.0F;

    /// The result where a bound so large is reported anyway: what is no larger need not be sharp.
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

  /// A list, with what can be found out while its windows are at hand.
  MeasuredList measure(const PassedList& list) const;

  /// \param d distances at the corners, all finite; no source is in the face.
  /// \param known a bound so large is reported anyway: what is no larger need not be sharp.
  Result test(
    Id face, const std::array<double, 3>& d, const PassedLists& lists, double known) const;

  /// A + B of a linear face when one more list has come: A stays what it was, as later windows make
  /// the distance only smaller.
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
