// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BoundaryCurves_h
#define geodesic_BoundaryCurves_h

#include "mesh/TriangleMesh.h"
#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// The whole boundary of the surface: one closed curve along mesh edges a loop. Where not exactly
/// two boundary edges meet at a vertex, curves end there (they may begin there, too). Every
/// boundary edge is in one curve, once. Empty for a closed surface.
std::vector<SourceCurve> boundaryCurves(const TriangleMesh& mesh);

/// What faces that are no barriers have of the boundary of a surface: the pieces along their edges,
/// and single vertices where they touch the boundary in a point only. The rest is left out, as no
/// path leaves it. Pieces have the `source` of their curve; a curve that is kept whole stays as it
/// is.
///
/// \param boundary curves of the whole surface, by boundaryCurves().
/// \param mesh the faces that are no barriers, with the same vertices; it may be without those that
///        none of its faces has, whose numbers are larger then than all of its own.
std::vector<SourceCurve> boundaryOutsideBarriers(
  const std::vector<SourceCurve>& boundary, const TriangleMesh& mesh);

}

#endif
