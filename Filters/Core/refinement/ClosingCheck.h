// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ClosingCheck_h
#define geodesic_ClosingCheck_h

#include "refinement/EdgeDistances.h"
#include "refinement/TriangleError.h"

#include <vector>

namespace geodesic
{

/// Holds the triangles that close a leaf against the tolerance.
class ClosingCheck
{
public:
  struct Result
  {
    /// Certified against the distance of all faces.
    double bound = 0.0;
    /// A difference that occurs.
    double sample = 0.0;
    /// Whether the leaf may stay as it is.
    bool passed = true;
    /// What the differences within the leaf's face were held against.
    double limit = Infinity;
  };

  /// All must outlive this.
  ///
  /// \param tolerance of the refinement.
  ClosingCheck(const DistanceField& field, RedGreenMesh& triangles, EdgeDistances& distances,
    FaceDistanceCache& faces, double tolerance);

  /// \param tight look for a bound that is near a difference that occurs.
  Result check(Id triangle, const RedGreenMesh::Closing& closing, bool tight);

private:
  /// A triangle of the output, or one that would be.
  struct Piece
  {
    Triangle corners;
    std::array<Deviation, 3> deviations;
  };

  std::vector<Piece> piecesOf(Id triangle, const RedGreenMesh::Closing& closing);
  Deviation deviationBetween(Id triangle, const RedGreenMesh::Closing& closing, Id i, Id j);
  Result check(const FaceDistance& face, const Piece& piece, bool tight);

  RedGreenMesh& triangles_;
  EdgeDistances& distances_;
  FaceDistanceCache& faces_;
  TriangleError error_;
  double tolerance_;
};

}

#endif
