// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForRefinement_h
#define geodesic_SolveForRefinement_h

#include "field/SolveDropping.h"

namespace geodesic
{

/// Computes a field that refine() can refine to this or a larger tolerance. It keeps windows only
/// where faces are pinned or the distance is not linear within the tolerance (solveDropping()). An
/// approximate solve keeps all windows, and merges those of one halfedge by at most
/// maximumMergedFor(tolerance), whatever the relative error.
///
/// \param surface, sources, options, pinned as for solveDropping().
/// \param tolerance in the surface's units, positive.
/// \throws as solve().
DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double tolerance, const FrontOptions& options, PinnedFaces& pinned);

/// How much merging may change the distance on one halfedge of an approximate field that will be
/// refined to a tolerance: a tenth of the tolerance (window/Merging.md).
double maximumMergedFor(double tolerance);

}

#endif
