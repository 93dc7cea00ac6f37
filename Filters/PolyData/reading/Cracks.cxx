// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/Cracks.h"

#include "PolyData/Hash.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/reading/SeamVertices.h"
#include "Tolerance.h"

#include "vtkLine.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
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

  Box around(double margin) const
  {
    Box box = boxAround(this->begin, margin);
    box.add(boxAround(this->end, margin));
    return box;
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

/// Those of other ranks that are near this rank's.
std::vector<BoundaryEdge> edgesOfOthers(
  const std::vector<BoundaryEdge>& own, double margin, Exchange& exchange)
{
  Box box;
  for (const BoundaryEdge& edge : own)
  {
    box.add(edge.around(margin));
  }
  const OtherRanks others(box, exchange);
  Message message;
  for (const BoundaryEdge& edge : own)
  {
    if (others.areNear(edge.around(margin)))
    {
      put(message, edge);
    }
  }
  std::vector<BoundaryEdge> edges;
  readEach(exchange.tellAll(message),
    [&](int rank, MessageReader& reader)
    {
      const auto edge = reader.get<BoundaryEdge>();
      if (rank != exchange.rank() && box.meets(edge.around(0.0)))
      {
        edges.push_back(edge);
      }
    });
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
    this->level_ = seamLevelFor(std::max(mean, farthest));
    // A place is within half a cube of such a point if it is no farther from the edge.
    const double spacing = std::ldexp(0.25, this->level_);
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const Vec3 along = edges[i].end - edges[i].begin;
      const double steps = std::max(1.0, std::ceil(norm(along) / spacing));
      for (double step = 0.0; step <= steps; ++step)
      {
        std::vector<std::size_t>& inCell =
          this->grid_[seamCellAt(edges[i].begin + (step / steps) * along, this->level_)];
        if (inCell.empty() || inCell.back() != i)
        {
          inCell.push_back(i);
        }
      }
    }
  }

  /// How far the middle of an edge is from the nearest edge of another face; infinite if none is
  /// within the limit, which is at most the farthest.
  double distanceFrom(const BoundaryEdge& edge, double limit) const
  {
    const Vec3 middle = 0.5 * (edge.begin + edge.end);
    double least = Infinity;
    for (const SeamCell& cell : seamCellsAround(middle, this->level_))
    {
      const auto found = this->grid_.find(cell);
      for (std::size_t k = 0; found != this->grid_.end() && k < found->second.size(); ++k)
      {
        const BoundaryEdge& other = this->edges_[found->second[k]];
        const bool isOfAnotherFace = edge.face < other.face || other.face < edge.face;
        if (isOfAnotherFace && other.around(limit).holds(middle))
        {
          double along = 0.0;
          Vec3 closest;
          least = std::min(least,
            std::sqrt(vtkLine::DistanceToLine(
              middle.data(), other.begin.data(), other.end.data(), along, closest.data())));
        }
      }
    }
    return least <= limit ? least : Infinity;
  }

private:
  const std::vector<BoundaryEdge>& edges_;
  int level_;
  std::unordered_map<SeamCell, std::vector<std::size_t>, Hash> grid_;
};

}

void findCracks(const MeshPartition& partition, double diagonal, SurfaceReport& report)
{
  const double width = tolerance::CrackWidth * diagonal;
  std::vector<BoundaryEdge> edges = boundaryOf(partition);
  const std::size_t count = edges.size();
  const std::vector<BoundaryEdge> others = edgesOfOthers(edges, width, partition.exchange());
  edges.insert(edges.end(), others.begin(), others.end());
  if (count == 0)
  {
    return;
  }
  const EdgeLocator locator(edges, width);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double length = norm(edges[i].end - edges[i].begin);
    const double distance =
      locator.distanceFrom(edges[i], std::min(width, tolerance::CrackFraction * length));
    if (distance < Infinity)
    {
      ++report.crackEdges;
      report.crackWidth = std::max(report.crackWidth, distance);
    }
  }
}

}
