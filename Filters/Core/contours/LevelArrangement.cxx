// SPDX-License-Identifier: BSD-3-Clause
#include "contours/LevelArrangement.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// With some room for roundings.
PlaneBox boxAround(const std::array<Vec2, 3>& corners, double size)
{
  const auto [lowX, highX] = std::minmax({ corners[0].x, corners[1].x, corners[2].x });
  const auto [lowY, highY] = std::minmax({ corners[0].y, corners[1].y, corners[2].y });
  return { { lowX - tolerance::PlaneBoxRoom * size, lowY - tolerance::PlaneBoxRoom * size },
    { highX + tolerance::PlaneBoxRoom * size, highY + tolerance::PlaneBoxRoom * size } };
}

/// Around a part of a curve.
PlaneBox boxAround(const LevelCurve& curve, double begin, double end, double room)
{
  const Vec2 a = curve.at(begin);
  const Vec2 b = curve.at(end);
  // An upper bound of the part's length. An arc is not farther from its chord than this, nor than
  // its own length.
  const double way = (end - begin) * (curve.isArc ? 2.0 * curve.radius : 1.0);
  const double aside = room + (curve.isArc ? std::min(way, 0.125 * way * way / curve.radius) : 0.0);
  return { { std::min(a.x, b.x) - aside, std::min(a.y, b.y) - aside },
    { std::max(a.x, b.x) + aside, std::max(a.y, b.y) + aside } };
}

bool isInside(const std::array<Vec2, 3>& corners, Vec2 p)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (cross(corners[(k + 1) % 3] - corners[k], p - corners[k]) < 0.0)
    {
      return false;
    }
  }
  return true;
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
  this->box = boxAround(this->corners, this->size);
}

void LevelArrangement::assign(const FaceLevel& level, bool withBent, double offset)
{
  this->level_ = &level;
  this->regions_.clear();
  this->curves_.clear();
  for (const DistanceCandidate& c : level.face.candidates())
  {
    this->addRegion(c, offset);
  }
  for (const DistanceCandidate& c : level.face.candidates())
  {
    if (withBent && c.hasPencil())
    {
      using Kind = DistanceCandidate::Kind;
      this->addRegion({ Kind::Cone, c.atBegin, c.begin, {}, {}, 0.0, 0.0 }, offset);
      this->addRegion({ Kind::Cone, c.atEnd, c.end, {}, {}, 0.0, 0.0 }, offset);
    }
  }
}

void LevelArrangement::addRegion(const DistanceCandidate& candidate, double offset)
{
  const std::size_t number = this->regions_.size();
  const double offsetScale = this->level_->value +
    std::min(this->level_->size, tolerance::OffsetFaceInValues * this->level_->value);
  const double value = this->level_->value - static_cast<double>(number) * offset * offsetScale;
  const LevelRegion region(candidate, number, value, tolerance::PencilMargin * this->level_->size);
  if (region.hasPointsBefore(value) && !region.misses(this->level_->box))
  {
    region.addCurves(this->level_->box, this->curves_);
    this->regions_.push_back(region);
  }
}

bool LevelArrangement::isWithinOneRegion(const std::array<Vec2, 3>& corners) const
{
  return std::any_of(this->regions_.begin(), this->regions_.end(),
    [&corners](const LevelRegion& region)
    {
      return std::all_of(
        corners.begin(), corners.end(), [&region](Vec2 corner) { return region.contains(corner); });
    });
}

std::vector<LevelArrangement::Remainder> LevelArrangement::remaindersIn(
  const std::array<Vec2, 3>& corners)
{
  std::vector<Remainder> remainders;
  for (const LevelCurve& curve : this->curves_)
  {
    this->cut(curve, corners, remainders);
  }
  return remainders;
}

// Cuts a curve first to where it lies in the triangle, then by the regions that come near.
void LevelArrangement::cut(
  const LevelCurve& curve, const std::array<Vec2, 3>& corners, std::vector<Remainder>& remainders)
{
  this->atEdges_.clear();
  const PlaneBox box = boxAround(curve, 0.0, curve.extent, this->level_->gap);
  bool isWithin = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec2 begin = corners[k];
    const Vec2 edge = corners[(k + 1) % 3] - begin;
    const PlaneLine line = { begin, edge };
    if (line.mostAside(box) < 0.0)
    {
      return;
    }
    const double length = norm(edge);
    if (line.leastAside(box) < 0.0 && length > 0.0)
    {
      isWithin = false;
      addMeetings(curve, { begin, (1.0 / length) * edge }, this->atEdges_);
    }
  }
  std::sort(this->atEdges_.begin(), this->atEdges_.end());
  this->atEdges_.push_back(curve.extent);
  double begin = 0.0;
  for (const double end : this->atEdges_)
  {
    if (end > begin && (isWithin || isInside(corners, curve.at(0.5 * (begin + end)))))
    {
      this->cutByRegions(curve, begin, end, remainders);
    }
    begin = std::max(begin, end);
  }
}

void LevelArrangement::cutByRegions(
  const LevelCurve& curve, double first, double last, std::vector<Remainder>& remainders)
{
  const PlaneBox box = boxAround(curve, first, last, this->level_->gap);
  this->atRegions_.clear();
  this->near_.clear();
  for (std::size_t i = 0; i < this->regions_.size(); ++i)
  {
    const LevelRegion& region = this->regions_[i];
    if (i != curve.candidate && !region.misses(box))
    {
      this->near_.push_back(&region);
      region.addMeetings(curve, this->atRegions_);
    }
  }
  std::sort(this->atRegions_.begin(), this->atRegions_.end());
  this->atRegions_.push_back(last);
  this->job_.look();
  double begin = first;
  bool goesOn = false;
  for (const double parameter : this->atRegions_)
  {
    const double end = std::min(parameter, last);
    if (end > begin)
    {
      const bool isOutside = this->remains(curve.at(0.5 * (begin + end)));
      if (isOutside && goesOn)
      {
        remainders.back().end = end;
      }
      else if (isOutside)
      {
        remainders.push_back({ &curve, begin, end });
      }
      goesOn = isOutside;
      begin = end;
    }
  }
}

// Whether a point of a curve is outside the regions nearby. Between pencils that rounding has
// parted, a path that bends at the end of one of them may be shorter.
bool LevelArrangement::remains(Vec2 p) const
{
  return std::none_of(this->near_.begin(), this->near_.end(),
           [p](const LevelRegion* region) { return region->contains(p); }) &&
    this->level_->face.distance(p) >= this->level_->value - this->level_->slack;
}

}
