// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/PolyDataTargets.h"

#include "PolyData/reading/PolyDataSource.h"
#include "mesh/SurfaceSnap.h"

#include "vtkPolyData.h"

#include <cmath>

namespace geodesic
{

namespace
{

/// The share of the progress for finding the closest faces.
constexpr double Located = 0.8;

std::vector<LocatedPolyline> readPoints(
  const std::vector<PolyDataBlock>& blocks, const std::string& name, const PowerOfTwoScale& scale)
{
  std::vector<LocatedPolyline> points;
  for (const PolyDataBlock& block : blocks)
  {
    for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i)
    {
      Vec3 p;
      block.data->GetPoint(i, p.data());
      LocatedPolyline& point = points.emplace_back();
      point.points = { scale.toEngine(p) };
      if (isFinite(p) && !(norm(point.points.front()) < Infinity))
      {
        throw InputError("Point " + std::to_string(i) + " of " + block.name +
          " is too far from the surface for its size. Scale or move it upstream.");
      }
    }
    if (const std::string bad = whereNotFinite(block); !bad.empty())
    {
      throw InputError(bad);
    }
  }
  if (points.empty())
  {
    throw InputError(
      capitalized(name) + " is empty: there are no points. Connect at least one point.");
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

/// Of equally close faces the one in which the point lies on a vertex, or else on an edge, and else
/// the first: what putOntoSurface() does with a single point.
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

Targets readTargets(const std::vector<PolyDataBlock>& blocks, const std::string& name,
  const PolyDataSurface& surface, PolylineLocator& locator, const ProgressCallback& progress)
{
  const std::vector<LocatedPolyline> points = readPoints(blocks, name, surface.scale);
  const double precision = snapOptionsFor(blocks).coordinatePrecision;
  const LocatedPlaces located = locator.locate(points, precision,
    [&progress](double fraction) { return !progress || progress(Located * fraction); });
  const std::vector<RankAddress> barriers = barriersAt(surface, located, precision);
  LoopProgress loop(progress);
  loop.nextUntil(Located);
  loop.nextUntil(1.0);
  std::vector<OwnPlace> own;
  std::vector<double> orders;
  for (std::size_t i = 0; i < located.places.size(); ++i)
  {
    loop.at(i, located.places.size());
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
      targets.places.push_back(own[place].point.place);
      targets.snapDistances.push_back(own[place].point.distance);
    }
  }
  return targets;
}

}
