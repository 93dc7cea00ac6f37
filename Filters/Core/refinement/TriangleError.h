// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleError_h
#define geodesic_TriangleError_h

#include "field/FaceDistance.h"
#include "refinement/Deviation.h"

#include <array>
#include <vector>

namespace geodesic
{

/// A triangle of the plane with a linear function, given by its values at the corners.
struct LinearPiece
{
  std::array<Vec2, 3> corners;
  std::array<double, 3> values;
};

/// The difference between distance and linear function in a triangle.
struct ErrorInside
{
  /// No difference is larger.
  double bound;
  /// Such a difference does occur.
  double sample;
};

/// Certified bounds of |distance - linear interpolant| on whole triangles; the paper considers
/// edges only. Bounds.md explains why they hold. One object serves many triangles and reuses its
/// memory.
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
    double limit, bool tight);

private:
  /// A part of the triangle that is searched.
  struct Node
  {
    LinearPiece piece;
    Id depth;
    /// For each corner, its row in the table of excesses.
    std::array<std::size_t, 3> row;
  };

  ErrorInside above(
    const FaceDistance& face, const LinearPiece& piece, double onEdges, double limit, bool tight);
  ErrorInside search(const FaceDistance& face, const LinearPiece& piece, double limit, bool tight);
  std::size_t addRow(Vec2 p, double value);
  double leastInRow(std::size_t row) const;
  double halve(const Node& node);
  double boundOf(const Node& node, double limit) const;

  const DistanceField& field_;
  NearCandidates near_;
  /// Row by row: the excess of each candidate over the function at one point.
  std::vector<double> excess_;
  /// Parts that are yet to be examined.
  std::vector<Node> nodes_;
};

}

#endif
