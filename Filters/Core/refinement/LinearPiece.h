// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LinearPiece_h
#define geodesic_LinearPiece_h

#include "Types.h"

#include <array>

namespace geodesic
{

/// A triangle of the plane with a linear function, given by its values at the corners.
struct LinearPiece
{
  std::array<Vec2, 3> corners;
  std::array<double, 3> values;
};

/// The length of its longest edge.
double sizeOf(const LinearPiece& piece);

/// The gradient of a linear function on a triangle.
struct Gradient
{
  double length;
  /// The longest way through the triangle in the gradient's direction.
  double chord;
};

/// The edges e1 and e2 from corner 0 are given by their dot products, the function by its rise
/// along each.
///
/// \param area2 twice the area, positive.
/// \param longest the triangle's longest edge.
Gradient gradientOf(
  double e1e1, double e1e2, double e2e2, double area2, double rise1, double rise2, double longest);

}

#endif
