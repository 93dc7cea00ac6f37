// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LinearBand_h
#define geodesic_LinearBand_h

#include "refinement/FaceBounds.h"

#include <array>

namespace geodesic
{

/// Whether the windows of a list stay in a band around the line between two values at the ends of
/// their halfedge. The test may fail although they do.
struct ListInBand
{
  /// No window is below the band.
  bool staysAboveBand = false;
  /// The windows cover the halfedge except for small gaps, and none is above the band.
  bool staysBelowBand = false;
};

/// Tests a list whose windows are in the cache; fast, as it needs no square roots.
///
/// \param limit half the width of the band.
ListInBand listInBand(
  const WindowRange& windows, double length, double atOrigin, double atDestination, double limit);

/// Bounds for a face none of whose lists is below a band of this half width. `staysBelowBand` marks
/// the halfedges that a list covers without being above the band. The bounds may be infinite.
FaceBounds boundsFromBands(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<bool, 3>& staysBelowBand, double limit);

}

#endif
