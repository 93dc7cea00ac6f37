// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RegionsOfPoints.h"

#include "Tolerance.h"
#include "refinement/TriangleShape.h"

namespace geodesic
{

SourceRegion RegionsOfPoints::regionAt(std::uint64_t key, const SurfacePoint& place)
{
  const auto [found, isNew] = this->known_.try_emplace(key);
  if (isNew)
  {
    found->second = this->regions_.at(place);
  }
  return found->second;
}

RegionsOfPoints::Corner RegionsOfPoints::cornerOf(Id face, Id point)
{
  const CutEdges& edges = this->faces_.edges;
  if (this->faces_.isOpen(face))
  {
    const FaceTriangles& open = this->faces_.triangles(face);
    const FaceTriangles::Point& p = open.points()[point];
    const SourceRegion region = p.number == NoId
      ? this->regionAt((static_cast<std::uint64_t>(face) + 1) << 32 | point, open.placeOf(point))
      : this->regionAt(p.number, edges.placeOf(p.number));
    return { region, p.distance, p.place };
  }
  const TriangleMesh& mesh = this->faces_.field.mesh();
  const SurfacePoint place = edges.placeOf(point);
  return { this->regionAt(point, place),
    edges.distanceOf(point, this->faces_.field.vertexDistances()),
    inHalfedgeFrame(mesh, longestHalfedge(mesh, face), place) };
}

double RegionsOfPoints::lengthAtBorder(Id face, const Triangle& corners)
{
  const std::array<Corner, 3> c = { this->cornerOf(face, corners[0]),
    this->cornerOf(face, corners[1]), this->cornerOf(face, corners[2]) };
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

}
