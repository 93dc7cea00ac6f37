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
  /// Distance minus interpolant, >= 0, and where, as a fraction of the length.
  double above = 0.0;
  double aboveAt = 0.5;
  /// Interpolant minus distance, >= 0, and where.
  double below = 0.0;
  double belowAt = 0.5;

  double largest() const { return std::max(this->above, this->below); }
  /// Where the larger one is.
  double at() const { return this->above >= this->below ? this->aboveAt : this->belowAt; }

  /// Takes the larger values of both.
  void widen(const Deviation& other);
};

/// The largest deviations of a distance, given as windows that cover [0, length], from the linear
/// function between two end values.
Deviation largestDeviation(
  const std::vector<Window>& envelope, double length, double atBegin, double atEnd);

/// Where to split an edge whose largest deviation is at the fraction t: the table of section 6.2.
double splitPosition(double t);

}

#endif
