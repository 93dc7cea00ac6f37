// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleError_h
#define geodesic_TriangleError_h

#include "refinement/Deviation.h"
#include "refinement/ExcessSearch.h"

namespace geodesic
{

/// Certified bounds of |distance - linear interpolant| on whole triangles; the paper considers
/// edges only. Bounds.md explains why they hold.
///
/// The bounds are up to the rounding of distances.
class TriangleError
{
public:
  /// \param field must outlive this.
  explicit TriangleError(const DistanceField& field)
    : field_(field)
  {
  }

  /// The differences inside a triangle, given those on its edges.
  ///
  /// \param face the face that contains the triangle.
  /// \param onEdges largest deviations on the edges.
  /// \param limit the search ends when the bound is at most the limit, or a sample exceeds it.
  /// \param tight whether to continue until the bound is near the sample.
  ErrorInside of(const FaceDistance& face, const LinearPiece& piece, const Deviation& onEdges,
    double limit, bool tight = false);

private:
  ErrorInside above(
    const FaceDistance& face, const LinearPiece& piece, double onEdges, double limit, bool tight);
  double belowAtSources(const FaceDistance& face, const LinearPiece& piece) const;

  const DistanceField& field_;
  ExcessSearch search_;
};

}

#endif
