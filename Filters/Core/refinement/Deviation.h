// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Deviation_h
#define geodesic_Deviation_h

#include "window/Window.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

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
/// function between two end values (paper, section 6.2, with the extremum corrected: a^2 <= 1).
Deviation largestDeviation(
  const std::vector<Window>& envelope, double length, double atBegin, double atEnd);

/// Where to split an edge whose largest deviation is at the fraction t: the table of section 6.2.
double splitPosition(double t);

}

#endif
