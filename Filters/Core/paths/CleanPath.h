// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CleanPath_h
#define geodesic_CleanPath_h

#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// Takes out of a path what tracing adds by rounding: crossings of edges at their ends, and
/// repeated points. Consecutive points still have a face in common. The path keeps its ends; one of
/// a single point gets it twice, and one of none stays so.
///
/// \param length of the path, or a bound of it: a crossing nearer to a vertex than a fraction of it
///        is at the vertex.
std::vector<SurfacePoint> cleanedPath(
  const TriangleMesh& mesh, const std::vector<SurfacePoint>& path, double length);

}

#endif
