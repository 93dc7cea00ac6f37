// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementOutput_h
#define geodesic_RefinementOutput_h

#include "refinement/AdaptiveRefinement.h"
#include "refinement/RedGreenMesh.h"

namespace geodesic
{

/// The triangles of a refined mesh, closed, and the added points.
///
/// \param numberOfPoints of the caller: fewer than vertices if the last vertices are only other
///        ranks'.
RefinedMesh writeOutput(const RedGreenMesh& triangles, const RefinementOptions& options,
  Id numberOfPoints, const Job& job);

}

#endif
