// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LowerWindow_h
#define geodesic_LowerWindow_h

#include "window/Window.h"

namespace geodesic
{

/// Which of two windows is lower in their common interval. One of them has the first part, and the
/// other takes over at each cut.
struct LowerParts
{
  bool firstIsA = true;
  int cuts = 0;
  /// Ascending.
  std::array<double, 2> cut{};
};

/// Whether two windows of a halfedge have the same source, up to rounding, and so are parts of one
/// pencil.
bool isSameSource(const Window& a, const Window& b);

/// Compares the distances of two windows on [lo, hi], which both cover (paper, section 3.3). If
/// they are equal everywhere up to rounding, the first one is the lower.
LowerParts lowerOf(const Window& a, const Window& b, double lo, double hi);

}

#endif
