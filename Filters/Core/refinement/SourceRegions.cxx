// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SourceRegions.h"

#include "field/IncomingSegment.h"

namespace geodesic
{

SourceRegion SourceRegions::at(const SurfacePoint& point)
{
  const auto [found, isNew] = this->known_.try_emplace(point.members());
  if (isNew)
  {
    found->second = point.kind == SurfacePoint::Kind::Vertex
      ? this->of(this->nearest_.atVertex(point.id))
      : this->of(this->nearest_.of(incomingSegmentTo(this->field_, point)));
  }
  return found->second;
}

SourceRegion SourceRegions::of(const Foot& foot) const
{
  if (!foot.isKnown())
  {
    return {};
  }
  return { this->curves_[foot.curve].source, this->bySides_ && foot.isRight };
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

}
