// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/BarrierFaces.h"

#include "mesh/SurfaceSnap.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// How far each point is from its closest faces, which reach as far as this fraction of their
/// longest edge.
std::vector<double> distancesTo(const MeshPartition& surface, const std::vector<Vec3>& points,
  const ClosestFaces& closest, double coordinatePrecision, double rim)
{
  std::vector<double> distances(points.size(), Infinity);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const ClosestFace& found : closest[i])
    {
      if (found.face.rank == surface.exchange().rank())
      {
        const double away =
          snapToFace(surface.mesh(), found.face.id, points[i], coordinatePrecision).distance;
        const double reach = rim * surface.mesh().shape(found.face.id).longest();
        distances[i] = std::min(distances[i], std::max(away - reach, 0.0));
      }
    }
  }
  surface.exchange().findLeast(distances);
  return distances;
}

} // anonymous namespace

std::vector<RankAddress> BarrierFaces::barriersAt(const std::vector<Vec3>& points,
  const ClosestFaces& closest, double coordinatePrecision, double rim)
{
  const std::vector<double> toOpen =
    distancesTo(this->open_, points, closest, coordinatePrecision, rim);
  std::vector<std::uint8_t> isBesideOpen;
  for (const double distance : toOpen)
  {
    isBesideOpen.push_back(distance > 0.0 ? 1 : 0);
  }
  const ClosestFaces candidates = this->locator_.closest(points, isBesideOpen, coordinatePrecision);
  // Each rank finds the first of its own barriers that holds a point; the first of all ranks
  // counts. A place on the rim is a place on an open face, too, which is as close there. A point
  // lies in a barrier if it is nearer to it by more than the precision of its place.
  std::vector<double> first(points.size(), Infinity);
  Exchange& exchange = this->surface().exchange();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t k = 0; k < candidates[i].size() && first[i] == Infinity; ++k)
    {
      const RankAddress& face = candidates[i][k].face;
      if (face.rank == exchange.rank())
      {
        const SnappedPoint place =
          snapToFace(this->surface().mesh(), face.id, points[i], coordinatePrecision);
        const bool isInside = place.distance + place.tolerance < toOpen[i];
        first[i] = isInside ? static_cast<double>(k) : Infinity;
      }
    }
  }
  exchange.findLeast(first);
  std::vector<RankAddress> result(points.size(), RankAddress{ -1, NoId });
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (first[i] < Infinity)
    {
      result[i] = candidates[i][static_cast<std::size_t>(first[i])].face;
    }
  }
  return result;
}

}
