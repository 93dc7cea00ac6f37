// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SolveForRefinement.h"

#include "front/Front.h"
#include "refinement/RefinementRetention.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace geodesic
{

namespace
{

// Of the tolerance of a refinement, what merging may change on one halfedge: the faces at a point
// then differ by no more, which is left over from the tolerance for the triangles. With more, many
// more triangles are needed; with less, more windows.
constexpr double MergedOfTolerance = 0.1;

/// Sends a front over the mesh.
using Propagate = std::function<FrontResult(const FrontOptions&, Retention&)>;

DistanceField solveKeepingAll(
  const TriangleMesh& mesh, const FrontOptions& options, const Propagate& propagateAll)
{
  std::vector<std::uint8_t> faces; // empty: all
  if (options.part != nullptr)
  {
    faces.assign(mesh.numberOfFaces(), 0);
    std::fill(faces.begin() + options.part->firstOwnFace(),
      faces.begin() + options.part->endOfOwnFaces(), std::uint8_t(1));
  }
  KeepFaces all(mesh, std::move(faces));
  FrontResult front = propagateAll(options, all);
  return { mesh, std::move(front), all.release() };
}

/// Solves with windows dropped; empty where some were dropped too early on any rank, which are
/// pinned then.
std::optional<DistanceField> solveAndDrop(const TriangleMesh& mesh, double refinementTolerance,
  const FrontOptions& options, const Propagate& propagateAll, std::vector<std::uint8_t>& pinned)
{
  RefinementRetention retention(
    mesh, refinementTolerance, pinned, options.part, options.parallelFor);
  FrontResult front = propagateAll(options, retention);
  for (const Id face : retention.droppedTooEarly())
  {
    pinned[face] = 1;
  }
  const bool isTooEarly = !retention.droppedTooEarly().empty();
  if (options.part ? options.part->exchange().isTrueAnywhere(isTooEarly) : isTooEarly)
  {
    return std::nullopt;
  }
  return DistanceField(mesh, std::move(front), retention.release());
}

DistanceField solveForRefinement(const TriangleMesh& mesh, double refinementTolerance,
  const FrontOptions& options, int maximumDroppingSolves, const Propagate& propagateAll)
{
  if (options.relativeError > 0.0)
  {
    FrontOptions merging = options;
    merging.maximumMerged = std::min(options.maximumMerged, maximumMergedFor(refinementTolerance));
    return solveKeepingAll(mesh, merging, propagateAll);
  }
  FrontOptions again = options;
  again.progress = ascending(options.progress);
  std::vector<std::uint8_t> pinned(mesh.numberOfFaces(), 0);
  for (int solves = 0; solves < maximumDroppingSolves; ++solves)
  {
    std::optional<DistanceField> field =
      solveAndDrop(mesh, refinementTolerance, again, propagateAll, pinned);
    if (field)
    {
      return std::move(*field);
    }
  }
  return solveKeepingAll(mesh, again, propagateAll);
}

} // anonymous namespace

double maximumMergedFor(double refinementTolerance)
{
  return MergedOfTolerance * refinementTolerance;
}

DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double refinementTolerance, const FrontOptions& options, int maximumDroppingSolves)
{
  return solveForRefinement(mesh, refinementTolerance, options, maximumDroppingSolves,
    [&](const FrontOptions& of, Retention& retention)
    { return propagate(mesh, sources, of, retention); });
}

DistanceField solveForRefinement(const TriangleMesh& mesh, const SourceWindows& sources,
  double refinementTolerance, const FrontOptions& options, int maximumDroppingSolves)
{
  return solveForRefinement(mesh, refinementTolerance, options, maximumDroppingSolves,
    [&](const FrontOptions& of, Retention& retention)
    { return propagate(mesh, sources, of, retention); });
}

}
