// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Deviation_h
#define geodesic_Deviation_h

#include "window/Window.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace geodesic
{

/// The linear function between two values at the ends of a segment.
struct LineOnSegment
{
  double atBegin;
  double slope;
  /// The sine of the angle between the segment and rays whose distance rises like the line; 0 if
  /// the line is as steep as a ray along the segment, or steeper.
  double sine;

  /// \param length positive.
  LineOnSegment(double length, double valueAtBegin, double valueAtEnd)
    : atBegin(valueAtBegin)
    , slope((valueAtEnd - valueAtBegin) / length)
    , sine(std::sqrt(std::max(0.0, (1.0 - slope) * (1.0 + slope))))
  {
  }

  double at(double x) const { return this->atBegin + this->slope * x; }
  /// Where in a window its distance, less the line, is least (paper, section 6.2, with the extremum
  /// corrected: a^2 <= 1).
  double lowestOf(const Window& w) const
  {
    if (w.isLinear())
    {
      return w.sourceX > this->slope ? w.begin : w.end;
    }
    if (!(this->sine > 0.0))
    {
      return this->slope > 0.0 ? w.end : w.begin;
    }
    return std::clamp(w.sourceX + this->slope / this->sine * w.sourceDepth, w.begin, w.end);
  }
};

/// The largest differences between a distance along a segment and its linear interpolant.
struct Deviation
{
  /// Distance minus interpolant, >= 0.
  double above = 0.0;
  /// Interpolant minus distance, >= 0.
  double below = 0.0;
  /// Where the larger one is, as a fraction of the length.
  double at = 0.5;

  /// What has not been measured yet.
  static Deviation unknown() { return { -1.0, -1.0 }; }
  bool isKnown() const { return this->above >= 0.0; }
  double largest() const { return std::max(this->above, this->below); }
  /// The same from the other end.
  Deviation reversed() const { return { this->above, this->below, 1.0 - this->at }; }

  /// Takes the larger values of both.
  void widen(const Deviation& other)
  {
    this->at = other.largest() > this->largest() ? other.at : this->at;
    this->above = std::max(this->above, other.above);
    this->below = std::max(this->below, other.below);
  }
};

/// The largest deviations of a distance, given as windows that cover a segment, from the linear
/// function between the values at two of its places.
inline Deviation largestDeviation(
  const std::vector<Window>& envelope, double from, double to, double atFrom, double atTo)
{
  Deviation deviation;
  const double length = to - from;
  if (!(length > 0.0))
  {
    return deviation;
  }
  const LineOnSegment line(length, atFrom, atTo);
  const auto look = [&](const Window& w, double x)
  {
    const double e = w.distance(x) - line.at(x - from);
    deviation.widen({ std::max(e, 0.0), std::max(-e, 0.0), (x - from) / length });
  };
  auto w = std::partition_point(
    envelope.begin(), envelope.end(), [from](const Window& before) { return before.end <= from; });
  for (; w != envelope.end() && w->begin < to; ++w)
  {
    const double begin = std::max(w->begin, from);
    const double end = std::min(w->end, to);
    look(*w, begin);
    look(*w, end);
    const double lowest = line.lowestOf(*w);
    if (lowest > begin && lowest < end)
    {
      look(*w, lowest);
    }
  }
  return deviation;
}

/// Where to split an edge whose largest deviation is at the fraction t: the table of section 6.2.
inline double splitPosition(double t)
{
  if (t < 0.25)
  {
    return std::max(0.25, 2.0 * t);
  }
  return t > 0.75 ? std::min(0.75, 2.0 * t - 1.0) : t;
}

}

#endif
