// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/TrianglePoints.h"

#include <algorithm>

namespace geodesic
{

Id TrianglePoints::like(Id point)
{
  const Id inputPoints = this->refined_.numberOfInputPoints;
  if (point < inputPoints)
  {
    const auto corner =
      std::find(this->vertices_.begin(), this->vertices_.end(), this->surface_.vertexOf(point));
    return this->corners_[static_cast<std::size_t>(corner - this->vertices_.begin())];
  }
  RefinedPoint copy = this->refined_.points[point - inputPoints];
  const std::array<Id, 2> parents = copy.parents;
  copy.parents = { this->like(parents[0]), this->like(parents[1]) };
  return copy.parents == parents ? point : this->numbering_.numberOf(copy);
}

}
