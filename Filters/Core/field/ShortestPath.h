// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ShortestPath_h
#define geodesic_ShortestPath_h

#include "front/Front.h"
#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic
{

/// A shortest path between two points of a surface, found from both of them.
///
/// A front from the second point goes half the way and leaves the distances at vertices. Another
/// one from the first point then goes on into that half only where a path can still be as short as
/// the best one known, which is a strip of few faces. So two discs of half the radius are looked at
/// in place of one of the whole, and no windows are kept: the path is traced by the directions in
/// which it came to vertices.
///
/// \param length an upper bound of the path's length; all faces that a path of that length can
/// touch
///        must be in the mesh.
/// \returns the path from the first point to the second, see PathTracer; empty where there is none.
std::vector<SurfacePoint> shortestPath(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, double length, const ParallelFor& parallelFor,
  const ProgressCallback& progress);

}

#endif
