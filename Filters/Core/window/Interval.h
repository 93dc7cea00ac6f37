// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Interval_h
#define geodesic_Interval_h

#include <algorithm>

namespace geodesic
{

/// An interval of a line, empty where it does not end behind its begin. It is cut down by linear
/// conditions, which is how pencils of rays are cut to what a halfedge or a segment sees of them.
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

  /// Moves both ends outwards by the margin, but not out of [0, length]; empty stays empty.
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
