// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ClosingCheck_h
#define geodesic_ClosingCheck_h

#include "refinement/EdgeDistances.h"

#include <vector>

namespace geodesic
{

/// Checks the triangles that close a leaf against the tolerance. Several workers may use it at the
/// same time.
class ClosingCheck
{
public:
  struct Result
  {
    /// Certified bound of the difference to the distance of all faces.
    double bound = 0.0;
    /// A difference that does occur.
    double sample = 0.0;
    /// Whether the leaf may stay as it is.
    bool passed = true;
    /// The limit for differences within the leaf's face.
    double limit = Infinity;
  };

  /// All arguments must outlive this.
  ///
  /// \param tolerance of the refinement.
  ClosingCheck(const RedGreenMesh& triangles, const EdgeDistances& edges, double tolerance)
    : triangles_(triangles)
    , edges_(edges)
    , tolerance_(tolerance)
  {
  }

  /// \param closing of a leaf whose edges, including the halves of split ones, exist and have been
  ///        measured.
  /// \param tight whether to search for a bound near a difference that does occur.
  Result check(
    RefinementWorker& worker, Id triangle, const RedGreenMesh::Closing& closing, bool tight) const;

private:
  /// A triangle of the output, or a candidate for it.
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
