// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SolveForRefinement.h"

#include "field/DistanceField.h"
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

DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double refinementTolerance, const FrontOptions& options, const std::vector<std::uint8_t>& pinned,
  int maximumDroppingSolves)
{
  FrontOptions merging = options;
  merging.maximumMerged = std::min(options.maximumMerged, maximumMergedFor(refinementTolerance));
  return solveDropping(
    surface, sources, merging, options.relativeError > 0.0 ? 0 : maximumDroppingSolves,
    [&](const std::vector<std::uint8_t>& kept)
    { return RefinementRetention(surface, refinementTolerance, kept, options.job); },
    pinned);
}

DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double refinementTolerance, const FrontOptions& options, int maximumDroppingSolves)
{
  return solveForRefinement(MeshPartition(mesh), startingWindows(mesh, sources, options.job),
    refinementTolerance, options, {}, maximumDroppingSolves);
}

}
