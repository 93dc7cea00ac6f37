// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ShortestPathFinder_h
#define geodesic_ShortestPathFinder_h

#include "Progress.h"
#include "front/Front.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"
#include "paths/SubMesh.h"

#include <vector>

namespace geodesic
{

/// Finds shortest paths between pairs of points of one surface. A shortest path along mesh edges
/// gives an upper bound of the path's length, and the search looks only at the part of the surface
/// that a path of that length can touch (SubMesh).
class ShortestPathFinder
{
public:
  /// \param mesh must outlive the finder.
  explicit ShortestPathFinder(const TriangleMesh& mesh, ParallelFor parallelFor = {})
    : mesh_(mesh)
    , parallelFor_(std::move(parallelFor))
  {
  }

  /// Finds a shortest path (one of them if there are several): the first point, a point on every
  /// edge that it crosses, the vertices that it passes, the second point. Consecutive points have a
  /// common face. Empty if no path joins the points.
  ///
  /// \param progress called now and then with a fraction done; returning false throws Aborted.
  std::vector<SurfacePoint> between(
    const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress = {});

private:
  const TriangleMesh& mesh_;
  ParallelFor parallelFor_;
  std::vector<double> lengthTo_;
  SubMesh::WorkSpace workSpace_;
};

}

#endif
