// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinedMesh.h"

namespace geodesic
{

namespace
{

std::uint64_t keyOf(const RefinedPoint& point)
{
  return (static_cast<std::uint64_t>(point.parents[0]) << 32) | point.parents[1];
}

} // anonymous namespace

Id SplitPointNumbering::numberOf(const RefinedPoint& point)
{
  if (this->numbers_.empty()) // numbers the points that the mesh already had
  {
    Id number = this->mesh_.numberOfInputPoints;
    for (const RefinedPoint& known : this->mesh_.points)
    {
      this->numbers_.emplace(keyOf(known), number++);
    }
  }
  const auto [found, isNew] = this->numbers_.emplace(keyOf(point), this->numberOfNext());
  if (isNew)
  {
    this->mesh_.points.push_back(point);
  }
  return found->second;
}

}
