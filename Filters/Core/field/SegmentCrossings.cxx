// SPDX-License-Identifier: BSD-3-Clause
#include "field/SegmentCrossings.h"

#include "Tolerance.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

/// The two places where a window has a value, in their order; one of a linear window is infinite.
/// If a window has the value nowhere, the place where it is least.
std::pair<double, double> placesOf(const Window& w, double value)
{
  if (w.isLinear())
  {
    if (w.sourceX == 0.0)
    {
      return { -Infinity, Infinity };
    }
    const double at = (value - w.sigma) / w.sourceX;
    return w.sourceX > 0.0 ? std::make_pair(-Infinity, at) : std::make_pair(at, Infinity);
  }
  const double radius = value - w.sigma;
  const double squared = (radius - w.sourceDepth) * (radius + w.sourceDepth);
  const double half = radius > 0.0 && squared > 0.0 ? std::sqrt(squared) : 0.0;
  return { w.sourceX - half, w.sourceX + half };
}

/// Whether a window dips below the value between its ends, which do not.
bool dipsBelow(const Window& w, double value)
{
  return !w.isLinear() && w.begin < w.sourceX && w.sourceX < w.end &&
    w.sigma + w.sourceDepth < value;
}

} // anonymous namespace

// Windows are convex functions: below a value on an interval, if at all.
void findCrossings(const std::vector<Window>& envelope, double value, bool beginsBelow,
  bool endsBelow, std::vector<SegmentCrossing>& result)
{
  if (envelope.empty() && beginsBelow != endsBelow)
  {
    result.push_back({ 0.0, beginsBelow });
  }
  // Where the distance equals the value all along, its rounding must not make crossings.
  const double clearly =
    envelope.empty() ? value : value - tolerance::Evaluation * (value + envelope.back().end);
  bool below = beginsBelow;
  for (std::size_t i = 0; i < envelope.size(); ++i)
  {
    const Window& w = envelope[i];
    const bool belowNext =
      i + 1 < envelope.size() ? w.distance(w.end) < (below ? value : clearly) : endsBelow;
    const auto [before, behind] = placesOf(w, value);
    const bool dips = !below && !belowNext && dipsBelow(w, clearly);
    if ((!below && belowNext) || dips)
    {
      result.push_back({ std::clamp(before, w.begin, w.end), false });
    }
    if ((below && !belowNext) || dips)
    {
      result.push_back({ std::clamp(behind, w.begin, w.end), true });
    }
    below = belowNext;
  }
}

}
