// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ShortestPath_h
#define geodesic_ShortestPath_h

#include "Progress.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// Finds shortest paths between pairs of points of one surface, looking only at the part of the
/// surface that the path can reach: a shortest path along mesh edges gives an upper bound of its
/// length, and a path no longer than that stays in the faces whose distances in space to both
/// points add up to no more. The engine then solves on these faces alone.
class ShortestPathFinder
{
public:
  /// The mesh must outlive the finder.
  explicit ShortestPathFinder(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// A shortest path (one of them where there are several): the first point, a point on every edge
  /// it crosses, the vertices it passes, the second point. Consecutive points have a common face.
  /// Empty where no path joins them.
  ///
  /// \param progress called now and then with a fraction done; returning false throws Aborted.
  std::vector<SurfacePoint> between(
    const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress = {});

private:
  const TriangleMesh& mesh_;
  /// Work arrays, one entry a vertex or a face, allocated with the first path and always left
  /// clean.
  std::vector<double> lengthTo_;
  std::vector<Id> patchVertex_;
  std::vector<std::uint8_t> faceSeen_;
};

}

#endif
