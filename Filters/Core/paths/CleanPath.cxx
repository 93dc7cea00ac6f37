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

std::vector<SurfacePoint> cleanedPath(const TriangleMesh& mesh,
  const std::vector<SurfacePoint>& path, const SurfacePoint& first, const SurfacePoint& second,
  double length)
{
  std::vector<SurfacePoint> result = { first };
  // A path may begin at a vertex at the place of the first point, behind faces without area.
  const bool isBehind = path.size() > 1 && commonFace(mesh, first, path[1]) == NoId &&
    commonFace(mesh, first, path[0]) != NoId;
  for (std::size_t i = isBehind ? 0 : 1; i + 1 < path.size(); ++i)
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

std::vector<SurfacePoint> cleanedTrace(
  const TriangleMesh& mesh, const std::vector<SurfacePoint>& path, double length)
{
  return path.empty()  ? path
    : path.size() == 1 ? std::vector<SurfacePoint>(2, path.front())
                       : cleanedPath(mesh, path, path.front(), path.back(), length);
}

}
