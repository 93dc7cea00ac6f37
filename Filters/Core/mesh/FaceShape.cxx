// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/FaceShape.h"

namespace geodesic
{

FaceShape shapeOf(const std::array<Vec3, 3>& corners)
{
  std::array<Vec3, 3> edge;
  FaceShape shape;
  for (std::size_t k = 0; k < 3; ++k)
  {
    edge[k] = corners[(k + 1) % 3] - corners[k];
    shape.length[k] = norm(edge[k]);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    shape.cornerDot[k] = -dot(edge[k], edge[(k + 2) % 3]);
  }
  // The three cross products are equal; that of the two shorter edges has the least rounding.
  const std::size_t longest = shape.longestEdge();
  shape.area2 = norm(cross(edge[(longest + 1) % 3], edge[(longest + 2) % 3]));
  return shape;
}

// A corner that was put onto the edge of the others has been rounded as coordinates are.
bool isWithoutArea(const FaceShape& shape, const std::array<Vec3, 3>& corners)
{
  const double longest = shape.longest();
  if (shape.area2 <= tolerance::WithoutArea * longest * longest)
  {
    return true;
  }
  const double largest = std::max({ largestCoordinate(corners[0]), largestCoordinate(corners[1]),
    largestCoordinate(corners[2]) });
  const double rounding = std::min(tolerance::SnapRoundings * tolerance::Rounding * largest,
    tolerance::SnapFraction * shape.shortest());
  const std::size_t apex = (shape.longestEdge() + 2) % 3;
  return shape.cornerDot[apex] < 0.0 && shape.area2 <= rounding * longest;
}

bool isNeedle(const FaceShape& shape)
{
  return shape.shortest() <= tolerance::WithoutArea * shape.longest();
}

}
