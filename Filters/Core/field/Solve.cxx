// SPDX-License-Identifier: BSD-3-Clause
#include "field/Solve.h"

#include <utility>

namespace geodesic
{

namespace
{

template <typename Sources>
DistanceField solveFrom(
  const TriangleMesh& mesh, Sources&& sources, const FrontOptions& options, KeepWindows keep)
{
  if (keep == KeepWindows::None)
  {
    KeepNone none;
    return { mesh, propagate(mesh, std::forward<Sources>(sources), options, none), KeptWindows() };
  }
  KeepAll all(mesh);
  FrontResult front = propagate(mesh, std::forward<Sources>(sources), options, all);
  return { mesh, std::move(front), all.release() };
}

} // anonymous namespace

DistanceField solve(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, KeepWindows keep)
{
  return solveFrom(mesh, sources, options, keep);
}

DistanceField solve(
  const TriangleMesh& mesh, SourceWindows sources, const FrontOptions& options, KeepWindows keep)
{
  return solveFrom(mesh, std::move(sources), options, keep);
}

}
