// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CleanPath_h
#define geodesic_CleanPath_h

#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// A traced path without what tracing adds by rounding: crossings of edges at their ends, repeated
/// points. The ends are the given ones. What is left has the faces in common that it had.
///
/// \param length of the path, or a bound of it: to a fraction of that a crossing is at a vertex.
std::vector<SurfacePoint> cleanedPath(const TriangleMesh& mesh,
  const std::vector<SurfacePoint>& path, const SurfacePoint& first, const SurfacePoint& second,
  double length);

}

#endif
