// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LowerWindow_h
#define geodesic_LowerWindow_h

#include "window/Window.h"

namespace geodesic
{

/// Which of two windows is lower where both are: the first part belongs to one of them, and at each
/// cut the other takes over.
struct LowerParts
{
  bool firstIsA = true;
  int cuts = 0;
  /// Ascending.
  std::array<double, 2> cut{};
};

/// Whether two windows of a halfedge have the same source, up to rounding: parts of one pencil.
bool isSameSource(const Window& a, const Window& b);

/// Compares the distances of two windows on [lo, hi], which both cover (paper, section 3.3). Where
/// they are equal up to rounding throughout, the first one keeps all.
LowerParts lowerOf(const Window& a, const Window& b, double lo, double hi);

}

#endif
