// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SolveForRefinement.h"

#include "field/DistanceField.h"
#include "refinement/RefinementRetention.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

// How much merging may change the distance on one halfedge, as a fraction of the refinement's
// tolerance: the faces at a point then differ by no more, and triangles get the rest of the
// tolerance. Larger fractions need many more triangles, smaller ones more windows.
constexpr double MergedOfTolerance = 0.1;

DistanceField solveKeepingAll(
  const MeshPartition& surface, const SourceWindows& sources, const FrontOptions& options)
{
  KeepFaces all(surface.mesh(), surface.ownFaces());
  FrontResult front = propagate(surface, sources, options, all);
  return { surface, std::move(front), all.release() };
}

} // anonymous namespace

double maximumMergedFor(double refinementTolerance)
{
  return MergedOfTolerance * refinementTolerance;
}

DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double refinementTolerance, const FrontOptions& options, const std::vector<std::uint8_t>& pinned,
  int maximumDroppingSolves)
{
  if (options.relativeError > 0.0)
  {
    FrontOptions merging = options;
    merging.maximumMerged = std::min(options.maximumMerged, maximumMergedFor(refinementTolerance));
    return solveKeepingAll(surface, sources, merging);
  }
  FrontOptions again = options;
  again.progress = ascending(options.progress);
  std::optional<DistanceField> field = solveDropping(
    surface, sources, again, maximumDroppingSolves,
    [&](const std::vector<std::uint8_t>& kept)
    { return RefinementRetention(surface, refinementTolerance, kept, again); },
    pinned);
  return field ? std::move(*field) : solveKeepingAll(surface, sources, again);
}

DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double refinementTolerance, const FrontOptions& options, int maximumDroppingSolves)
{
  return solveForRefinement(MeshPartition(mesh), startingWindows(mesh, sources, options.progress),
    refinementTolerance, options, {}, maximumDroppingSolves);
}

}
