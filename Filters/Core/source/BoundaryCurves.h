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

}

#endif
