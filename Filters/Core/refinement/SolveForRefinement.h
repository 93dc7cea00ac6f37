// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForRefinement_h
#define geodesic_SolveForRefinement_h

#include "field/DistanceField.h"
#include "field/PinnedFaces.h"

#include <optional>
#include <vector>

namespace geodesic
{

/// Solves once for a field that refine() can refine to this or a larger tolerance. It keeps windows
/// only where faces are pinned or the distance is not linear within the tolerance. An approximate
/// solve keeps all windows, and merges those of one halfedge by at most
/// maximumMergedFor(tolerance), whatever the relative error.
///
/// If dropped windows turn out to be needed, pins their faces and returns nothing: then solve
/// again. One repetition is nearly always enough; each further one is for faces that the previous
/// one has made necessary.
///
/// Ranks that share the surface solve together. The field is known in the faces that each rank
/// owns.
///
/// \param surface whose mesh must outlive the field.
/// \param sources the first windows and vertices (propagate()).
/// \param tolerance in the surface's units, positive.
/// \throws as solve().
std::optional<DistanceField> trySolveForRefinement(const MeshPartition& surface,
  const SourceWindows& sources, double tolerance, const FrontOptions& options, PinnedFaces& pinned);

/// Solves until no window is missing.
///
/// \param maximumDroppingSolves see PinnedFaces.
DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double tolerance, const FrontOptions& options = {}, int maximumDroppingSolves = 4);

/// In one process, from curves.
DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double tolerance, const FrontOptions& options = {}, int maximumDroppingSolves = 4);

/// How much merging may change the distance on one halfedge of an approximate field that will be
/// refined to a tolerance: a tenth of the tolerance (window/Merging.md).
double maximumMergedFor(double tolerance);

}

#endif
