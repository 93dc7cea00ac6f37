// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceRange_h
#define geodesic_DistanceRange_h

#include "Tolerance.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <vector>

namespace geodesic
{

/// Bounds of the distance in a face or on an edge, from the distances at its corners and the
/// triangle inequality.
struct DistanceRange
{
  double least;
  double most;

  /// The index of the first of some ascending values that may lie in the range, and the index
  /// behind the last one.
  std::array<std::size_t, 2> indicesIn(const std::vector<double>& values) const
  {
    const auto first = std::lower_bound(values.begin(), values.end(), this->least);
    const auto last = std::upper_bound(first, values.end(), this->most);
    return { static_cast<std::size_t>(first - values.begin()),
      static_cast<std::size_t>(last - values.begin()) };
  }
  bool holdsOneOf(const std::vector<double>& values) const
  {
    const auto [first, last] = this->indicesIn(values);
    return first < last;
  }

  /// The range with a margin for rounding, on an edge or in a face of this length.
  DistanceRange widened(double length) const
  {
    const double margin = tolerance::BoundMargin * (this->least + length);
    return { this->least - margin, this->most + margin };
  }
};

/// The range in a face. A path into a face comes over one of its edges, and goes on to any point
/// from any corner.
///
/// \param atCorners the distances found so far, exact if they are below `certain`.
/// \param certain a lower bound of the length of any path that is still to be found.
/// \param hasSource whether a source lies in the face.
inline DistanceRange rangeInFace(
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
  return range.widened(shape.longest());
}

/// The same on an edge of a face without a source in it. A path to a point of an edge goes on to
/// either of its ends.
inline DistanceRange rangeOnEdge(double length, double atBegin, double atEnd, double certain)
{
  const double least = 0.5 * (std::min(atBegin, certain) + std::min(atEnd, certain) - length);
  return DistanceRange{ std::max(0.0, least), 0.5 * (atBegin + atEnd + length) }.widened(length);
}

}

#endif
