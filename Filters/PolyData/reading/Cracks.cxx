// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/Cracks.h"

#include "PolyData/reading/PointGrid.h"
#include "Tolerance.h"
#include "mesh/Box.h"

#include "vtkLine.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace geodesic
{

namespace
{

/// An edge of the boundary.
struct BoundaryEdge
{
  Vec3 begin;
  Vec3 end;
  RankAddress face;
};

/// Those of the faces that this rank owns.
std::vector<BoundaryEdge> boundaryOf(const MeshPartition& partition)
{
  const TriangleMesh& mesh = partition.mesh();
  std::vector<BoundaryEdge> edges;
  for (Id face = partition.firstOwnFace(); face < partition.endOfOwnFaces(); ++face)
  {
    for (const Id h : TriangleMesh::halfedgesOf(face))
    {
      if (mesh.isBoundary(h))
      {
        edges.push_back({ mesh.point(mesh.origin(h)), mesh.point(mesh.destination(h)),
          partition.addressOf(face) });
      }
    }
  }
  return edges;
}

/// Finds edges near places, as each edge has some points in it. (The locators of VTK start threads
/// to find the bounds of a few lines.)
///
/// \param reach a place is within the reach of such a point if it is no farther from the edge.
PointGrid gridOf(const std::vector<BoundaryEdge>& edges, double reach)
{
  const double spacing = 0.25 * PointGrid::cubeFor(reach);
  PointGrid grid;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const Vec3 along = edges[i].end - edges[i].begin;
    const double steps = std::max(1.0, std::ceil(norm(along) / spacing));
    for (double step = 0.0; step <= steps; ++step)
    {
      grid.add(edges[i].begin + (step / steps) * along, reach, i);
    }
  }
  return grid;
}

double distanceBetween(const Vec3& point, const BoundaryEdge& edge)
{
  double along = 0.0;
  Vec3 closest;
  return std::sqrt(vtkLine::DistanceToLine(
    point.data(), edge.begin.data(), edge.end.data(), along, closest.data()));
}

}

void findCracks(const MeshPartition& partition, double diagonal, SurfaceReport& report)
{
  const double width = tolerance::CrackWidth * diagonal;
  const std::vector<BoundaryEdge> own = boundaryOf(partition);
  const std::vector<BoundaryEdge> edges = valuesOfRanks(partition.exchange(), own);
  const double length = std::accumulate(edges.begin(), edges.end(), 0.0,
    [](double sum, const BoundaryEdge& edge) { return sum + norm(edge.end - edge.begin); });
  const double reach =
    std::max(length / static_cast<double>(std::max<std::size_t>(edges.size(), 1)), width);
  const PointGrid grid = gridOf(edges, reach);
  for (const BoundaryEdge& edge : own)
  {
    const Vec3 middle = 0.5 * (edge.begin + edge.end);
    const double limit = std::min(width, tolerance::CrackFraction * norm(edge.end - edge.begin));
    double least = Infinity;
    grid.visitNear(middle, reach,
      [&](std::size_t i)
      {
        const BoundaryEdge& other = edges[i];
        Box around{ other.begin, other.begin };
        around.add(other.end);
        const bool isOfAnotherFace = edge.face < other.face || other.face < edge.face;
        if (isOfAnotherFace && around.distanceTo(middle) <= limit)
        {
          least = std::min(least, distanceBetween(middle, other));
        }
      });
    if (least <= limit)
    {
      ++report.crackEdges;
      report.crackWidth = std::max(report.crackWidth, least);
    }
  }
}

}
