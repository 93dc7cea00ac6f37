// SPDX-License-Identifier: BSD-3-Clause
#include "contours/SolveForIsolines.h"

#include "contours/IsolineRetention.h"
#include "field/Solve.h"

namespace geodesic
{

DistanceField solveForIsolines(const MeshPartition& surface, const SourceWindows& sources,
  const std::vector<double>& values, const FrontOptions& options, int maximumDroppingSolves)
{
  FrontOptions again = options;
  again.progress = ascending(options.progress);
  std::optional<DistanceField> field = solveDropping(surface, sources, again, maximumDroppingSolves,
    [&](const std::vector<std::uint8_t>& pinned)
    { return IsolineRetention(surface, values, pinned); });
  return field ? std::move(*field) : solve(surface, sources, again, KeepWindows::All);
}

DistanceField solveForIsolines(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const std::vector<double>& values, const FrontOptions& options, int maximumDroppingSolves)
{
  return solveForIsolines(MeshPartition(mesh), startingWindows(mesh, sources, options.progress),
    values, options, maximumDroppingSolves);
}

}
