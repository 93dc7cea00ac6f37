// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceShape_h
#define geodesic_FaceShape_h

#include "Tolerance.h"
#include "Types.h"

#include <algorithm>
#include <array>

namespace geodesic
{

/// The metric of one face, as unfolding needs it. It is computed from differences of coordinates
/// and so stays accurate in needles; lengths alone would lose half the digits.
struct FaceShape
{
  /// Length of halfedge k, from corner k to corner k + 1.
  std::array<double, 3> length;
  /// At corner k: (p[k+1] - p[k]) . (p[k+2] - p[k]).
  std::array<double, 3> cornerDot;
  /// Twice the area.
  double area2;

  std::size_t longestEdge() const
  {
    return static_cast<std::size_t>(
      std::max_element(this->length.begin(), this->length.end()) - this->length.begin());
  }
  double longest() const { return this->length[this->longestEdge()]; }
  double shortest() const { return *std::min_element(this->length.begin(), this->length.end()); }
  /// How far beside an edge the face may have been cut, where a face without area was there
  /// (removeFacesWithoutArea()).
  double roundingOfCuts() const { return tolerance::WithoutArea * this->longest(); }
  /// According to tolerance::ThinFace.
  bool isThin() const
  {
    const auto isLong = [this](double edge)
    { return this->area2 < tolerance::ThinFace * edge * edge; };
    return isLong(this->length[0]) || isLong(this->length[1]) || isLong(this->length[2]);
  }
};

/// The shape of a triangle with these corners.
FaceShape shapeOf(const std::array<Vec3, 3>& corners);

/// Whether a triangle is a segment that is drawn as a face: a needle or a cap.
///
/// \param shape of the corners.
bool isWithoutArea(const FaceShape& shape, const std::array<Vec3, 3>& corners);

/// Whether a triangle without area has two corners at one place.
bool isNeedle(const FaceShape& shape);

}

#endif
