// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/LinearPiece.h"

#include <algorithm>

namespace geodesic
{

double sizeOf(const LinearPiece& piece)
{
  const std::array<Vec2, 3>& c = piece.corners;
  return std::max({ norm(c[1] - c[0]), norm(c[2] - c[1]), norm(c[0] - c[2]) });
}

Gradient gradientOf(
  double e1e1, double e1e2, double e2e2, double area2, double rise1, double rise2, double longest)
{
  const double scale = 1.0 / (area2 * area2);
  const double alpha = (rise1 * e2e2 - rise2 * e1e2) * scale; // gradient = alpha e1 + beta e2
  const double beta = (rise2 * e1e1 - rise1 * e1e2) * scale;
  Gradient g;
  g.length = std::sqrt(std::max(0.0, alpha * rise1 + beta * rise2));
  const double across1 = -beta * area2; // gradient x e1
  const double across2 = alpha * area2; // gradient x e2
  const auto [least, most] = std::minmax({ 0.0, across1, across2 });
  const double extent = most - least;
  g.chord = extent > 0.0 ? std::min(longest, area2 * g.length / extent) : longest;
  return g;
}

}
