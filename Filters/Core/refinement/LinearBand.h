// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LinearBand_h
#define geodesic_LinearBand_h

#include "refinement/FaceBounds.h"

#include <array>

namespace geodesic
{

/// Whether the windows of a list stay in a band around the line between two values at the ends of
/// their halfedge. Where the test says no they may stay in it nevertheless.
struct ListInBand
{
  /// No window is below the band.
  bool staysAboveBand = false;
  /// The windows cover the halfedge but for small gaps, and none is above the band.
  bool staysBelowBand = false;
};

/// The test for windows that are at hand, quick for want of square roots.
///
/// \param limit half the width of the band.
ListInBand listInBand(
  const WindowRange& windows, double length, double atOrigin, double atDestination, double limit);

/// Bounds for a face all of whose lists are not below a band of this half width; `staysBelowBand`
/// has the halfedges with a list that covers them and is not above it. Infinite where that says
/// nothing.
FaceBounds boundsFromBands(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<bool, 3>& staysBelowBand, double limit);

}

#endif
