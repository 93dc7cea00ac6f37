// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowCrossings_h
#define geodesic_WindowCrossings_h

#include "window/Window.h"

namespace geodesic
{

struct Crossings
{
  int count = 0;
  std::array<double, 2> at{};
};

/// The points of (lo, hi) where the distances of two windows are equal (paper, sections 3.3 and
/// 4.2.2, corrected: with different sigma there may be two). No such point is missing, but a point
/// may be found twice or be false, a result of squaring: the caller must compare the distances
/// between the points. Windows that are equal everywhere have none.
Crossings crossings(const Window& a, const Window& b, double lo, double hi);

}

#endif
