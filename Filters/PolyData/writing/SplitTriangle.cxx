// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/SplitTriangle.h"

#include <utility>

namespace geodesic
{

/// The longest that has splits, for the shapes; 3 where none has. Of equally long ones that which
/// any order of the corners gives, so that copies of a triangle are cut as it is.
std::size_t SplitTriangle::edgeToCut() const
{
  std::size_t best = 3;
  std::pair<double, Vec3> order;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!this->splits[k].empty())
    {
      const Vec3 from = this->position(this->corners[k]);
      const Vec3 to = this->position(this->corners[(k + 1) % 3]);
      const std::pair<double, Vec3> own(
        norm(to - from), this->position(this->corners[(k + 2) % 3]));
      if (best == 3 || own > order)
      {
        best = k;
        order = own;
      }
    }
  }
  return best;
}

void SplitTriangle::cut(std::vector<Triangle>& parts) const
{
  const std::size_t k = this->edgeToCut();
  if (k == 3)
  {
    parts.push_back(this->corners);
    return;
  }
  const std::size_t next = (k + 1) % 3;
  const std::size_t previous = (k + 2) % 3;
  // The middle one from either end.
  const std::size_t count = this->splits[k].size();
  const bool isForward = this->position(this->corners[k]) < this->position(this->corners[next]);
  const auto middle = static_cast<std::ptrdiff_t>(isForward ? (count - 1) / 2 : count / 2);
  const auto at = this->splits[k].begin() + middle;
  SplitTriangle{ { this->corners[k], *at, this->corners[previous] },
    { Splits(this->splits[k].begin(), at), {}, this->splits[previous] }, this->position }
    .cut(parts);
  SplitTriangle{ { *at, this->corners[next], this->corners[previous] },
    { Splits(at + 1, this->splits[k].end()), this->splits[next], {} }, this->position }
    .cut(parts);
}

}
