// SPDX-License-Identifier: BSD-3-Clause
#include "paths/JoinPoints.h"

#include "paths/ShortestPathFinder.h"

#include <memory>

namespace geodesic
{

JoinPoints joinByShortestPaths(const TriangleMesh& mesh, const ParallelFor& parallelFor)
{
  return [finder = std::make_shared<ShortestPathFinder>(mesh, parallelFor)](
           const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)
  { return finder->between(first, second, progress); };
}

JoinPoints JoinedPaths::reusedBy(JoinPoints join)
{
  const auto place = [](const SurfacePoint& p) { return Place(p.kind, p.id, p.u, p.v); };
  return [this, place, join = std::move(join)](
           const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)
  {
    const auto [used, isNew] = this->used_.try_emplace(Ends(place(first), place(second)));
    if (isNew)
    {
      const auto kept = this->kept_.find(used->first);
      used->second = kept != this->kept_.end() ? kept->second : join(first, second, progress);
    }
    return used->second;
  };
}

}
