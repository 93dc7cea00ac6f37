// SPDX-License-Identifier: BSD-3-Clause
#include "paths/JoinPoints.h"

#include "Errors.h"
#include "paths/CleanPath.h"
#include "paths/ShortestPath.h"
#include "paths/SubMesh.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Whether consecutive points have a common face. If the path broke off or is empty, its ends have
/// none.
bool isWhole(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path)
{
  const auto areApart = [&](const SurfacePoint& a, const SurfacePoint& b)
  { return commonFace(mesh, a, b) == NoId; };
  return std::adjacent_find(path.begin(), path.end(), areApart) == path.end();
}

/// Gives a path on the surface the two points that it was looked for between as its ends: on the
/// sub-mesh they were rounded.
void setEnds(const TriangleMesh& mesh, const SurfacePoint& first, const SurfacePoint& second,
  std::vector<SurfacePoint>& path)
{
  // A path may begin at a vertex at the place of the first point, behind faces without area.
  const bool isBehind = path.size() > 1 && commonFace(mesh, first, path[1]) == NoId &&
    commonFace(mesh, first, path[0]) != NoId;
  if (path.empty() || isBehind)
  {
    path.insert(path.begin(), first);
  }
  path.resize(std::max<std::size_t>(path.size(), 2));
  path.front() = first;
  path.back() = second;
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

std::vector<SurfacePoint> pathBetween(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, const ParallelFor& parallelFor, const ProgressCallback& progress)
{
  if (commonFace(mesh, first, second) != NoId)
  {
    return { first, second };
  }
  const SubMesh patch(mesh, first, second, progress);
  if (patch.bound() == Infinity)
  {
    return {};
  }
  const auto find = [&](const SurfacePoint& from, const SurfacePoint& to)
  {
    std::vector<SurfacePoint> path = shortestPath(
      patch.mesh(), patch.onPatch(from), patch.onPatch(to), patch.bound(), parallelFor, progress);
    std::transform(path.begin(), path.end(), path.begin(),
      [&patch](const SurfacePoint& point) { return patch.onSurface(point); });
    setEnds(mesh, from, to, path);
    path = cleanedPath(mesh, path, patch.bound());
    linkEnds(mesh, path);
    return path;
  };
  std::vector<SurfacePoint> path = find(first, second);
  if (!isWhole(mesh, path))
  {
    // The path may begin at a vertex at the place of the first point, behind several faces without
    // area.
    path = find(second, first);
    std::reverse(path.begin(), path.end());
  }
  if (!isWhole(mesh, path))
  {
    throw Error("The shortest path between two points of the source could not be traced.");
  }
  return path;
}

} // anonymous namespace

JoinPoints joinByShortestPaths(const TriangleMesh& mesh, const ParallelFor& parallelFor)
{
  return [&mesh, parallelFor](
           const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)
  { return pathBetween(mesh, first, second, parallelFor, progress); };
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
