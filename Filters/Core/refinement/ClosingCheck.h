// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ClosingCheck_h
#define geodesic_ClosingCheck_h

#include "refinement/EdgeDistances.h"

#include <vector>

namespace geodesic
{

/// Holds the triangles that close a leaf against the tolerance. May be used by several workers at
/// the same time.
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
  ClosingCheck(const RedGreenMesh& triangles, const EdgeDistances& edges, double tolerance)
    : triangles_(triangles)
    , edges_(edges)
    , tolerance_(tolerance)
  {
  }

  /// \param closing of a leaf whose edges have been made and measured, with the halves of those
  ///        that are split.
  /// \param tight look for a bound that is near a difference that occurs.
  Result check(
    RefinementWorker& worker, Id triangle, const RedGreenMesh::Closing& closing, bool tight) const;

private:
  /// A triangle of the output, or one that would be.
  struct Piece
  {
    Triangle corners;
    std::array<Deviation, 3> deviations;
  };

  Piece pieceOf(const FaceDistance& face, const RedGreenMesh::Closing& closing, Id number,
    RefinementWorker& worker) const;
  Result check(
    RefinementWorker& worker, const FaceDistance& face, const Piece& piece, bool tight) const;

  const RedGreenMesh& triangles_;
  const EdgeDistances& edges_;
  double tolerance_;
};

}

#endif
