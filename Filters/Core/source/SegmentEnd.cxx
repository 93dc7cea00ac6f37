// SPDX-License-Identifier: BSD-3-Clause
#include "source/SegmentEnd.h"

namespace geodesic
{

// Segment i runs from point i to point i + 1.
std::vector<SegmentEnd> segmentEndsAt(const TriangleMesh& mesh, const SourceCurve& curve, Id number,
  const std::vector<double>& places, std::size_t i)
{
  const std::size_t count = curve.points.size();
  std::vector<SegmentEnd> ends;
  const auto add = [&](std::size_t to, std::size_t segment)
  {
    if (!samePlace(mesh, curve.points[i], curve.points[to]))
    {
      ends.push_back({ curve.points[i], curve.points[to], curve.faces[segment], number, places[i],
        to > segment });
    }
  };
  if (i + 1 < count)
  {
    add(i + 1, i);
  }
  if (i > 0 || curve.isClosed())
  {
    const std::size_t before = i > 0 ? i - 1 : count - 2;
    add(before, before);
  }
  return ends;
}

}
