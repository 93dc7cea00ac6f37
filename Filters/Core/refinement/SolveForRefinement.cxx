// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SolveForRefinement.h"

#include "field/Solve.h"
#include "refinement/RefinementRetention.h"

#include <algorithm>
#include <optional>

namespace geodesic
{

namespace
{

// Of the tolerance of a refinement, what merging may change on one halfedge: the faces at a point
// then differ by no more, which is left over from the tolerance for the triangles. With more, many
// more triangles are needed; with less, more windows.
constexpr double MergedOfTolerance = 0.1;

DistanceField solveApproximate(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double refinementTolerance, const FrontOptions& options)
{
  FrontOptions merging = options;
  merging.maximumMerged = std::min(options.maximumMerged, maximumMergedFor(refinementTolerance));
  return solve(mesh, sources, merging, KeepWindows::All);
}

/// Solves with windows dropped; empty where some were dropped too early, which are pinned then.
std::optional<DistanceField> solveAndDrop(const TriangleMesh& mesh,
  const std::vector<SourceCurve>& sources, double refinementTolerance, const FrontOptions& options,
  std::vector<std::uint8_t>& pinned)
{
  RefinementRetention retention(mesh, refinementTolerance, pinned);
  FrontResult front = propagate(mesh, sources, options, retention);
  for (const Id face : retention.droppedTooEarly())
  {
    pinned[face] = 1;
  }
  if (!retention.droppedTooEarly().empty())
  {
    return std::nullopt;
  }
  return DistanceField(mesh, std::move(front), retention.release());
}

} // anonymous namespace

double maximumMergedFor(double refinementTolerance)
{
  return MergedOfTolerance * refinementTolerance;
}

DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double refinementTolerance, const FrontOptions& options, int maximumDroppingSolves)
{
  if (options.relativeError > 0.0)
  {
    return solveApproximate(mesh, sources, refinementTolerance, options);
  }
  FrontOptions again = options;
  again.progress = ascending(options.progress);
  std::vector<std::uint8_t> pinned(mesh.numberOfFaces(), 0);
  for (int solves = 0; solves < maximumDroppingSolves; ++solves)
  {
    std::optional<DistanceField> field =
      solveAndDrop(mesh, sources, refinementTolerance, again, pinned);
    if (field)
    {
      return std::move(*field);
    }
  }
  return solve(mesh, sources, again, KeepWindows::All);
}

}
