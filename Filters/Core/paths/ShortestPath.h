// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ShortestPath_h
#define geodesic_ShortestPath_h

#include "front/Front.h"
#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic
{

/// A shortest path between two points of a surface.
///
/// An approximate front from the second point, which costs a fraction of an exact one, leaves lower
/// bounds of the way to that point. An exact one from the first point then goes only where a path
/// can still be as short as the best one known, which is a strip of few faces. No windows are kept:
/// the path is traced by the directions in which it came to vertices.
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
