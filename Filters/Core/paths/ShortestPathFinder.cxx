// SPDX-License-Identifier: BSD-3-Clause
#include "paths/ShortestPathFinder.h"

#include "Errors.h"
#include "Tolerance.h"
#include "paths/CleanPath.h"
#include "paths/EdgePath.h"
#include "paths/ShortestPath.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Whether consecutive points have a common face. If the path broke off or is empty, its ends have
/// none.
bool isWhole(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path)
{
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    if (commonFace(mesh, path[i - 1], path[i]) == NoId)
    {
      return false;
    }
  }
  return true;
}

/// If an end lies beside a vertex or an edge by a rounding, the path goes over the vertex or edge:
/// there the sub-mesh has the end, so that the path may leave through another face.
void linkEnds(const TriangleMesh& mesh, std::vector<SurfacePoint>& path)
{
  if (commonFace(mesh, path[0], path[1]) == NoId)
  {
    path.insert(path.begin() + 1, normalized(mesh, path.front()));
  }
  if (commonFace(mesh, path[path.size() - 2], path.back()) == NoId)
  {
    path.insert(path.end() - 1, normalized(mesh, path.back()));
  }
}

} // anonymous namespace

std::vector<SurfacePoint> ShortestPathFinder::between(
  const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)
{
  if (commonFace(this->mesh_, first, second) != NoId)
  {
    return { first, second };
  }
  const double length = (1.0 + tolerance::BoundMargin) *
    lengthAlongEdges(this->mesh_, first, second, this->lengthTo_, progress);
  if (length == Infinity)
  {
    return {};
  }
  const SubMesh patch(this->mesh_, first, second, length, this->workSpace_, progress);
  // From one point to the other; both are given as points of the patch, too.
  const auto find = [&](const SurfacePoint& from, const SurfacePoint& to,
                      const SurfacePoint& fromOnPatch, const SurfacePoint& toOnPatch)
  {
    std::vector<SurfacePoint> path =
      shortestPath(patch.mesh(), fromOnPatch, toOnPatch, length, this->parallelFor_, progress);
    for (SurfacePoint& point : path)
    {
      point = patch.onSurface(point);
    }
    path = cleanedPath(this->mesh_, path, from, to, length);
    linkEnds(this->mesh_, path);
    return path;
  };
  std::vector<SurfacePoint> path = find(first, second, patch.first(), patch.second());
  if (!isWhole(this->mesh_, path))
  {
    // The path may begin at a vertex at the place of the first point, behind several faces without
    // area.
    path = find(second, first, patch.second(), patch.first());
    std::reverse(path.begin(), path.end());
  }
  if (!isWhole(this->mesh_, path))
  {
    throw Error("The shortest path between two points of the source could not be traced.");
  }
  return path;
}

}
