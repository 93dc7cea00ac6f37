// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ShortestPath_h
#define geodesic_ShortestPath_h

#include "front/Front.h"
#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic
{

/// Finds a shortest path between two points of a surface.
///
/// An approximate front from the second point, which costs a fraction of an exact one, gives lower
/// bounds of the distance to that point. An exact front from the first point then goes only where a
/// path can still be as short as the best known one: through a strip of few faces. Hardly any
/// windows are kept, as PathTracer follows the path by the directions in which it came to vertices.
///
/// \param length an upper bound of the path's length. The mesh must contain all faces that a path
///        of that length can touch.
/// \returns the path from the first point to the second, see PathTracer; empty if there is none.
std::vector<SurfacePoint> shortestPath(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, double length, const ParallelFor& parallelFor,
  const ProgressCallback& progress);

}

#endif
