// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ExcessSearch_h
#define geodesic_ExcessSearch_h

#include "field/FaceDistance.h"
#include "refinement/LinearPiece.h"

#include <vector>

namespace geodesic
{

/// What is known about differences in a triangle.
struct ErrorInside
{
  /// No difference is larger.
  double bound;
  /// Such a difference occurs.
  double sample;
};

/// How far the distance is over a linear function anywhere in a triangle, by branch and bound: the
/// triangle is halved again and again, until on each part some convex combination of candidates is
/// near enough to the function at the corners. Why that bounds it: Bounds.md.
///
/// One search is reused for many triangles, for the memory that it holds.
class ExcessSearch
{
public:
  /// \param limit the search ends when the bound is not over the limit, or a sample is.
  /// \param tight go on until the bound is near the sample.
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
  /// Row by row: how far each candidate is over the function at one point.
  std::vector<double> excess_;
  /// Parts that are still to be looked at.
  std::vector<Node> nodes_;
};

}

#endif
