// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgePath_h
#define geodesic_EdgePath_h

#include "Progress.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

namespace geodesic
{

/// Finds the length of a path from one point to another along mesh edges by best-first search: an
/// upper bound of the geodesic distance. Infinite if no path joins the points.
///
/// \param progress called now and then with 0; returning false throws Aborted.
double lengthAlongEdges(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, const ProgressCallback& progress);

}

#endif
