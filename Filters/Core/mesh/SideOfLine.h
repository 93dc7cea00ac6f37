// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SideOfLine_h
#define geodesic_SideOfLine_h

#include "Types.h"

namespace geodesic
{

/// The side of the line from a to b on which c lies: 1 on the left, -1 on the right, 0 on the line.
/// Exact: rounding changes no sign (J. R. Shewchuk: Adaptive Precision Floating-Point Arithmetic
/// and Fast Robust Geometric Predicates, Discrete & Computational Geometry 1997).
int sideOfLine(const Vec2& a, const Vec2& b, const Vec2& c);

}

#endif
