// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ApexQuery_h
#define geodesic_ApexQuery_h

#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// The shortest path to the apex of a face through a list of windows on the opposite halfedge. The
/// path bends if no window's pencil contains the apex.
struct ApexDistance
{
  /// Its length; infinite where the list is empty.
  double distance = Infinity;
  /// Where the path crosses the halfedge.
  double crossing = 0.0;
  /// The error of the window that gives the path.
  double error = 0.0;
  /// The origin of that window, the place on its curve where the ray begins, and the ray's
  /// direction.
  Id origin = NoId;
  double place = 0.0;
  Vec2 direction = {};
};

/// On which side of the apex the rays of a window pass.
enum class ApexSide : std::uint8_t
{
  Left,
  Right,
  /// The pencil contains the apex.
  Both
};

struct ApexQuery
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  ApexDistance shortest;
  /// The queried list, and the side of each of its windows.
  WindowRange list;
  const ApexSide* sides = nullptr;
  /// The window that reaches the apex first among those whose pencils contain it; None if there is
  /// none.
  std::size_t first = None;
};

/// The full query of the apex: checks every window of a sorted list.
///
/// \param sides the sides of the windows, to which the result refers; replaced, and never made
///        shorter.
ApexQuery fullApexQuery(
  const WindowRange& list, const PointOverHalfedge& apex, std::vector<ApexSide>& sides);

/// The quick query of the apex: checks only the windows near it, in logarithmic time. Where rays of
/// several windows cross below the apex, it may miss a shorter path. It suffices to decide when the
/// front comes to the apex, where the full query follows.
ApexDistance quickApexQuery(const WindowRange& list, Vec2 apex);

}

#endif
