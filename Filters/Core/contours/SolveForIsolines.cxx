// SPDX-License-Identifier: BSD-3-Clause
#include "contours/SolveForIsolines.h"

#include "contours/IsolineRetention.h"
#include "field/Solve.h"

#include <algorithm>

namespace geodesic
{

namespace
{

template <typename Sources>
DistanceField solveFrom(const TriangleMesh& mesh, const Sources& sources,
  const std::vector<double>& values, const FrontOptions& options, int maximumDroppingSolves)
{
  FrontOptions again = options;
  again.progress = ascending(options.progress);
  std::vector<std::uint8_t> pinned(mesh.numberOfFaces(), 0);
  for (int solves = 0; solves < maximumDroppingSolves; ++solves)
  {
    IsolineRetention retention(mesh, options.part, values, pinned);
    FrontResult front = propagate(mesh, sources, again, retention);
    const bool isIncomplete = !retention.droppedTooEarly().empty();
    if (!(options.part ? options.part->exchange().isTrueAnywhere(isIncomplete) : isIncomplete))
    {
      return { mesh, std::move(front), retention.release() };
    }
    for (const Id face : retention.droppedTooEarly())
    {
      pinned[face] = 1;
    }
  }
  return solve(mesh, sources, again, KeepWindows::All);
}

} // anonymous namespace

DistanceField solveForIsolines(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const std::vector<double>& values, const FrontOptions& options, int maximumDroppingSolves)
{
  return solveFrom(mesh, sources, values, options, maximumDroppingSolves);
}

DistanceField solveForIsolines(const TriangleMesh& mesh, const SourceWindows& sources,
  const std::vector<double>& values, const FrontOptions& options, int maximumDroppingSolves)
{
  return solveFrom(mesh, sources, values, options, maximumDroppingSolves);
}

}
