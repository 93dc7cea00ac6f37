// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LowerWindow_h
#define geodesic_LowerWindow_h

#include "Tolerance.h"
#include "window/Window.h"

#include <array>
#include <cmath>

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
inline bool isSameSource(const Window& a, const Window& b)
{
  // A linear window's source is a direction, and its distance depends on where it crosses the
  // halfedge. Different sources, or different parameters of one curve, may unfold to the same point
  // of the plane.
  const double source = std::abs(a.sourceX) + a.sourceDepth;
  const double length = a.isLinear() ? b.end : source;
  return a.origin == b.origin && a.kind == b.kind &&
    std::abs(a.sourceX - b.sourceX) <= tolerance::SameSource * source &&
    (!a.isLinear() ||
      std::abs(a.start.parameter() - b.start.parameter()) <=
        tolerance::SameSource * (std::abs(a.start.parameter()) + length)) &&
    std::abs(a.sourceDepth - b.sourceDepth) <= tolerance::SameSource * source &&
    std::abs(a.sigma - b.sigma) <= tolerance::SameSource * (std::abs(a.sigma) + length);
}

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

/// Compares the distances of two windows on [lo, hi], which both cover (paper, section 3.3). If
/// they are equal everywhere up to rounding, the first one is the lower.
LowerParts lowerOf(const Window& a, const Window& b, double lo, double hi);

}

#endif
