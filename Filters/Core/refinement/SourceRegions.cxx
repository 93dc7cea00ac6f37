// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SourceRegions.h"

#include "Tolerance.h"
#include "field/IncomingSegment.h"
#include "refinement/RefinementWorkers.h"
#include "refinement/TriangleError.h"

namespace geodesic
{

SourceRegion SourceRegions::at(const SurfacePoint& point)
{
  return point.kind == SurfacePoint::Kind::Vertex
    ? this->of(this->nearest_.atVertex(point.id))
    : this->of(this->nearest_.of(incomingSegmentTo(this->field_, point)));
}

SourceRegion SourceRegions::of(const Foot& foot) const
{
  if (!foot.isKnown())
  {
    return {};
  }
  const SourceCurve& curve = this->curves_[foot.curve];
  return { curve.source, this->bySides_ && foot.isRight && curve.points.size() > 1 };
}

std::vector<std::uint8_t> SourceRegions::facesAtBorders()
{
  const MeshPartition& surface = this->field_.surface();
  const auto isBorder = [this](Id a, Id b)
  { return this->of(this->nearest_.atVertex(a)) != this->of(this->nearest_.atVertex(b)); };
  std::vector<std::uint8_t> faces(surface.mesh().numberOfFaces(), 0);
  for (Id face = surface.firstOwnFace(); face < surface.endOfOwnFaces(); ++face)
  {
    const Triangle& t = surface.mesh().triangle(face);
    faces[face] = isBorder(t[0], t[1]) || isBorder(t[0], t[2]) ? 1 : 0;
  }
  return faces;
}

double RegionsOfPoints::lengthAtBorder(Id face, const Triangle& c)
{
  if (!this->regionOf_ ||
    !(this->isBorderBetween(face, c[0], c[1]) || this->isBorderBetween(face, c[1], c[2]) ||
      this->isBorderBetween(face, c[2], c[0])))
  {
    return 0.0;
  }
  const double longest = longestEdge({ this->triangles_.inPlane(c[0], face),
    this->triangles_.inPlane(c[1], face), this->triangles_.inPlane(c[2], face) });
  return longest > this->tolerance_ ? longest : 0.0;
}

bool RegionsOfPoints::isBorderBetween(Id face, Id a, Id b)
{
  const SourceRegion ofA = this->of(a);
  const SourceRegion ofB = this->of(b);
  if (ofA.source != ofB.source)
  {
    return true;
  }
  if (ofA.isRight == ofB.isRight)
  {
    return false;
  }
  // Where the line crosses the curve, both ends are nearer to the crossing than to each other.
  const double length = norm(this->triangles_.inPlane(b, face) - this->triangles_.inPlane(a, face));
  return this->distances_.atPoint(a) + this->distances_.atPoint(b) >
    (1.0 + tolerance::Tie) * length;
}

SourceRegion RegionsOfPoints::of(Id point)
{
  if (point >= this->regions_.size())
  {
    this->regions_.resize(this->numberOfPoints());
  }
  std::optional<SourceRegion>& region = this->regions_[point];
  if (!region)
  {
    region = this->regionOf_(this->triangles_.place(point));
  }
  return *region;
}

std::size_t RegionsOfPoints::numberOfPoints() const
{
  return this->triangles_.numberOfInputPoints() + this->triangles_.points().size();
}

void RegionsOfPoints::forgetNewPoints()
{
  if (this->regions_.size() > this->numberOfPoints())
  {
    this->regions_.resize(this->numberOfPoints());
  }
}

}
