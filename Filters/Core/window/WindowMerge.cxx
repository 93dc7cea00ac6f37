// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowMerge.h"

#include "Tolerance.h"

namespace geodesic
{

namespace
{

/// Values of a window at one of its ends, which share one square root.
struct EndValues
{
  double distance;
  /// The slope of the distance there as a fraction. For a circular window, the source's offset and
  /// its radius.
  double rise;
  double run;
};

/// A window of the list with the values at its ends, each of which is used several times.
struct MeasuredWindow
{
  Window* window;
  EndValues begin;
  EndValues end;
};

MeasuredWindow measured(Window& w)
{
  if (w.isLinear())
  {
    return { &w, { w.distance(w.begin), w.sourceX, 1.0 }, { w.distance(w.end), w.sourceX, 1.0 } };
  }
  const TwoDoubles dx = w.endDirections();
  const TwoDoubles depth(w.sourceDepth);
  const TwoDoubles radii = TwoDoubles::roots(dx * dx + depth * depth);
  return { &w, { w.sigma + radii.first(), dx.first(), radii.first() },
    { w.sigma + radii.second(), dx.second(), radii.second() } };
}

// Window::minimum() without a square root.
double minimum(const Window& w, const EndValues& begin, const EndValues& end)
{
  if (w.isLinear())
  {
    return w.sourceX > 0.0 ? begin.distance : end.distance;
  }
  return w.sourceX <= w.begin ? begin.distance
    : w.sourceX >= w.end      ? end.distance
                              : w.sigma + w.sourceDepth;
}

struct MergeLimits
{
  double relativeError;
  double maximumAdded;
};

/// Two neighbours that meet at `joint`, and the properties that a merged window must keep.
struct Neighbours
{
  const MeasuredWindow& left;
  const MeasuredWindow& right;
  double begin = this->left.window->begin;
  double joint = this->right.window->begin;
  double end = this->right.window->end;
  double width = this->end - this->begin;
  double atBegin = this->left.begin.distance;
  double atEnd = this->right.end.distance;
  /// The smaller of the two distances at the joint.
  double atJoint = std::min(this->left.end.distance, this->right.begin.distance);
  double rise = this->atEnd - this->atBegin;
  double open = (this->width - this->rise) * (this->width + this->rise);
  /// The larger of the two windows' errors.
  double inherited = std::max(this->left.window->error, this->right.window->error);
  /// The least distance of the two, which the merged window's least distance may not exceed.
  double least = std::min(minimum(*this->left.window, this->left.begin, this->left.end),
    minimum(*this->right.window, this->right.begin, this->right.end));
};

// The largest distance r0 of a merged source from the interval's begin for which the merged
// distance is nowhere above the two originals. Sources at distances r0 and r0 + rise from the ends
// are a one-parameter family; the farther the source, the flatter the function. The merged function
// is below everywhere if it is below at the joint and no steeper outwards at the ends: the
// difference of two such functions has at most two zeros, and one is at the end already.
double farthestRadius(const Neighbours& p)
{
  double radius = Infinity;
  // slope at begin: rise / width - open / (2 width r0), by the law of cosines
  const EndValues& begin = p.left.begin;
  const double overLeft = p.rise * begin.run - p.width * begin.rise;
  if (overLeft > 0.0)
  {
    radius = std::min(radius, p.open * begin.run / (2.0 * overLeft));
  }
  // slope at end: rise / width + open / (2 width r1), with r1 = r0 + rise
  const EndValues& end = p.right.end;
  const double overRight = p.width * end.rise - p.rise * end.run;
  if (overRight > 0.0)
  {
    radius = std::min(radius, p.open * end.run / (2.0 * overRight) - p.rise);
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

// How far the original may be above the merged window inside its interval; -Infinity if the gap is
// largest at an end. The difference original - merged has its only inner extremum where both rays
// have the same direction. That point lies on the line through the two sources, and the extremum is
// a maximum if the merged source is the nearer one.
double innerGap(const Window& original, const Window& merged)
{
  if (merged.isLinear())
  {
    return -Infinity; // both are linear
  }
  const double apart = merged.sourceX - original.sourceX;
  const double depth = original.sourceDepth - merged.sourceDepth;
  if (original.isLinear())
  {
    // the corrected extremum of section 6.2
    const double x = original.sourceX * merged.sourceDepth;
    const bool isInside = (original.begin - merged.sourceX) * original.sourceDepth < x &&
      x < (original.end - merged.sourceX) * original.sourceDepth;
    return isInside
      ? original.straightDistance({ merged.sourceX, -merged.sourceDepth }) - merged.sigma
      : -Infinity;
  }
  const double x = apart * original.sourceDepth;
  const bool isInside = (original.begin - original.sourceX) * depth < x &&
    x < (original.end - original.sourceX) * depth;
  return depth > 0.0 && isInside
    ? original.sigma - merged.sigma + std::sqrt(apart * apart + depth * depth)
    : -Infinity;
}

/// A merged window that has yet to be checked against the limits.
struct MergedWindow
{
  Window window;
  double atJoint;
};

// Whether the merged window is within the limits, given the gap at the joint.
bool isWithin(const Neighbours& p, const MergeLimits& limits, double added, double atJoint)
{
  const double gapLeft = p.left.end.distance - atJoint;
  const double gapRight = p.right.begin.distance - atJoint;
  return p.inherited + std::max(gapLeft, gapRight) <= limits.relativeError * p.least &&
    added + gapLeft <= limits.maximumAdded && gapRight <= limits.maximumAdded;
}

bool mergeLinear(const Neighbours& p, MergedWindow& merged)
{
  Window& w = merged.window;
  w = *p.left.window;
  w.sourceX = p.rise / p.width;
  w.sourceDepth = std::sqrt(std::max(0.0, (1.0 - w.sourceX) * (1.0 + w.sourceX)));
  w.sigma = p.atBegin - w.sourceX * p.begin;
  merged.atJoint = w.distance(p.joint);
  // otherwise the rays diverge, and another window belongs between them
  return merged.atJoint <= p.atJoint;
}

bool mergeCircular(
  const Neighbours& p, const MergeLimits& limits, double added, MergedWindow& merged)
{
  // The distance of a pseudo-source cannot be negative.
  const double radius = std::min(farthestRadius(p), p.atBegin);
  if (!(radius > 0.0) || !(radius + p.rise > 0.0))
  {
    return false;
  }
  // begin - sourceX, from the two radii
  const double offset = (2.0 * radius * p.rise - p.open) / (2.0 * p.width);
  const double depth2 = (radius - offset) * (radius + offset);
  const double leastDepth = tolerance::MergedDepth * p.width;
  const double dx = p.joint - p.begin + offset;
  const double sigma = p.atBegin - radius;
  merged.atJoint = sigma + std::sqrt(dx * dx + depth2);
  if (!(depth2 > leastDepth * leastDepth) || !isWithin(p, limits, added, merged.atJoint))
  {
    return false;
  }
  Window& w = merged.window;
  w = *p.left.window;
  w.kind = Window::Kind::Circular;
  w.sourceX = p.begin - offset;
  w.sourceDepth = std::sqrt(depth2);
  w.sigma = sigma;
  return true;
}

/// Merges the right window into the left one if the limits allow.
///
/// \param added how far the left window, if itself merged, may be below the windows that it
///        replaced; updated for the new window.
bool merge(
  MeasuredWindow& left, const MeasuredWindow& right, const MergeLimits& limits, double& added)
{
  const Neighbours p{ left, right };
  if (!(limits.relativeError * p.least > p.inherited) || !(std::abs(p.rise) < p.width))
  {
    return false;
  }
  MergedWindow merged;
  const bool isLinear = left.window->isLinear() && right.window->isLinear();
  if (!(isLinear ? mergeLinear(p, merged) : mergeCircular(p, limits, added, merged)))
  {
    return false;
  }
  Window& w = merged.window;
  w.end = p.end;
  w.facesCrossed =
    std::max<Id>(left.window->facesCrossed, right.window->facesCrossed) & MaximumFacesCrossed;
  w.forgetUnlessCrossedBy(*right.window);
  MeasuredWindow ends = measured(w);
  EndValues& begin = ends.begin;
  EndValues& end = ends.end;
  // Rounding may leave the merged window above an end by some units in the last place.
  const double excess = std::max(0.0, std::max(begin.distance - p.atBegin, end.distance - p.atEnd));
  w.sigma -= excess;
  begin.distance = isLinear ? w.distance(p.begin) : w.sigma + begin.run;
  end.distance = isLinear ? w.distance(p.end) : w.sigma + end.run;
  merged.atJoint -= excess;
  const double gapLeft = std::max(
    { p.atBegin - begin.distance, left.end.distance - merged.atJoint, innerGap(*left.window, w) });
  const double gapRight = std::max(
    { right.begin.distance - merged.atJoint, p.atEnd - end.distance, innerGap(*right.window, w) });
  w.error = p.inherited + std::max(gapLeft, gapRight);
  const double addedNow = std::max(added + gapLeft, gapRight);
  if (!(w.error <= limits.relativeError * minimum(w, begin, end)) ||
    !(addedNow <= limits.maximumAdded))
  {
    return false;
  }
  added = addedNow;
  *left.window = w;
  left.begin = begin;
  left.end = end;
  return true;
}

} // anonymous namespace

double mergeNeighbours(
  WindowBlock& list, double edgeLength, double relativeError, double maximumAdded)
{
  if (list.size < 2)
  {
    return 0.0;
  }
  const MergeLimits limits = { relativeError, maximumAdded };
  double largest = 0.0;
  double added = 0.0; // by the last window
  Window* last = list.data;
  MeasuredWindow left = measured(*last);
  for (std::uint32_t i = 1; i < list.size; ++i)
  {
    const MeasuredWindow right = measured(list.data[i]);
    const bool meet = right.window->begin - last->end <= tolerance::LeastWidth * edgeLength;
    if (meet && merge(left, right, limits, added))
    {
      largest = std::max(largest, last->error / minimum(*last, left.begin, left.end));
      continue;
    }
    ++last;
    if (last != right.window)
    {
      *last = *right.window;
    }
    left = { last, right.begin, right.end };
    added = 0.0;
  }
  list.size = static_cast<std::uint32_t>(last - list.data) + 1;
  return largest;
}

}
