// SPDX-License-Identifier: BSD-3-Clause
#include "field/SolveForIsolines.h"

#include "field/IsolineRetention.h"
#include "field/Solve.h"

#include <algorithm>

namespace geodesic
{

DistanceField solveForIsolines(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const std::vector<double>& values, const FrontOptions& options, int maximumDroppingSolves)
{
  FrontOptions again = options;
  again.progress = ascending(options.progress);
  std::vector<std::uint8_t> pinned(mesh.numberOfFaces(), 0);
  for (int solves = 0; solves < maximumDroppingSolves; ++solves)
  {
    IsolineRetention retention(mesh, values, pinned);
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
  return solve(mesh, sources, again, KeepWindows::All);
}

}
