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
    corners[k] = { point.number == NoId ? this->ofInside(face, c[k]) : this->of(point.number),
      point.distance, point.place };
  }
  return this->lengthAtBorder(corners);
}

double RegionsOfPoints::lengthAtBorder(Id face, const Triangle& c)
{
  const TriangleMesh& mesh = this->faces_.field.mesh();
  const Id frame = longestHalfedge(mesh, face);
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    corners[k] = { this->of(c[k]),
      this->faces_.edges.distanceOf(c[k], this->faces_.field.vertexDistances()),
      inHalfedgeFrame(mesh, frame, this->faces_.edges.placeOf(c[k])) };
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

const SourceRegion& RegionsOfPoints::of(Id point)
{
  if (point >= this->ofPoints_.size())
  {
    this->ofPoints_.resize(
      this->faces_.field.mesh().numberOfVertices() + this->faces_.edges.points().size());
  }
  std::optional<SourceRegion>& region = this->ofPoints_[point];
  if (!region)
  {
    region = this->regions_.at(this->faces_.edges.placeOf(point));
  }
  return *region;
}

const SourceRegion& RegionsOfPoints::ofInside(const FaceTriangles& face, Id point)
{
  std::vector<std::optional<SourceRegion>>& regions = this->inside_[face.face()];
  regions.resize(std::max<std::size_t>(regions.size(), point + 1));
  if (!regions[point])
  {
    const Barycentric& weights = face.points()[point].weights;
    regions[point] = this->regions_.at(SurfacePoint::inFace(face.face(), weights[1], weights[2]));
  }
  return *regions[point];
}

}
