// SPDX-License-Identifier: BSD-3-Clause
#include "field/Solve.h"

namespace geodesic
{

DistanceField solve(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, KeepWindows keep)
{
  if (keep == KeepWindows::None)
  {
    KeepNone none;
    return { mesh, propagate(mesh, sources, options, none), KeptWindows() };
  }
  KeepAll all(mesh);
  FrontResult front = propagate(mesh, sources, options, all);
  return { mesh, std::move(front), all.release() };
}

}
