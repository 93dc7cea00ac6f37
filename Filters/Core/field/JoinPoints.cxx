// SPDX-License-Identifier: BSD-3-Clause
#include "field/JoinPoints.h"

#include "field/ShortestPath.h"

#include <memory>

namespace geodesic
{

JoinPoints joinByShortestPaths(const TriangleMesh& mesh)
{
  return [finder = std::make_shared<ShortestPathFinder>(mesh)](
           const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)
  { return finder->between(first, second, progress); };
}

}
