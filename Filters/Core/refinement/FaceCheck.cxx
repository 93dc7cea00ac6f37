// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/FaceCheck.h"

#include "Tolerance.h"
#include "refinement/TriangleShape.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

void FaceCheck::enter(const FaceTriangles& face)
{
  this->face_ = &face;
  this->inside_.clear();
  this->distance_.enter(face.face());
}

Deviation FaceCheck::deviationOf(Id a, Id b)
{
  if (this->face_->sideWith(a, b) < 3)
  {
    const PieceOfEdge piece = this->faces_.pieceBetween(*this->face_, a, b);
    const Deviation& deviation = this->faces_.edges[piece.edge].pieces[piece.piece];
    return piece.isReversed ? deviation.reversed() : deviation;
  }
  // From the lower point to the higher one, to the last digit the same from both sides.
  const Id low = std::min(a, b);
  const Id high = std::max(a, b);
  const auto [found, isNew] =
    this->inside_.emplace((static_cast<std::uint64_t>(low) << 32) | high, Deviation());
  if (isNew)
  {
    const FaceTriangles::Point& begin = this->face_->points()[low];
    const FaceTriangles::Point& end = this->face_->points()[high];
    found->second = largestDeviation(this->envelope_.along(this->distance_, begin.place, end.place),
      0.0, norm(end.place - begin.place), begin.here, end.here);
  }
  return b < a ? found->second.reversed() : found->second;
}

// In an approximate field the faces around a point differ by what merging has changed, which no
// refinement can undo. The triangle gets the rest of the tolerance, but at least half of it. A
// triangle as small as the tolerance passes.
FaceCheck::Result FaceCheck::of(const Triangle& corners, bool isTight)
{
  LinearPiece linear;
  double largest = 0.0;
  double difference = 0.0;
  Deviation onSides;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const FaceTriangles::Point& point = this->face_->points()[corners[k]];
    linear.corners[k] = point.place;
    linear.values[k] = point.here;
    largest = std::max(largest, point.distance);
    difference = std::max(difference, std::abs(point.here - point.distance));
    onSides.widen(this->deviationOf(corners[k], corners[(k + 1) % 3]));
  }
  const double rounding = tolerance::FaceRounding * largest;
  const double limit = std::max(this->tolerance_ - difference - rounding, 0.5 * this->tolerance_);
  const bool isSmall = longestEdge(linear.corners) <= limit;
  if (onSides.largest() > limit && !isSmall && !isTight)
  {
    return { false, Infinity, onSides.largest(), limit };
  }
  const ErrorInside inside =
    this->error_.of(this->distance_, linear, onSides, limit, isTight || isSmall);
  const double own = std::max(inside.bound, onSides.largest());
  return { isSmall || own <= limit, own + rounding + difference, inside.sample, limit };
}

}
