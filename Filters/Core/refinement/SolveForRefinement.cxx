// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SolveForRefinement.h"

#include "refinement/RefinementRetention.h"

#include <algorithm>

namespace geodesic
{

// The faces at a point then differ by no more than this, and triangles get the rest of the
// tolerance. A larger fraction needs many more triangles, a smaller one more windows.
double maximumMergedFor(double refinementTolerance)
{
  return 0.1 * refinementTolerance;
}

DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double refinementTolerance, const FrontOptions& options, PinnedFaces& pinned)
{
  FrontOptions merging = options;
  merging.maximumMerged = std::min(options.maximumMerged, maximumMergedFor(refinementTolerance));
  if (options.relativeError > 0.0)
  {
    return solveKeeping(surface, sources, merging, surface.ownFaces());
  }
  return solveDropping(surface, sources, merging, pinned,
    [&](const PinnedFaces& now)
    { return RefinementRetention(surface, refinementTolerance, now, options.job); });
}

}
