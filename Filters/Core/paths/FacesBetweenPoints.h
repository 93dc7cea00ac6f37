// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FacesBetweenPoints_h
#define geodesic_FacesBetweenPoints_h

#include "front/Front.h"
#include "mesh/ReplicatedPatch.h"
#include "source/PolylineOnSurface.h"

#include <vector>

namespace geodesic
{

/// Bounds of the ways from a point, as far as to another.
struct LowerBounds
{
  /// No path between both points is needed that is longer; infinite where none joins them.
  double length = Infinity;
  /// No path to a vertex of the part is shorter.
  std::vector<double> atLeast;
};

/// By an approximate front that stops at the other point. All ranks call together.
///
/// \param patch with the faces of both points.
/// \param options for several threads and the progress.
/// \throws Aborted
LowerBounds waysFrom(const MeshPartition& part, const ReplicatedPatch& patch,
  const SurfacePoint& from, const SurfacePoint& to, FrontOptions options = {});

/// On a surface that ranks have together: the faces that shortest paths between consecutive points
/// of polylines can touch, where these points share no face. With them a patch has the shortest
/// paths of the whole, and polylines are put onto it as onto one surface.
///
/// An approximate front from either point, which stops at the other, bounds the ways to both from
/// below; faces where these add up to more than a path's length are left out. What is left is a
/// strip, narrow where the points are far apart.
///
/// All ranks call together.
///
/// \param patch with the faces of the points and those around them.
/// \param polylines located on the patch.
/// \param progress called now and then with a fraction done; returning false throws Aborted.
/// \returns faces that this rank owns, ascending; none where no points are far or no path joins
///          them.
/// \throws Aborted
std::vector<Id> facesBetweenPoints(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<LocatedPolyline>& polylines, const SnapOptions& options,
  const ParallelFor& parallelFor = {}, const ProgressCallback& progress = {});

}

#endif
