// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementOutput_h
#define geodesic_RefinementOutput_h

#include "refinement/AdaptiveRefinement.h"
#include "refinement/RefinedFaces.h"

namespace geodesic
{

/// Appends the triangles of one face of this rank. A face that is not refined, but has points on
/// its edges, is cut between these.
///
/// \param firstInside the number of each open face's first point inside.
void appendTriangles(const RefinedFaces& faces, Id face, const std::vector<Id>& firstInside,
  std::vector<Triangle>& triangles);

/// The number of each open face's first point inside: such points follow those on edges.
std::vector<Id> firstPointsInside(const RefinedFaces& faces);

/// The triangles of a refined surface and the added points.
///
/// \param numberOfPoints of the caller: fewer than vertices if the last vertices are only other
///        ranks'.
RefinedMesh writeOutput(
  const RefinedFaces& faces, const RefinementOptions& options, Id numberOfPoints, const Job& job);

}

#endif
