// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ShortestWay_h
#define geodesic_ShortestWay_h

#include "field/IncomingSegment.h"

namespace geodesic
{

/// A way from a corner or through a window to a point, and its face.
struct WayInFace : WayIntoFace
{
  Id face = NoId;
  /// From the window to the point.
  WayFrom from = {};
};

/// The shortest way to a point through this rank's faces. If two windows are as short but for
/// rounding, the one whose ray leads to the point is taken: the path bends at the end of the other.
///
/// \param without a face that is left out; NoId if there is none.
/// \returns a way of infinite length if there is none.
WayInFace shortestWayTo(const DistanceField& field, const SurfacePoint& point, Id without);

}

#endif
