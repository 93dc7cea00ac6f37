// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SolveForRefinement.h"

#include "refinement/RefinementRetention.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

// The faces at a point then differ by no more than this, and triangles get the rest of the
// tolerance. A larger fraction needs many more triangles, a smaller one more windows.
double maximumMergedFor(double refinementTolerance)
{
  return 0.1 * refinementTolerance;
}

std::optional<DistanceField> trySolveForRefinement(const MeshPartition& surface,
  const SourceWindows& sources, double refinementTolerance, const FrontOptions& options,
  PinnedFaces& pinned)
{
  FrontOptions merging = options;
  merging.maximumMerged = std::min(options.maximumMerged, maximumMergedFor(refinementTolerance));
  if (options.relativeError > 0.0 || pinned.areAllPinned())
  {
    return solveKeeping(surface, sources, merging, surface.ownFaces());
  }
  RefinementRetention retention(surface, refinementTolerance, pinned.faces(), options.job);
  FrontResult front = propagate(surface, sources, merging, retention);
  if (pinned.pinTooEarly(retention.droppedTooEarly()))
  {
    return std::nullopt;
  }
  return DistanceField(surface, std::move(front), retention.release());
}

DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double refinementTolerance, const FrontOptions& options, int maximumDroppingSolves)
{
  PinnedFaces pinned(surface, {}, maximumDroppingSolves);
  std::optional<DistanceField> field;
  while (!field)
  {
    field = trySolveForRefinement(surface, sources, refinementTolerance, options, pinned);
  }
  return std::move(*field);
}

DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double refinementTolerance, const FrontOptions& options, int maximumDroppingSolves)
{
  return solveForRefinement(MeshPartition(mesh), startingWindows(mesh, sources, options.job),
    refinementTolerance, options, maximumDroppingSolves);
}

}
