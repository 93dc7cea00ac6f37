// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SegmentCrossings_h
#define geodesic_SegmentCrossings_h

#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// A place where the distance along a segment passes a value.
struct SegmentCrossing
{
  /// From the segment's begin.
  double at;
  /// Whether it is below the value before, and above behind.
  bool rises;
};

/// Finds the places of a segment where the distance passes a value, in their order (paper, equation
/// 1 and section 4.2.2, solved for the place). They alternate between rising and falling and agree
/// with the arguments about the ends, in spite of roundings.
///
/// \param envelope the distance along the segment, see SegmentEnvelope; may be empty where the
///        segment has hardly any length.
/// \param beginsBelow whether the distance at the begin counts as below the value.
/// \param endsBelow the same at the end.
/// \param result is appended to.
void findCrossings(const std::vector<Window>& envelope, double value, bool beginsBelow,
  bool endsBelow, std::vector<SegmentCrossing>& result);

}

#endif
