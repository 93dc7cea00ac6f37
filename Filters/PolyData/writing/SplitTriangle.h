// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SplitTriangle_h
#define geodesic_SplitTriangle_h

#include "Types.h"

#include <array>
#include <functional>
#include <vector>

namespace geodesic
{

/// A triangle with points on its edges, by which it is cut without any further points.
struct SplitTriangle
{
  using Splits = std::vector<Id>;

  Triangle corners;
  /// On edge k those from corner k to corner k + 1.
  std::array<Splits, 3> splits;
  /// Where any of these points lies.
  std::function<Vec3(Id)> position;

  /// Adds the parts, in the triangle's orientation. Triangles at one place with points at the same
  /// places have the same parts, in whatever order their corners are.
  void cut(std::vector<Triangle>& parts) const;

  /// How many parts there are.
  std::size_t count() const
  {
    return 1 + this->splits[0].size() + this->splits[1].size() + this->splits[2].size();
  }

private:
  std::size_t edgeToCut() const;
};

}

#endif
