// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/ClosingCheck.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

ClosingCheck::Result ClosingCheck::check(
  RefinementWorker& worker, Id triangle, const RedGreenMesh::Closing& closing, bool tight) const
{
  const FaceDistance& face = worker.distances.face(this->triangles_.faceOf(triangle));
  Result worst;
  for (Id i = 0; i < closing.count; ++i)
  {
    const Result one = this->check(worker, face, this->pieceOf(face, closing, i, worker), tight);
    worst.bound = std::max(worst.bound, one.bound);
    worst.sample = std::max(worst.sample, one.sample);
    worst.limit = std::min(worst.limit, one.limit);
    worst.passed = worst.passed && one.passed;
  }
  return worst;
}

// A segment between two corners of the closing's polygon runs along an edge of the mesh or across
// the leaf.
ClosingCheck::Piece ClosingCheck::pieceOf(const FaceDistance& face,
  const RedGreenMesh::Closing& closing, Id number, RefinementWorker& worker) const
{
  const std::array<Id, 3>& t = closing.triangles[number];
  Piece piece{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id i = t[k];
    const Id j = t[(k + 1) % 3];
    piece.corners[k] = closing.points[i];
    if (j == (i + 1) % closing.size)
    {
      piece.deviations[k] = this->edges_.measured(closing.edges[i]);
      continue;
    }
    // independent of the direction, to the last digit
    const auto [a, b] = std::minmax(closing.points[i], closing.points[j]);
    piece.deviations[k] = worker.distances.between(a, b, face);
  }
  return piece;
}

// In an approximate field the faces around a point differ by what merging has changed, which no
// refinement can undo. The triangle gets the rest of the tolerance, but at least half of it.
// Refinement ends whatever rounding does: distances change by no more than the length moved, so a
// triangle as small as the tolerance passes.
ClosingCheck::Result ClosingCheck::check(
  RefinementWorker& worker, const FaceDistance& face, const Piece& piece, bool tight) const
{
  LinearPiece linear;
  double largest = 0.0;
  double difference = 0.0;
  Deviation onEdges;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id corner = piece.corners[k];
    const double distance = worker.distances.atPoint(corner);
    linear.corners[k] = this->triangles_.inPlane(corner, face.face());
    linear.values[k] = worker.distances.atPoint(corner, face, linear.corners[k]);
    largest = std::max(largest, distance);
    difference = std::max(difference, std::abs(linear.values[k] - distance));
    onEdges.widen(piece.deviations[k]);
  }
  const double rounding = tolerance::FaceRounding * largest;
  Result result;
  result.limit = std::max(this->tolerance_ - difference - rounding, 0.5 * this->tolerance_);
  const bool small = sizeOf(linear) <= result.limit;
  if (onEdges.largest() > result.limit && !small && !tight)
  {
    result.sample = onEdges.largest();
    result.passed = false;
    return result;
  }
  const ErrorInside inside = worker.error.of(face, linear, onEdges, result.limit, tight || small);
  const double own = std::max(inside.bound, onEdges.largest());
  result.bound = own + rounding + difference;
  result.sample = inside.sample;
  result.passed = small || own <= result.limit;
  return result;
}

}
