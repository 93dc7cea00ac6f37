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

/// Adds the points of a block.
void addPoints(
  const PolyDataBlock& block, const PowerOfTwoScale& scale, std::vector<LocatedPolyline>& points)
{
  std::vector<vtkIdType> bad;
  for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i)
  {
    Vec3 p;
    block.data->GetPoint(i, p.data());
    if (!isFinite(p))
    {
      bad.push_back(i);
      continue;
    }
    LocatedPolyline& point = points.emplace_back();
    point.points = { scale.toEngine(p) };
    if (!(norm(point.points.front()) < Infinity))
    {
      throw InputError("Point " + std::to_string(i) + " of " + block.name +
        " is too far from the surface for its size. Scale or move it upstream.");
    }
  }
  if (!bad.empty())
  {
    throw InputError(capitalized(block.name) +
      " has coordinates that are NaN or infinite, at point " + listIds(bad) +
      ". Remove or repair these points upstream.");
  }
}

std::vector<LocatedPolyline> readPoints(
  const std::vector<PolyDataBlock>& blocks, const std::string& name, const PowerOfTwoScale& scale)
{
  std::vector<LocatedPolyline> points;
  for (const PolyDataBlock& block : blocks)
  {
    addPoints(block, scale, points);
  }
  if (points.empty())
  {
    throw InputError(
      capitalized(name) + " is empty: there are no points. Connect at least one point.");
  }
  return points;
}

/// Of equally close faces the one in which the point lies on a vertex, or else on an edge, and else
/// the first: what putOntoSurface() does with a single point.
SnappedPoint snapped(
  const TriangleMesh& mesh, const LocatedPolyline& point, double coordinatePrecision)
{
  SnappedPoint best;
  bool isFirst = true;
  for (const Id face : point.faces.front())
  {
    const SnappedPoint here = snapToFace(mesh, face, point.points.front(), coordinatePrecision);
    if (isFirst || here.place.kind < best.place.kind)
    {
      best = here;
    }
    isFirst = false;
  }
  return best;
}

}

Targets readTargets(const std::vector<PolyDataBlock>& blocks, const std::string& name,
  const PolyDataSurface& surface, PolylineLocator& locator, const ProgressCallback& progress)
{
  std::vector<LocatedPolyline> points = readPoints(blocks, name, surface.scale());
  const double precision = snapOptionsFor(blocks).coordinatePrecision;
  locator.locate(points, precision,
    [&progress](double fraction) { return !progress || progress(Located * fraction); });
  Targets targets;
  targets.count = points.size();
  LoopProgress loop(progress);
  loop.nextUntil(Located);
  loop.nextUntil(1.0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    loop.at(i, points.size());
    if (surface.barriers() &&
      surface.barriers()->barrierAt(points[i].points.front(), points[i].faces.front(), precision) !=
        NoId)
    {
      continue;
    }
    const SnappedPoint point = snapped(surface.mesh(), points[i], precision);
    targets.numbers.push_back(i);
    targets.places.push_back(point.place);
    targets.snapDistances.push_back(point.distance);
  }
  return targets;
}

Targets readTargetsOfPiece(const std::vector<PolyDataBlock>& blocks, const std::string& name,
  const PolyDataSurface& surface, LocatorOnRanks& locator, const ProgressCallback& progress)
{
  std::vector<LocatedPolyline> points = readPoints(blocks, name, surface.scale());
  const double precision = snapOptionsFor(blocks).coordinatePrecision;
  std::vector<Vec3> places;
  for (const LocatedPolyline& point : points)
  {
    places.push_back(point.points.front());
  }
  const std::vector<std::vector<LocatorOnRanks::Found>> found =
    locator.locate(places, precision, progress);
  const MeshPartition& part = surface.partition();
  const std::vector<RankAddress> barriers = surface.barriersOnRanks()
    ? surface.barriersOnRanks()->barriersAt(places, found, precision)
    : std::vector<RankAddress>(places.size(), RankAddress{ -1, NoId });
  Targets targets;
  targets.count = points.size();
  // A target's face is the one that snapped() takes: vertices come first, then edges. The rank that
  // owns it has the target.
  std::vector<double> best(points.size(), Infinity);
  std::vector<SnappedPoint> own(points.size());
  std::vector<double> ranked(points.size(), Infinity);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t k = 0; k < found[i].size(); ++k)
    {
      const RankAddress& face = found[i][k].face;
      if (face.rank == part.exchange().rank())
      {
        const SnappedPoint here = snapToFace(part.mesh(), face.id, places[i], precision);
        const double order =
          static_cast<double>(static_cast<std::size_t>(here.place.kind) * found[i].size() + k);
        if (order < ranked[i])
        {
          ranked[i] = order;
          own[i] = here;
        }
      }
    }
    best[i] = ranked[i];
  }
  part.exchange().findLeast(best);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (ranked[i] == best[i] && best[i] < Infinity && barriers[i].id == NoId)
    {
      targets.numbers.push_back(i);
      targets.places.push_back(own[i].place);
      targets.snapDistances.push_back(own[i].distance);
    }
  }
  return targets;
}

}
