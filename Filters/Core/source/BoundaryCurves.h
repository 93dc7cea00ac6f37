// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BoundaryCurves_h
#define geodesic_BoundaryCurves_h

#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// Curves along mesh edges, such as a surface's boundary: each loop is one closed curve. At a
/// vertex where the number of edges is not two, all curves end. Every edge is in exactly one curve.
///
/// \param ends the edges' vertices, two an edge.
/// \param faces one an edge.
std::vector<SourceCurve> curvesAlong(const std::vector<Id>& ends, const std::vector<Id>& faces);

/// The part of a surface's boundary on the faces of a mesh without barriers: the pieces along edges
/// of these faces, and single vertices where faces touch the boundary in a point only. No path
/// leaves the rest. Pieces keep the `source` of their curve; a complete curve stays unchanged.
///
/// \param boundary curves of the whole surface, whose faces do not matter.
/// \param mesh the faces that are not barriers, with the same vertices; vertices that only barriers
///        use may be missing at the end.
std::vector<SourceCurve> boundaryOutsideBarriers(
  const std::vector<SourceCurve>& boundary, const TriangleMesh& mesh);

}

#endif
