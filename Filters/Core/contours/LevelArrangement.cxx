// SPDX-License-Identifier: BSD-3-Clause
#include "contours/LevelArrangement.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The lines along a triangle's edges; an edge without length has no direction.
std::array<PlaneLine, 3> edgesOf(const std::array<Vec2, 3>& corners)
{
  std::array<PlaneLine, 3> edges;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec2 edge = corners[(k + 1) % 3] - corners[k];
    const double length = norm(edge);
    edges[k] = { corners[k], length > 0.0 ? (1.0 / length) * edge : Vec2{} };
  }
  return edges;
}

} // anonymous namespace

FaceLevel::FaceLevel(const FaceDistance& distance, double levelValue)
  : face(distance)
  , value(levelValue)
  , corners{ distance.inPlane(cornerWeights(0)), distance.inPlane(cornerWeights(1)),
    distance.inPlane(cornerWeights(2)) }
  , size(std::max({ norm(corners[1] - corners[0]), norm(corners[2] - corners[1]),
      norm(corners[0] - corners[2]) }))
  , gap(tolerance::IsolineGap * std::min(size, value))
  , slack(tolerance::IsolineValue * (value + size))
{
}

void LevelArrangement::assign(const FaceLevel& level, bool withBent, double offset)
{
  this->level_ = &level;
  this->regions_.clear();
  this->curves_.clear();
  const std::vector<DistanceCandidate>& candidates = level.face.candidates();
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (withBent || !level.face.isRegularCorner(i))
    {
      this->addRegion(candidates[i], offset);
    }
  }
  for (const DistanceCandidate& c : candidates)
  {
    if (withBent && c.hasPencil())
    {
      this->addRegion(DistanceCandidate::cone(c.begin, c.atBegin), offset);
      this->addRegion(DistanceCandidate::cone(c.end, c.atEnd), offset);
    }
  }
  this->findExtents();
}

// Most pencils are parallel, or nearly: across their rays, each region is near few others.
void LevelArrangement::findExtents()
{
  Vec2 direction{};
  for (const LevelRegion& region : this->regions_)
  {
    direction = direction + region.direction();
  }
  const double length = norm(direction);
  this->axis_ = length > 0.0 ? (1.0 / length) * leftOf(direction) : Vec2{ 1.0, 0.0 };
  this->extents_.clear();
  for (const LevelRegion& region : this->regions_)
  {
    this->extents_.push_back(region.alongAxis(this->axis_, this->level_->size));
  }
}

void LevelArrangement::addRegion(const DistanceCandidate& candidate, double offset)
{
  const std::size_t number = this->regions_.size();
  const double offsetScale = this->level_->value +
    std::min(this->level_->size, tolerance::OffsetFaceInValues * this->level_->value);
  const double value = this->level_->value - static_cast<double>(number) * offset * offsetScale;
  if (hasPointsBefore(candidate, value))
  {
    this->regions_.emplace_back(candidate, value, tolerance::PencilMargin * this->level_->size);
    std::size_t curve = this->curves_.size();
    this->regions_.back().addCurves(this->level_->corners, this->level_->gap, this->curves_);
    for (; curve < this->curves_.size(); ++curve)
    {
      this->curves_[curve].region = number;
    }
  }
}

bool LevelArrangement::isWithinOneRegion() const
{
  return std::any_of(this->regions_.begin(), this->regions_.end(),
    [&corners = this->level_->corners](const LevelRegion& region)
    {
      return std::all_of(
        corners.begin(), corners.end(), [&region](Vec2 corner) { return region.contains(corner); });
    });
}

std::vector<LevelArrangement::Remainder> LevelArrangement::remainders()
{
  const std::array<PlaneLine, 3> edges = edgesOf(this->level_->corners);
  std::vector<Remainder> remainders;
  for (const LevelCurve& curve : this->curves_)
  {
    this->cut(curve, edges, remainders);
  }
  remainders.erase(std::remove_if(remainders.begin(), remainders.end(),
                     [this](const Remainder& r) { return this->isScrap(r); }),
    remainders.end());
  return remainders;
}

// Cuts a curve first to where it lies in the face, then by the regions that come near.
void LevelArrangement::cut(const LevelCurve& curve, const std::array<PlaneLine, 3>& edges,
  std::vector<Remainder>& remainders)
{
  this->atEdges_.clear();
  const CurvePart whole(curve, 0.0, curve.extent, this->level_->gap);
  for (const PlaneLine& edge : edges)
  {
    if (edge.mostAside(whole) < 0.0)
    {
      return;
    }
    if (edge.leastAside(whole) < 0.0)
    {
      addMeetings(curve, edge, this->atEdges_);
    }
  }
  const auto isInside = [&](Vec2 p)
  {
    return std::all_of(
      edges.begin(), edges.end(), [p](const PlaneLine& edge) { return edge.aside(p) >= 0.0; });
  };
  std::sort(this->atEdges_.begin(), this->atEdges_.end());
  this->atEdges_.push_back(curve.extent);
  double begin = 0.0;
  for (const double end : this->atEdges_)
  {
    if (end > begin && isInside(curve.at(0.5 * (begin + end))))
    {
      const CurvePart part(curve, begin, end, this->level_->gap);
      this->cutByRegions(part, begin, end, remainders);
    }
    begin = std::max(begin, end);
  }
}

void LevelArrangement::cutByRegions(
  const CurvePart& part, double first, double last, std::vector<Remainder>& remainders)
{
  const LevelCurve& curve = part.curve;
  const Interval extent = part.alongAxis(this->axis_);
  this->atRegions_.clear();
  this->near_.clear();
  for (std::size_t i = 0; i < this->regions_.size(); ++i)
  {
    const LevelRegion& region = this->regions_[i];
    if (this->extents_[i].end < extent.begin || extent.end < this->extents_[i].begin ||
      i == curve.region || region.misses(part))
    {
      continue;
    }
    if (region.covers(part))
    {
      return;
    }
    this->near_.push_back(&region);
    region.addMeetings(part, this->atRegions_);
  }
  std::sort(this->atRegions_.begin(), this->atRegions_.end());
  this->atRegions_.push_back(last);
  this->job_.look();
  const auto isOutside = [this](Vec2 p)
  {
    return std::none_of(this->near_.begin(), this->near_.end(),
      [p](const LevelRegion* region) { return region->contains(p); });
  };
  double begin = first;
  bool goesOn = false;
  for (const double parameter : this->atRegions_)
  {
    const double end = std::min(parameter, last);
    if (end > begin)
    {
      const bool remains = isOutside(curve.at(0.5 * (begin + end)));
      if (remains && goesOn)
      {
        remainders.back().end = end;
      }
      else if (remains)
      {
        remainders.push_back({ &curve, begin, end });
      }
      goesOn = remains;
      begin = end;
    }
  }
}

// Whether a remainder lies between two pencils that rounding has parted: there a path that bends at
// the end of one of them is shorter. A longer remainder there bends away from the line, by the
// square of its length over a radius, so that its ends meet no others.
bool LevelArrangement::isScrap(const Remainder& remainder) const
{
  const auto& [curve, begin, end] = remainder;
  const FaceLevel& level = *this->level_;
  const Vec2 chord = curve->at(end) - curve->at(begin);
  return dot(chord, chord) <= level.gap * (level.size + level.value) &&
    level.face.distance(curve->at(0.5 * (begin + end))) < level.value - level.slack;
}

}
