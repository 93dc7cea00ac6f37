// SPDX-License-Identifier: BSD-3-Clause
#include "paths/CleanPath.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The vertex that a point on an edge is at but for the rounding of tracing; else the point.
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

} // anonymous namespace

std::vector<SurfacePoint> cleanedPath(
  const TriangleMesh& mesh, const std::vector<SurfacePoint>& path, double length)
{
  if (path.empty())
  {
    return path;
  }
  std::vector<SurfacePoint> result = { path.front() };
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
  if (result.size() > 1 && samePlace(mesh, result.back(), path.back()))
  {
    result.pop_back();
  }
  result.push_back(path.back());
  return result;
}

}
