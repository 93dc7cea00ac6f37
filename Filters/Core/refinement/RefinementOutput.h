// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementOutput_h
#define geodesic_RefinementOutput_h

#include "refinement/AdaptiveRefinement.h"
#include "refinement/RefinedFaces.h"

namespace geodesic
{

/// Appends the triangles of one face of this rank. A face that is not refined, but has points on
/// its edges, is cut between these. Points inside other faces must have numbers.
void appendTriangles(const RefinedFaces& faces, Id face, std::vector<Triangle>& triangles);

/// The triangles of a refined surface and the added points. Points inside faces get numbers behind
/// those on edges.
RefinedMesh writeOutput(RefinedFaces& faces, const RefinementOptions& options, const Job& job);

}

#endif
