// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RegionsOfPoints.h"

#include "Tolerance.h"
#include "refinement/TriangleShape.h"

#include <algorithm>

namespace geodesic
{

double RegionsOfPoints::lengthAtBorder(const FaceTriangles& face, const Triangle& c)
{
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const FaceTriangles::Point& point = face.points()[c[k]];
    const bool isInside = point.number == NoId;
    const std::uint64_t key =
      isInside ? (static_cast<std::uint64_t>(face.face()) + 1) << 32 | c[k] : point.number;
    corners[k] = { this->regionAt(
                     key, isInside ? face.placeOf(c[k]) : this->faces_.edges.placeOf(point.number)),
      point.distance, point.place };
  }
  return this->lengthAtBorder(corners);
}

double RegionsOfPoints::lengthAtBorder(Id face, const Triangle& c)
{
  const TriangleMesh& mesh = this->faces_.field.mesh();
  const CutEdges& edges = this->faces_.edges;
  const Id frame = longestHalfedge(mesh, face);
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const SurfacePoint place = edges.placeOf(c[k]);
    corners[k] = { this->regionAt(c[k], place),
      edges.distanceOf(c[k], this->faces_.field.vertexDistances()),
      inHalfedgeFrame(mesh, frame, place) };
  }
  return this->lengthAtBorder(corners);
}

double RegionsOfPoints::lengthAtBorder(const std::array<Corner, 3>& c) const
{
  const auto isBorderBetween = [](const Corner& a, const Corner& b)
  {
    // Where a straight line crosses the curve between its sides, there is no border. Both ends are
    // then nearer to the crossing than to each other.
    return a.region.source != b.region.source ||
      (a.region.isRight != b.region.isRight &&
        a.distance + b.distance > (1.0 + tolerance::Tie) * norm(b.place - a.place));
  };
  if (!(isBorderBetween(c[0], c[1]) || isBorderBetween(c[1], c[2]) || isBorderBetween(c[2], c[0])))
  {
    return 0.0;
  }
  const double longest = longestEdge({ c[0].place, c[1].place, c[2].place });
  return longest > this->tolerance_ ? longest : 0.0;
}

SourceRegion RegionsOfPoints::regionAt(std::uint64_t key, const SurfacePoint& place)
{
  const auto [found, isNew] = this->known_.try_emplace(key);
  if (isNew)
  {
    found->second = this->regions_.at(place);
  }
  return found->second;
}

}
