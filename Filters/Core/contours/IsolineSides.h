// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolineSides_h
#define geodesic_IsolineSides_h

#include "contours/Isolines.h"
#include "field/NearestSource.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// The signed values that correspond to an unsigned value.
struct SidedValue
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  /// The index of the signed value where shortest paths come from the left-hand side of a curve,
  /// and from its right-hand side; None if that side is not wanted.
  std::size_t left = None;
  std::size_t right = None;
};

/// Cuts isolines where they pass from one side of the curves to the other, and keeps the parts on
/// the sides that are wanted. If the side changes within an arc, as behind the open end of a curve,
/// a point of the isoline is added there.
///
/// Parts on the right-hand side are turned around, so that the signed distance, which is negative
/// there, grows to the left of all lines.
///
/// \param field that the isolines were drawn of, with arrivals; its surface must be consistently
///        oriented.
/// \param isOnRight whether a foot counts as on the right-hand side.
/// \param values one for each value of the isolines. The lines of the result have the signed ones.
Isolines linesOnSides(const DistanceField& field, NearestSource& nearest,
  const std::function<bool(const Foot&)>& isOnRight, const Isolines& isolines,
  const std::vector<SidedValue>& values, const Job& job = {});

}

#endif
