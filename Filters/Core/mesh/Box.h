// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Box_h
#define geodesic_Box_h

#include "Job.h"
#include "Types.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace geodesic
{

/// The smallest axis-aligned box around some points.
struct Box
{
  Vec3 low{ Infinity, Infinity, Infinity };
  Vec3 high{ -Infinity, -Infinity, -Infinity };

  void add(const Box& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->low[k] = std::min(this->low[k], other.low[k]);
      this->high[k] = std::max(this->high[k], other.high[k]);
    }
  }
  void add(const Vec3& point) { this->add(Box{ point, point }); }

  bool meets(const Box& other) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (other.high[k] < this->low[k] || other.low[k] > this->high[k])
      {
        return false;
      }
    }
    return true;
  }
  bool holds(const Vec3& point) const { return this->meets({ point, point }); }

  /// 0 inside; infinite if the box is empty.
  double distanceTo(const Vec3& point) const
  {
    Vec3 outside;
    for (std::size_t k = 0; k < 3; ++k)
    {
      outside[k] = std::max({ this->low[k] - point[k], point[k] - this->high[k], 0.0 });
    }
    return norm(outside);
  }

  /// The largest absolute coordinates.
  Vec3 largestCoordinates() const
  {
    Vec3 largest;
    for (std::size_t k = 0; k < 3; ++k)
    {
      largest[k] = std::max(std::abs(this->low[k]), std::abs(this->high[k]));
    }
    return largest;
  }
  double largestCoordinate() const
  {
    return geodesic::largestCoordinate(this->largestCoordinates());
  }
};

/// The box of the points of many items, computed in parallel.
///
/// \param addItem adds the points of one item: (Box&, std::size_t item) -> void.
template <typename AddItem>
Box boxOfItems(const Job& job, std::size_t count, const AddItem& addItem)
{
  const std::vector<Box> parts = job.resultsOfRanges(count,
    [&addItem](std::size_t begin, std::size_t end)
    {
      Box part;
      for (std::size_t item = begin; item < end; ++item)
      {
        addItem(part, item);
      }
      return part;
    });
  Box whole;
  for (const Box& part : parts)
  {
    whole.add(part);
  }
  return whole;
}

}

#endif
