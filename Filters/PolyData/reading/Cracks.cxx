// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/Cracks.h"

#include "PolyData/ranks/RankSeams.h"
#include "Tolerance.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkLine.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
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
    for (Id h = 3 * face; h < 3 * face + 3; ++h)
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

/// Finds edges by their places.
class EdgeLocator
{
public:
  explicit EdgeLocator(const std::vector<BoundaryEdge>& edges)
    : edges_(edges)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    for (const BoundaryEdge& edge : edges)
    {
      const vtkIdType ends[] = { points->InsertNextPoint(edge.begin.data()),
        points->InsertNextPoint(edge.end.data()) };
      lines->InsertNextCell(2, ends);
    }
    this->lines_->SetPoints(points);
    this->lines_->SetLines(lines);
    this->locator_->SetDataSet(this->lines_);
    this->locator_->SetNumberOfCellsPerNode(2);
    this->locator_->BuildLocator();
  }

  /// How far the middle of an edge is from the nearest edge of another face; infinite if none is
  /// within the limit.
  double distanceFrom(const BoundaryEdge& edge, double limit)
  {
    const Vec3 middle = 0.5 * (edge.begin + edge.end);
    const Box box = boxAround(middle, limit);
    double bounds[] = { box.low[0], box.high[0], box.low[1], box.high[1], box.low[2], box.high[2] };
    this->locator_->FindCellsWithinBounds(bounds, this->found_);
    double least = Infinity;
    for (vtkIdType i = 0; i < this->found_->GetNumberOfIds(); ++i)
    {
      const BoundaryEdge& other = this->edges_[static_cast<std::size_t>(this->found_->GetId(i))];
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
    return least <= limit ? least : Infinity;
  }

private:
  const std::vector<BoundaryEdge>& edges_;
  vtkNew<vtkPolyData> lines_;
  vtkNew<vtkStaticCellLocator> locator_;
  vtkNew<vtkIdList> found_;
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
  EdgeLocator locator(edges);
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
