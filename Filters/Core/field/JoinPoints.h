// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_JoinPoints_h
#define geodesic_JoinPoints_h

#include "mesh/TriangleMesh.h"
#include "source/PolylineOnSurface.h"

namespace geodesic
{

/// Joins the far points of polylines by shortest paths (ShortestPathFinder), whose work arrays all
/// joins share. The mesh must outlive the result.
JoinPoints joinByShortestPaths(const TriangleMesh& mesh);

}

#endif
