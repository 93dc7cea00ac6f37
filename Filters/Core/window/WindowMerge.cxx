// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowMerge.h"

#include "Tolerance.h"

namespace geodesic
{

namespace
{

/// Two neighbours that meet at `joint`, and what a merged window must keep.
struct Pair
{
  const Window& left;
  const Window& right;
  double begin;
  double joint;
  double end;
  double width;
  double atBegin;
  double atEnd;
  /// Least of the two distances at the joint.
  double atJoint;
  /// atEnd - atBegin.
  double rise;
};

Pair makePair(const Window& left, const Window& right)
{
  const double joint = right.begin;
  const double atBegin = left.distance(left.begin);
  const double atEnd = right.distance(right.end);
  return { left, right, left.begin, joint, right.end, right.end - left.begin, atBegin, atEnd,
    std::min(left.distance(joint), right.distance(joint)), atEnd - atBegin };
}

double slope(const Window& w, double x)
{
  if (w.isLinear())
  {
    return w.sourceX;
  }
  const double dx = x - w.sourceX;
  return dx / std::sqrt(dx * dx + w.sourceDepth * w.sourceDepth);
}

// The largest distance r0 of a merged source from the interval's begin for which the merged
// distance is nowhere above the two originals. Sources at distances r0 and r0 + rise from the ends
// are a one-parameter family; the farther, the flatter. The merged function is below throughout
// when it is at the joint and is not steeper outwards at the ends: a difference of two such
// functions has no more than two zeros, and one is at the end already.
double farthestRadius(const Pair& p)
{
  double radius = Infinity;
  const double chord = p.rise / p.width;
  const double open = (p.width - p.rise) * (p.width + p.rise);
  // slope at begin: chord - open / (2 width r0), by the law of cosines
  const double leftSlope = slope(p.left, p.begin);
  if (chord > leftSlope)
  {
    radius = std::min(radius, open / (2.0 * p.width * (chord - leftSlope)));
  }
  // slope at end: chord + open / (2 width r1), with r1 = r0 + rise
  const double rightSlope = slope(p.right, p.end);
  if (rightSlope > chord)
  {
    radius = std::min(radius, open / (2.0 * p.width * (rightSlope - chord)) - p.rise);
  }
  // at the joint, by Stewart's theorem
  const double t = (p.joint - p.begin) / p.width;
  const double kappa = p.atJoint - p.atBegin;
  const double onChord = t * p.rise;
  if (kappa < onChord)
  {
    const double numerator = kappa * kappa - onChord * p.rise + t * (1.0 - t) * p.width * p.width;
    radius = std::min(radius, numerator / (2.0 * (onChord - kappa)));
  }
  return radius;
}

Window circularThrough(const Pair& p, double radius)
{
  // begin - sourceX, from the two radii
  const double offset =
    (2.0 * radius * p.rise - (p.width - p.rise) * (p.width + p.rise)) / (2.0 * p.width);
  Window w = p.left;
  w.kind = Window::Kind::Circular;
  w.sourceX = p.begin - offset;
  w.sourceDepth = std::sqrt(std::max(0.0, (radius - offset) * (radius + offset)));
  w.sigma = p.atBegin - radius;
  return w;
}

Window linearThrough(const Pair& p)
{
  Window w = p.left;
  w.kind = Window::Kind::Linear;
  w.sourceX = p.rise / p.width;
  w.sourceDepth = std::sqrt(std::max(0.0, (1.0 - w.sourceX) * (1.0 + w.sourceX)));
  w.sigma = p.atBegin - w.sourceX * p.begin;
  return w;
}

// The difference original - merged has its only inner extremum where both rays have one direction.
double extremum(const Window& original, const Window& merged)
{
  if (original.isLinear() && merged.isLinear())
  {
    return -Infinity;
  }
  if (original.isLinear() || merged.isLinear())
  {
    const Window& line = original.isLinear() ? original : merged;
    const Window& circle = original.isLinear() ? merged : original;
    // the corrected extremum of section 6.2
    return circle.sourceX + line.sourceX * circle.sourceDepth / line.sourceDepth;
  }
  const double depth = original.sourceDepth - merged.sourceDepth;
  return original.sourceX + (merged.sourceX - original.sourceX) * original.sourceDepth / depth;
}

double largestGap(const Window& original, const Window& merged)
{
  const auto gap = [&](double x) { return original.distance(x) - merged.distance(x); };
  double largest = std::max(gap(original.begin), gap(original.end));
  const double x = extremum(original, merged);
  if (x > original.begin && x < original.end)
  {
    largest = std::max(largest, gap(x));
  }
  return largest;
}

// Rounding may leave the merged window above an end by some units in the last place.
void lowerToEnds(Window& w, const Pair& p)
{
  const double excess = std::max(w.distance(p.begin) - p.atBegin, w.distance(p.end) - p.atEnd);
  w.sigma -= std::max(excess, 0.0);
}

/// \param added how far the left window, itself merged, may be below what it replaced; becomes that
///        of the merged one.
bool merge(const Window& left, const Window& right, double relativeError, double maximumAdded,
  double& added, Window& merged)
{
  const Pair p = makePair(left, right);
  const double inherited = std::max(left.error, right.error);
  const double least = std::min(left.minimum(), right.minimum());
  if (!(relativeError * least > inherited) || !(std::abs(p.rise) < p.width))
  {
    return false;
  }
  if (left.isLinear() && right.isLinear())
  {
    merged = linearThrough(p);
    if (merged.distance(p.joint) > p.atJoint)
    {
      return false; // the rays diverge: something else belongs between them
    }
  }
  else
  {
    // A pseudo-source has no negative distance of its own.
    const double radius = std::min(farthestRadius(p), p.atBegin);
    if (!(radius > 0.0) || !(radius + p.rise > 0.0))
    {
      return false;
    }
    merged = circularThrough(p, radius);
    if (!(merged.sourceDepth > tolerance::MergedDepth * p.width))
    {
      return false;
    }
  }
  merged.begin = p.begin;
  merged.end = p.end;
  merged.facesCrossed = std::max<Id>(left.facesCrossed, right.facesCrossed) & MaximumFacesCrossed;
  lowerToEnds(merged, p);
  const double gapLeft = largestGap(left, merged);
  const double gapRight = largestGap(right, merged);
  merged.error = inherited + std::max(gapLeft, gapRight);
  added = std::max(added + gapLeft, gapRight);
  return merged.error <= relativeError * merged.minimum() && added <= maximumAdded;
}

} // anonymous namespace

double mergeNeighbours(
  std::vector<Window>& windows, double edgeLength, double relativeError, double maximumAdded)
{
  double largest = 0.0;
  double added = 0.0; // of the last window
  std::size_t last = 0;
  for (std::size_t i = 1; i < windows.size(); ++i)
  {
    Window merged;
    double addedNow = added;
    const bool meet = windows[i].begin - windows[last].end <= tolerance::LeastWidth * edgeLength;
    if (meet && merge(windows[last], windows[i], relativeError, maximumAdded, addedNow, merged))
    {
      windows[last] = merged;
      added = addedNow;
      largest = std::max(largest, merged.error / merged.minimum());
    }
    else
    {
      windows[++last] = windows[i];
      added = 0.0;
    }
  }
  windows.resize(windows.empty() ? 0 : last + 1);
  return largest;
}

}
