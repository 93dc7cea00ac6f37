// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/Cracks.h"

#include "PolyData/reading/PointGrid.h"
#include "Tolerance.h"
#include "mesh/Box.h"

#include "vtkLine.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

  bool holds(const Vec3& point, double margin) const
  {
    const Vec3 margins = { margin, margin, margin };
    Box box{ this->begin - margins, this->begin + margins };
    box.add({ this->end - margins, this->end + margins });
    return box.holds(point);
  }
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

/// Finds edges near places, by a grid in which each edge has some points. (The locators of VTK
/// start threads to find the bounds of a few lines.)
class EdgeLocator
{
public:
  /// \param farthest how far an edge may be from a place at most.
  EdgeLocator(const std::vector<BoundaryEdge>& edges, double farthest)
    : edges_(edges)
  {
    double sum = 0.0;
    for (const BoundaryEdge& edge : edges)
    {
      sum += norm(edge.end - edge.begin);
    }
    const double mean = sum / static_cast<double>(edges.size());
    this->reach_ = std::max(mean, farthest);
    // A place is within the reach of such a point if it is no farther from the edge.
    const double spacing = 0.25 * PointGrid::cubeFor(this->reach_);
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const Vec3 along = edges[i].end - edges[i].begin;
      const double steps = std::max(1.0, std::ceil(norm(along) / spacing));
      for (double step = 0.0; step <= steps; ++step)
      {
        this->grid_.add(edges[i].begin + (step / steps) * along, this->reach_, i);
      }
    }
  }

  /// How far the middle of an edge is from the nearest edge of another face; infinite if none is
  /// within the limit, which is at most the farthest.
  double distanceFrom(const BoundaryEdge& edge, double limit) const
  {
    const Vec3 middle = 0.5 * (edge.begin + edge.end);
    double least = Infinity;
    this->grid_.visitNear(middle, this->reach_,
      [&](std::size_t i)
      {
        const BoundaryEdge& other = this->edges_[i];
        const bool isOfAnotherFace = edge.face < other.face || other.face < edge.face;
        if (isOfAnotherFace && other.holds(middle, limit))
        {
          double along = 0.0;
          Vec3 closest;
          least = std::min(least,
            std::sqrt(vtkLine::DistanceToLine(
              middle.data(), other.begin.data(), other.end.data(), along, closest.data())));
        }
      });
    return least <= limit ? least : Infinity;
  }

private:
  const std::vector<BoundaryEdge>& edges_;
  double reach_;
  PointGrid grid_;
};

}

void findCracks(const MeshPartition& partition, double diagonal, SurfaceReport& report)
{
  const double width = tolerance::CrackWidth * diagonal;
  const std::vector<BoundaryEdge> own = boundaryOf(partition);
  const std::vector<BoundaryEdge> edges = valuesOfRanks(partition.exchange(), own);
  if (own.empty())
  {
    return;
  }
  const EdgeLocator locator(edges, width);
  for (const BoundaryEdge& edge : own)
  {
    const double length = norm(edge.end - edge.begin);
    const double distance =
      locator.distanceFrom(edge, std::min(width, tolerance::CrackFraction * length));
    if (distance < Infinity)
    {
      ++report.crackEdges;
      report.crackWidth = std::max(report.crackWidth, distance);
    }
  }
}

}
