// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Interval_h
#define geodesic_Interval_h

#include <algorithm>

namespace geodesic
{

/// An interval of a line; empty unless its end lies behind its begin. Linear conditions clip it: so
/// pencils of rays are clipped to the part that a halfedge or a segment sees.
struct Interval
{
  double begin;
  double end;

  bool isEmpty() const { return !(this->end > this->begin); }

  /// Keeps the x with c0 + c1 x >= 0.
  void clip(double c0, double c1)
  {
    if (c1 > 0.0)
    {
      this->begin = std::max(this->begin, -c0 / c1);
    }
    else if (c1 < 0.0)
    {
      this->end = std::min(this->end, -c0 / c1);
    }
    else if (c0 < 0.0)
    {
      this->end = this->begin;
    }
  }

  /// Moves both ends outwards by the margin, but not out of [0, length]. An empty interval stays
  /// empty.
  void widen(double margin, double length)
  {
    if (!this->isEmpty())
    {
      this->begin = std::max(0.0, this->begin - margin);
      this->end = std::min(length, this->end + margin);
    }
  }
};

}

#endif
