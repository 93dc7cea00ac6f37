// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/ClosingCheck.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

ClosingCheck::ClosingCheck(const DistanceField& field, RedGreenMesh& triangles,
  EdgeDistances& distances, FaceDistanceCache& faces, double tolerance)
  : triangles_(triangles)
  , distances_(distances)
  , faces_(faces)
  , error_(field)
  , tolerance_(tolerance)
{
}

ClosingCheck::Result ClosingCheck::check(
  Id triangle, const RedGreenMesh::Closing& closing, bool tight)
{
  const std::vector<Piece> pieces = this->piecesOf(triangle, closing);
  const FaceDistance& face = this->faces_.of(this->triangles_.faceOf(triangle));
  Result worst;
  for (const Piece& piece : pieces)
  {
    const Result one = this->check(face, piece, tight);
    worst.bound = std::max(worst.bound, one.bound);
    worst.sample = std::max(worst.sample, one.sample);
    worst.limit = std::min(worst.limit, one.limit);
    worst.passed = worst.passed && one.passed;
  }
  return worst;
}

std::vector<ClosingCheck::Piece> ClosingCheck::piecesOf(
  Id triangle, const RedGreenMesh::Closing& closing)
{
  std::vector<Piece> pieces;
  for (Id i = 0; i < closing.count; ++i)
  {
    const std::array<Id, 3>& t = closing.triangles[i];
    Piece piece{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      piece.corners[k] = closing.points[t[k]];
      piece.deviations[k] = this->deviationBetween(triangle, closing, t[k], t[(k + 1) % 3]);
    }
    pieces.push_back(piece);
  }
  return pieces;
}

// Between two corners of the closing's polygon: along an edge of the mesh or across the leaf.
Deviation ClosingCheck::deviationBetween(
  Id triangle, const RedGreenMesh::Closing& closing, Id i, Id j)
{
  if (j == (i + 1) % closing.size)
  {
    const Id edge = closing.edges[i];
    return this->distances_.deviation(
      edge == NoId ? this->triangles_.edge(triangle, closing.along[i]) : edge);
  }
  // the same either way, to the last digit
  const auto [a, b] = std::minmax(closing.points[i], closing.points[j]);
  return this->distances_.deviationBetween(
    a, b, this->faces_.of(this->triangles_.faceOf(triangle)));
}

// In an approximate field the faces around a point differ by what merging has changed, and no
// refinement can undo that: what is left of the tolerance, but half of it at least, is for the
// triangle. Whatever the rounding, refinement ends: the distance changes by no more than the way,
// so that there is nothing left to refine in a triangle as small as that.
ClosingCheck::Result ClosingCheck::check(const FaceDistance& face, const Piece& piece, bool tight)
{
  LinearPiece linear;
  double largest = 0.0;
  double difference = 0.0;
  Deviation onEdges;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id corner = piece.corners[k];
    const double distance = this->distances_.atPoint(corner);
    linear.corners[k] = this->triangles_.inPlane(corner, face.face());
    linear.values[k] = this->distances_.atPoint(corner, face, linear.corners[k]);
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
  const ErrorInside inside = this->error_.of(face, linear, onEdges, result.limit, tight || small);
  const double own = std::max(inside.bound, onEdges.largest());
  result.bound = own + rounding + difference;
  result.sample = inside.sample;
  result.passed = small || own <= result.limit;
  return result;
}

}
