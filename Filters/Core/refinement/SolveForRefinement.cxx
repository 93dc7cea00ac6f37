// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SolveForRefinement.h"

#include "Tolerance.h"
#include "field/Solve.h"
#include "refinement/RefinementRetention.h"

#include <algorithm>

namespace geodesic
{

namespace
{

DistanceField solveApproximate(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double refinementTolerance, const FrontOptions& options)
{
  FrontOptions merging = options;
  merging.maximumMerged =
    std::min(options.maximumMerged, tolerance::MergedOfRefinement * refinementTolerance);
  return solve(mesh, sources, merging, KeepWindows::All);
}

} // anonymous namespace

DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double refinementTolerance, const FrontOptions& options)
{
  if (options.relativeError > 0.0)
  {
    return solveApproximate(mesh, sources, refinementTolerance, options);
  }
  FrontOptions again = options;
  double reported = 0.0;
  if (options.progress)
  {
    again.progress = [&](double fraction) // never back, though it be solved once more
    {
      reported = std::max(reported, fraction);
      return options.progress(reported);
    };
  }
  std::vector<std::uint8_t> pinned(mesh.numberOfFaces(), 0);
  while (true)
  {
    RefinementRetention retention(mesh, refinementTolerance, pinned);
    FrontResult front = propagate(mesh, sources, again, retention);
    if (retention.droppedTooEarly().empty())
    {
      return { mesh, std::move(front), retention.release() };
    }
    for (const Id face : retention.droppedTooEarly())
    {
      pinned[face] = 1;
    }
  }
}

}
