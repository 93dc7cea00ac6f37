// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ExcessSearch_h
#define geodesic_ExcessSearch_h

#include "field/FaceDistance.h"
#include "refinement/LinearPiece.h"

#include <vector>

namespace geodesic
{

/// The difference between distance and linear function in a triangle.
struct ErrorInside
{
  /// No difference is larger.
  double bound;
  /// Such a difference does occur.
  double sample;
};

/// Finds how far the distance exceeds a linear function anywhere in a triangle, by branch and
/// bound: it halves the triangle repeatedly until, on each part, some convex combination of
/// candidates is close enough to the function at the corners. Bounds.md explains why that is a
/// bound. One object serves many triangles and reuses its memory.
class ExcessSearch
{
public:
  /// \param limit the search ends when the bound is at most the limit, or a sample exceeds it.
  /// \param tight whether to continue until the bound is near the sample.
  ErrorInside run(const FaceDistance& face, const LinearPiece& piece, double limit, bool tight);

private:
  struct Node
  {
    LinearPiece piece;
    Id depth;
    /// For each corner, its row in the table of excesses.
    std::array<std::size_t, 3> row;
  };

  void chooseNear(const FaceDistance& face, const LinearPiece& piece);
  std::size_t addRow(Vec2 p, double value);
  double leastInRow(std::size_t row) const;
  Node rootOf(const LinearPiece& piece);
  double halve(const Node& node);
  double boundOf(const Node& node, double limit) const;

  std::vector<const DistanceCandidate*> near_;
  /// Row by row: the excess of each candidate over the function at one point.
  std::vector<double> excess_;
  /// Parts that are yet to be examined.
  std::vector<Node> nodes_;
};

}

#endif
