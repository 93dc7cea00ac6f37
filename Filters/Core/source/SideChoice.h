// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SideChoice_h
#define geodesic_SideChoice_h

#include "mesh/SurfaceLocator.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// A polyline, by the numbers of its points' places in space.
struct RowOfPlaces
{
  std::vector<std::size_t> places;
  /// Whether the last point joins the first.
  bool closed = false;
};

/// Keeps polylines on one side of a thin wall. Chooses for each place between the closest faces and
/// the faces of the opposite wall, so that each polyline changes sides as rarely as possible, and
/// goes to the farther side for as little as possible. A curve around an edge changes sides once,
/// where its points do, or not at all if it has points on the edge's narrow side. A place of
/// several points has one choice: that of its first point.
///
/// \param places in space.
/// \param rows polylines through them.
/// \param closest the closest faces of all places.
/// \param opposite those of the opposite wall; none where there is no choice.
/// \return for each place whether it goes to the opposite wall.
std::vector<std::uint8_t> chooseSides(const std::vector<Vec3>& places,
  const std::vector<RowOfPlaces>& rows, const ClosestFaces& closest, const ClosestFaces& opposite);

}

#endif
