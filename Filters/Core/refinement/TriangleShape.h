// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleShape_h
#define geodesic_TriangleShape_h

#include "Trigonometry.h"
#include "Types.h"

#include <algorithm>
#include <array>
#include <cmath>

/// Measures of a triangle of the plane, given by its corners.
namespace geodesic
{

/// Number k is that of the side from corner k to corner k + 1.
inline std::array<double, 3> lengthsOf(const std::array<Vec2, 3>& c)
{
  return { norm(c[1] - c[0]), norm(c[2] - c[1]), norm(c[0] - c[2]) };
}

/// The first of the longest sides.
///
/// \param lengths of the sides, from lengthsOf().
inline std::size_t longestSide(const std::array<double, 3>& lengths)
{
  return static_cast<std::size_t>(
    std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
}

inline double longestEdge(const std::array<Vec2, 3>& c)
{
  const std::array<double, 3> lengths = lengthsOf(c);
  return *std::max_element(lengths.begin(), lengths.end());
}

/// In radians.
inline double smallestAngle(const std::array<Vec2, 3>& c)
{
  const auto angleBetween = [](Vec2 a, Vec2 b) {
    return polarAngle({ dot(a, b), std::abs(cross(a, b)) });
  };
  return std::min({ angleBetween(c[1] - c[0], c[2] - c[0]), angleBetween(c[2] - c[1], c[0] - c[1]),
    angleBetween(c[0] - c[2], c[1] - c[2]) });
}

}

#endif
