// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/Targets.h"

#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/SourceCells.h"
#include "mesh/SurfaceSnap.h"

namespace geodesic
{

namespace
{

/// The share of the job for finding the closest faces.
constexpr double Located = 0.8;

/// The targets, as polylines of one point each.
std::vector<LocatedPolyline> readPoints(const std::vector<PolyDataBlock>& blocks,
  const PartName& name, const PolyDataSurface& surface, double precision)
{
  std::vector<LocatedPolyline> points;
  for (const PolyDataBlock& block : blocks)
  {
    requireFinite(block);
    for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i)
    {
      addPoint(block, i, surface, precision, points.emplace_back());
    }
  }
  if (points.empty())
  {
    throw InputError(
      name.atBeginning() + " is empty: there are no points. Connect at least one point.");
  }
  return points;
}

/// Where a rank would put a target.
struct OwnPlace
{
  SnappedPoint point;
  /// The rank with the least has the target.
  double order = Infinity;
};

/// If several faces are equally close, chooses one in which the point lies on a vertex, or else on
/// an edge, or else the first one, as putOntoSurface() does with a single point.
OwnPlace snapToOwnFace(const MeshPartition& surface, const Vec3& point,
  const std::vector<ClosestFace>& closest, double coordinatePrecision)
{
  OwnPlace best;
  for (std::size_t k = 0; k < closest.size(); ++k)
  {
    if (closest[k].face.rank == surface.exchange().rank())
    {
      const SnappedPoint here =
        snapToFace(surface.mesh(), closest[k].face.id, point, coordinatePrecision);
      const auto kind = static_cast<std::size_t>(here.place.kind);
      const auto order = static_cast<double>(kind * closest.size() + k);
      best = order < best.order ? OwnPlace{ here, order } : best;
    }
  }
  return best;
}

}

Targets readTargets(const std::vector<PolyDataBlock>& blocks, const PartName& name,
  const PolyDataSurface& surface, PolylineLocator& locator, const Job& job)
{
  const double precision = coordinatePrecisionOf(blocks);
  const std::vector<LocatedPolyline> points = readPoints(blocks, name, surface, precision);
  const LocatedPlaces located = locator.locate(points, precision, job.part(0.0, Located));
  std::vector<RankAddress> barriers(located.places.size(), RankAddress{ 0, NoId });
  if (surface.barriers)
  {
    barriers = surface.barriers->barriersAt(located.places, located.faces, precision);
  }
  const Job snapping = job.part(Located, 1.0);
  std::vector<OwnPlace> own;
  std::vector<double> orders;
  for (std::size_t i = 0; i < located.places.size(); ++i)
  {
    snapping.reachItem(i, located.places.size());
    own.push_back(snapToOwnFace(surface.partition, located.places[i], located.faces[i], precision));
    orders.push_back(own.back().order);
  }
  surface.exchange().findLeast(orders);
  Targets targets;
  targets.count = points.size();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const std::size_t place = located.indexOf(points[i].points.front());
    if (own[place].order < Infinity && own[place].order == orders[place] &&
      barriers[place].id == NoId)
    {
      targets.numbers.push_back(i);
      const Id vertex = points[i].vertexOf(0);
      targets.places.push_back(
        vertex == NoId ? own[place].point.place : SurfacePoint::atVertex(vertex));
      targets.snapDistances.push_back(own[place].point.distance);
    }
  }
  return targets;
}

}
