// SPDX-License-Identifier: BSD-3-Clause
#include "field/ShortestPathFinder.h"

#include "Errors.h"
#include "Tolerance.h"
#include "field/EdgePath.h"
#include "field/ShortestPath.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The vertex that an edge point cannot be told from by the rounding of tracing; else the point.
SurfacePoint atVertexWithin(const TriangleMesh& mesh, const SurfacePoint& point, double rounding)
{
  if (point.kind != SurfacePoint::Kind::Edge)
  {
    return point;
  }
  const double length = mesh.length(point.id);
  const double reach = std::min(rounding, tolerance::SnapFraction * length);
  if (point.u * length <= reach)
  {
    return SurfacePoint::atVertex(mesh.origin(point.id));
  }
  if ((1.0 - point.u) * length <= reach)
  {
    return SurfacePoint::atVertex(mesh.destination(point.id));
  }
  return point;
}

/// Leaves out what tracing adds by rounding: crossings of edges at their ends, repeated points. The
/// ends are the given ones. What is left has the faces in common that it had.
std::vector<SurfacePoint> cleaned(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path,
  const SurfacePoint& first, const SurfacePoint& second, double length)
{
  std::vector<SurfacePoint> result = { first };
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    const SurfacePoint atVertex = atVertexWithin(mesh, path[i], tolerance::PathAtVertex * length);
    const bool isKept = commonFace(mesh, result.back(), atVertex) != NoId &&
      commonFace(mesh, atVertex, path[i + 1]) != NoId;
    const SurfacePoint& point = isKept ? atVertex : path[i];
    if (!samePlace(mesh, point, result.back()))
    {
      result.push_back(point);
    }
  }
  if (result.size() > 1 && samePlace(mesh, result.back(), second))
  {
    result.pop_back();
  }
  result.push_back(second);
  return result;
}

/// A path that broke off, or an empty one, has ends without a common face.
void checkWhole(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path)
{
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    if (commonFace(mesh, path[i - 1], path[i]) == NoId)
    {
      throw Error("The shortest path between two points of the source could not be traced.");
    }
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
  const Patch patch(this->mesh_, first, second, length, this->workSpace_, progress);
  std::vector<SurfacePoint> path =
    shortestPath(patch.mesh(), patch.first(), patch.second(), length, this->parallelFor_, progress);
  for (SurfacePoint& point : path)
  {
    point = patch.onSurface(point);
  }
  path = cleaned(this->mesh_, path, first, second, length);
  checkWhole(this->mesh_, path);
  return path;
}

}
