// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointGrid_h
#define geodesic_PointGrid_h

#include "PolyData/Hash.h"
#include "Types.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// Finds items near a place, by hashed cubes. The edges of cubes are powers of two, and items with
/// a small reach lie in small cubes, so that the coarse coordinates of one block do not crowd the
/// fine ones of another into one cube.
class PointGrid
{
public:
  /// Adds an item at a place. An item may have several places; those in one cube count once if they
  /// are added one after another.
  ///
  /// \param reach how far from the place the item has to be found.
  void add(const Vec3& place, double reach, std::size_t item)
  {
    const int level = *this->levels_.insert(levelFor(reach)).first;
    std::vector<std::size_t>& items = this->items_[cubeAt(place, level, 0.0)];
    if (items.empty() || items.back() != item)
    {
      items.push_back(item);
    }
  }

  /// Calls visit(item) for all items that have the place within their reach, if that is as large as
  /// the least reach, and for some others nearby.
  template <typename Visit>
  void visitNear(const Vec3& place, double leastReach, const Visit& visit) const
  {
    const auto least = this->levels_.lower_bound(levelFor(leastReach));
    for (auto level = least; level != this->levels_.end(); ++level)
    {
      // The eight cubes that hold all places whose coordinates differ by half a cube at most.
      const Cube low = cubeAt(place, *level, -0.5);
      for (std::int64_t side = 0; side < 8; ++side)
      {
        const auto found = this->items_.find(
          { low[0] + (side & 1), low[1] + (side >> 1 & 1), low[2] + (side >> 2), low[3] });
        for (std::size_t i = 0; found != this->items_.end() && i < found->second.size(); ++i)
        {
          visit(found->second[i]);
        }
      }
    }
  }

  /// The edge of the cubes in which items with a reach lie: at least twice the reach.
  static double cubeFor(double reach) { return std::ldexp(1.0, levelFor(reach)); }

private:
  /// The coordinates of a cube in cubes, and the exponent of its edge.
  using Cube = std::array<std::int64_t, 4>;

  static int levelFor(double reach) { return std::ilogb(reach) + 2; }

  static Cube cubeAt(const Vec3& place, int level, double shift)
  {
    Cube cube = { 0, 0, 0, level };
    for (std::size_t k = 0; k < 3; ++k)
    {
      cube[k] = static_cast<std::int64_t>(std::floor(std::ldexp(place[k], -level) + shift));
    }
    return cube;
  }

  std::set<int> levels_;
  std::unordered_map<Cube, std::vector<std::size_t>, Hash> items_;
};

}

#endif
