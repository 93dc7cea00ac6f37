// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BarrierFaces_h
#define geodesic_BarrierFaces_h

#include "Tolerance.h"
#include "mesh/MeshPartition.h"
#include "mesh/SurfaceLocator.h"

#include <vector>

namespace geodesic
{

/// The faces of a surface that no path may enter. The surface's mesh does not contain them: it has
/// holes in their place. Paths run along a barrier's rim and bend around reflex corners of these
/// holes, so the engine needs to know nothing of barriers. This class knows where they are, for
/// points that are to be put onto the surface.
class BarrierFaces
{
public:
  /// \param open the faces of the surface that are not barriers.
  /// \param barriers the barriers, as a surface of their own.
  BarrierFaces(const MeshPartition& open, const MeshPartition& barriers)
    : open_(open)
    , locator_(barriers)
  {
  }

  const MeshPartition& surface() const { return this->locator_.surface(); }

  /// For each point in space the barrier that it lies in or is closest to, a face of surface(). The
  /// id is NoId if an open face is as close, within the precision of the place: a point on the rim
  /// lies outside. All ranks call this together and get the same. Not thread-safe.
  ///
  /// \param points the same on all ranks.
  /// \param closest the open faces that are closest to each point.
  /// \param coordinatePrecision relative precision of the points' coordinates.
  /// \param rim how wide it is, as a fraction of the longest edge of an open face: removing faces
  ///        without area moves points of the surface by that.
  std::vector<RankAddress> barriersAt(const std::vector<Vec3>& points, const ClosestFaces& closest,
    double coordinatePrecision, double rim = tolerance::WithoutArea);

private:
  MeshPartition open_;
  SurfaceLocator locator_;
};

}

#endif
