// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SplitTriangle_h
#define geodesic_SplitTriangle_h

#include "Types.h"

#include <array>
#include <utility>
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

  /// Adds the parts, in the triangle's orientation. Triangles at one place with points at the same
  /// places have the same parts, in whatever order their corners are.
  ///
  /// \param position where any of these points lies: (Id) -> Vec3.
  template <typename Position>
  void cut(const Position& position, std::vector<Triangle>& parts) const
  {
    const std::size_t k = this->edgeToCut(position);
    if (k == 3)
    {
      parts.push_back(this->corners);
      return;
    }
    const std::size_t next = (k + 1) % 3;
    const std::size_t previous = (k + 2) % 3;
    // The middle one from either end.
    const std::size_t count = this->splits[k].size();
    const bool isForward = position(this->corners[k]) < position(this->corners[next]);
    const auto middle = static_cast<std::ptrdiff_t>(isForward ? (count - 1) / 2 : count / 2);
    const auto at = this->splits[k].begin() + middle;
    SplitTriangle{
      { this->corners[k], *at, this->corners[previous] },
      { Splits(this->splits[k].begin(), at), {}, this->splits[previous] }
    }.cut(position, parts);
    SplitTriangle{
      { *at, this->corners[next], this->corners[previous] },
      { Splits(at + 1, this->splits[k].end()), this->splits[next], {} }
    }.cut(position, parts);
  }

private:
  /// The longest edge with splits, for the shapes; 3 if none has any. Of equally long edges the
  /// choice does not depend on the order of the corners, so that copies are cut like the triangle.
  template <typename Position>
  std::size_t edgeToCut(const Position& position) const
  {
    std::size_t best = 3;
    std::pair<double, Vec3> order;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (!this->splits[k].empty())
      {
        const Vec3 from = position(this->corners[k]);
        const Vec3 to = position(this->corners[(k + 1) % 3]);
        const std::pair<double, Vec3> own(norm(to - from), position(this->corners[(k + 2) % 3]));
        if (best == 3 || own > order)
        {
          best = k;
          order = own;
        }
      }
    }
    return best;
  }
};

}

#endif
