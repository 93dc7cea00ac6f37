// SPDX-License-Identifier: BSD-3-Clause
#include "field/Solve.h"

#include <utility>

namespace geodesic
{

DistanceField solve(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options, KeepWindows keep)
{
  if (keep == KeepWindows::None)
  {
    KeepNone none;
    return { surface, propagate(surface, std::move(sources), options, none), KeptWindows() };
  }
  KeepFaces all(surface.mesh());
  FrontResult front = propagate(surface, std::move(sources), options, all);
  return { surface, std::move(front), all.release() };
}

DistanceField solve(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, KeepWindows keep)
{
  return solve(
    MeshPartition(mesh), startingWindows(mesh, sources, options.progress), options, keep);
}

}
