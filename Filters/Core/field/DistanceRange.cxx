// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceRange.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

DistanceRange widened(const DistanceRange& range, double length)
{
  const double margin = tolerance::BoundMargin * (range.least + length);
  return { range.least - margin, range.most + margin };
}

} // anonymous namespace

std::array<std::size_t, 2> DistanceRange::indicesIn(const std::vector<double>& values) const
{
  const auto first = std::lower_bound(values.begin(), values.end(), this->least);
  const auto last = std::upper_bound(first, values.end(), this->most);
  return { static_cast<std::size_t>(first - values.begin()),
    static_cast<std::size_t>(last - values.begin()) };
}

bool DistanceRange::holdsOneOf(const std::vector<double>& values) const
{
  const auto [first, last] = this->indicesIn(values);
  return first < last;
}

// A path to a point of an edge goes on to either of its ends.
DistanceRange rangeOnEdge(double length, double atBegin, double atEnd, double certain)
{
  const double least = 0.5 * (std::min(atBegin, certain) + std::min(atEnd, certain) - length);
  return widened({ std::max(0.0, least), 0.5 * (atBegin + atEnd + length) }, length);
}

// A path into a face comes over one of its edges, and goes on to any point from any corner.
DistanceRange rangeInFace(
  const FaceShape& shape, const std::array<double, 3>& atCorners, double certain, bool hasSource)
{
  DistanceRange range{ Infinity, Infinity };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double length = shape.length[k];
    const double longer = std::max(length, shape.length[(k + 2) % 3]);
    const double ends = std::min(atCorners[k], certain) + std::min(atCorners[(k + 1) % 3], certain);
    range.least = std::min(range.least, std::max(0.0, 0.5 * (ends - length)));
    range.most = std::min(range.most, atCorners[k] + longer);
  }
  range.least = hasSource ? 0.0 : range.least;
  return widened(range, shape.longest());
}

}
