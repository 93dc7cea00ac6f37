// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ApexQuery_h
#define geodesic_ApexQuery_h

#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// The shortest path to the apex of a face that comes through a list of windows on the halfedge
/// opposite; bent where no window's pencil holds the apex.
struct ApexDistance
{
  /// Its length; infinite where the list is empty.
  double distance = Infinity;
  /// Where it crosses the halfedge.
  double crossing = 0.0;
  /// The error of the window that gives it.
  double error = 0.0;
  /// The origin of that window, where its ray there comes from, and the ray's direction.
  Id origin = NoId;
  double place = 0.0;
  Vec2 direction = {};
};

/// On which side of the apex the rays of a window pass.
enum class ApexSide : std::uint8_t
{
  Left,
  Right,
  /// The pencil holds the apex.
  Both
};

/// What the full query of the apex finds.
struct ApexQuery
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  ApexDistance shortest;
  /// The list that was asked, and the side of each of its windows.
  WindowRange list;
  const ApexSide* sides = nullptr;
  /// Of the windows whose pencils hold the apex the one that reaches it first; None where there is
  /// none.
  std::size_t first = None;
};

/// The full query of the apex: asks every window of a sorted list.
///
/// \param sides keeps the sides of the windows, to which the result refers; replaced, and never
///        shorter than before.
ApexQuery fullApexQuery(
  const WindowRange& list, const PointOverHalfedge& apex, std::vector<ApexSide>& sides);

/// The quick query of the apex: asks only the windows about it, in logarithmic time. Where rays of
/// several windows cross below the apex, a shorter path may be overlooked. That is enough to tell
/// when the front comes to the apex; then the full query is made.
ApexDistance quickApexQuery(const WindowRange& list, Vec2 apex);

}

#endif
