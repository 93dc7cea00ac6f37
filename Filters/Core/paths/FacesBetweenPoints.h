// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FacesBetweenPoints_h
#define geodesic_FacesBetweenPoints_h

#include "front/Front.h"
#include "mesh/ReplicatedPatch.h"
#include "source/PolylineOnSurface.h"

#include <vector>

namespace geodesic
{

/// Bounds of the distance from one point, up to another one.
struct LowerBounds
{
  /// An upper bound of the distance between the two points; infinite if no path joins them.
  double length = Infinity;
  /// A lower bound of the distance to each vertex of the partition.
  std::vector<double> atLeast;
};

/// Finds the bounds by an approximate front that stops at the other point. All ranks call this
/// together.
///
/// \param patch that contains the faces of both points.
/// \throws Aborted
LowerBounds lowerBoundsFrom(const MeshPartition& part, const ReplicatedPatch& patch,
  const SurfacePoint& from, const SurfacePoint& to, const Job& job = {});

/// Finds the faces that shortest paths between consecutive points of polylines can touch, for
/// points that share no face. A patch that contains these faces has the same shortest paths as the
/// whole surface, so that polylines can be put onto the patch.
///
/// Two approximate fronts, one from each point, stop at the other point and bound the distances to
/// both points from below. Faces where the two bounds add up to more than a path's length are left
/// out. The remaining faces form a strip, which is narrow compared with the distance of the points.
///
/// All ranks call this together.
///
/// \param patch that contains the faces of the points and those around them.
/// \param polylines located on the patch.
/// \param coordinatePrecision as in putOntoSurface().
/// \returns faces that this rank owns, ascending; none if consecutive points share faces or no path
///          joins them.
/// \throws Aborted
std::vector<Id> facesBetweenPoints(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<LocatedPolyline>& polylines, double coordinatePrecision, const Job& job = {});

}

#endif
