// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_InterpolationError_h
#define geodesic_InterpolationError_h

#include "FaceEnvelope.h"

#include <array>
#include <vector>

namespace geodesic
{

/// A triangle of the plane with a linear function given at its corners.
struct LinearPiece
{
  std::array<Vec2, 3> corners;
  std::array<double, 3> values;
};

/// Certified bounds of |distance - linear interpolant| on whole triangles, beyond the paper, which
/// looks at edges only. How, and why they hold, is told in the source.
///
/// Bounds are up to the rounding of distances.
class InterpolationError
{
public:
  explicit InterpolationError(const DistanceField& field);

  /// A quick bound for an input face and the distances at its corners, from its windows as they
  /// are; Infinity where it would be over the limit, which says nothing. Not looked for when a face
  /// of this size cannot have more than `known`.
  double ofFace(Id face, double limit, double known) const;

  /// What is known about the inside of a triangle.
  struct Inside
  {
    /// No difference is larger.
    double bound;
    /// Such a difference occurs.
    double sample;
  };

  /// The differences inside a triangle, those on its edges being given.
  ///
  /// \param envelope in the face that holds the triangle.
  /// \param onEdges largest deviations on the edges.
  /// \param limit the search for a bound ends when it is not over the limit, or a sample is.
  /// \param tight go on until the bound is near the sample.
  Inside ofTriangle(const FaceEnvelope& envelope, const LinearPiece& piece,
    const Deviation& onEdges, double limit, bool tight = false);

private:
  struct Node
  {
    LinearPiece piece;
    Id depth;
    /// For each corner, its row in the table of excesses.
    std::array<std::size_t, 3> row;
  };

  bool belowOfSide(
    Id side, double atOrigin, double atDestination, double limit, double& below) const;
  double aboveOfSide(Id side, double atOrigin, double atDestination, double limit) const;
  double belowAtSources(const FaceEnvelope& envelope, const LinearPiece& piece) const;
  Inside search(const FaceEnvelope& envelope, const LinearPiece& piece, double limit, bool tight);
  void chooseNear(const FaceEnvelope& envelope, const LinearPiece& piece);
  std::size_t addRow(Vec2 p, double value);
  double leastInRow(std::size_t row) const;
  double boundOf(const Node& node, double limit);

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  std::vector<const Contribution*> near_;
  /// Row by row: how far each contribution is over the interpolant at one point.
  std::vector<double> excess_;
  std::vector<Node> nodes_;
};

}

#endif
