// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolineSides_h
#define geodesic_IsolineSides_h

#include "contours/Isolines.h"
#include "field/NearestSource.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// The signed values that an unsigned one stands for.
struct SidedValue
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  /// Which of the signed values the line has where shortest paths come from the left-hand side of a
  /// curve, and from its right-hand side; None where that is not asked for.
  std::size_t left = None;
  std::size_t right = None;
};

/// Cuts isolines where they pass from one side of the curves to the other, and keeps the parts on
/// the sides that are asked for. Where the side changes within an arc, as it does behind the open
/// end of a curve, a point of the isoline is added there.
///
/// Parts on the right-hand side are turned around, so that the signed distance, which is negative
/// there, grows to the left of all lines.
///
/// \param field that the isolines were drawn of, with arrivals; its surface must be consistently
///        oriented.
/// \param isOnRight whether a foot counts as on the right-hand side.
/// \param values one for each value of the isolines. The lines of the result have the signed ones.
/// \param progress called now and then; returning false throws Aborted.
Isolines linesOnSides(const DistanceField& field, NearestSource& nearest,
  const std::function<bool(const Foot&)>& isOnRight, const Isolines& isolines,
  const std::vector<SidedValue>& values, const ProgressCallback& progress = {});

}

#endif
