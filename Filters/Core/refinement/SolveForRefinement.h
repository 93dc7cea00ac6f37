// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForRefinement_h
#define geodesic_SolveForRefinement_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// Computes a field that refine() can refine to a tolerance or a larger one, keeping windows only
/// where the distance is not linear within it. In an approximate solve all are kept, and the
/// windows of one halfedge are merged by no more than maximumMergedFor(tolerance), whatever the
/// relative error.
///
/// Where windows were dropped that turn out to be needed, it is solved again with these kept. One
/// repetition is nearly always enough, as what was missing is kept then; each further one is for
/// faces that came to be missed by it. To be sure of an end, the last one keeps all.
///
/// Ranks that have the surface together solve together, and again together. The field is known in
/// the faces that each owns.
///
/// \param surface whose mesh must outlive the field.
/// \param sources what they give to begin with (propagate()).
/// \param tolerance in the surface's units, positive.
/// \param maximumDroppingSolves how often it is solved with windows dropped; at most one solve
///        more is made, which keeps all.
/// \throws as solve().
DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double tolerance, const FrontOptions& options = {}, int maximumDroppingSolves = 4);

/// The same in one process, from the curves themselves.
DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double tolerance, const FrontOptions& options = {}, int maximumDroppingSolves = 4);

/// What merging may change on one halfedge of an approximate field that is refined to a tolerance:
/// a tenth of it (window/Merging.md).
double maximumMergedFor(double tolerance);

}

#endif
