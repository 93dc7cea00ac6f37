// SPDX-License-Identifier: BSD-3-Clause
#include "contours/FaceIsolines.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

constexpr std::size_t None = static_cast<std::size_t>(-1);

// The largest angle of a chord, so that a circle looks like one.
constexpr double LargestStep = 3.14159265358979323846 / 6.0;

// How often a face may be cut in four. Smaller parts, of a millionth of its size, are crossed
// straight.
constexpr int MaximumDepth = 20;
// And into how many parts in all. Rounding decides at few points.
constexpr std::size_t MaximumParts = 4096;

// The angle of a chord within the tolerance. Points are at the value only up to a tie, so that no
// chord need be nearer to its arc.
double angleOfChord(double radius, double chordTolerance)
{
  const double sagitta = std::clamp(chordTolerance / radius, tolerance::Tie, 1.0);
  return std::min(LargestStep, 4.0 * std::asin(std::sqrt(0.5 * sagitta)));
}

// With some room for roundings.
PlaneBox boxAround(const std::array<Vec2, 3>& corners, double size)
{
  constexpr double room = 1e-3;
  const auto [lowX, highX] = std::minmax({ corners[0].x, corners[1].x, corners[2].x });
  const auto [lowY, highY] = std::minmax({ corners[0].y, corners[1].y, corners[2].y });
  return { { lowX - room * size, lowY - room * size },
    { highX + room * size, highY + room * size } };
}

/// Around a part of a curve.
PlaneBox boxAround(const LevelCurve& curve, double begin, double end, double room)
{
  const Vec2 a = curve.at(begin);
  const Vec2 b = curve.at(end);
  const double way = curve.wayBound(begin, end);
  // An arc is not farther from its chord than this, nor than its own length.
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

void addTo(
  std::vector<OutlinePoint>& outline, std::size_t edge, const std::vector<OutlinePoint>& points)
{
  for (OutlinePoint point : points)
  {
    point.edge = edge;
    outline.push_back(point);
  }
}

/// Adds the points that a neighbour has on its edge 1, as seen from the other side.
void addReversed(
  std::vector<OutlinePoint>& outline, std::size_t edge, const std::vector<OutlinePoint>& neighbour)
{
  for (auto point = neighbour.rbegin(); point != neighbour.rend(); ++point)
  {
    if (point->edge == 1)
    {
      outline.push_back({ point->at, point->id, edge, !point->leaves });
    }
  }
}

} // anonymous namespace

void FaceIsolines::draw(const FaceDistance& face, double level, Id valueId,
  const std::vector<OutlinePoint>& outline, bool below)
{
  Part whole;
  for (std::size_t k = 0; k < 3; ++k)
  {
    whole.corners[k] = face.inPlane(cornerWeights(k));
  }
  whole.outline = outline;
  whole.below = below;
  whole.depth = 0;
  this->face_ = &face;
  this->level_ = level;
  this->valueId_ = valueId;
  this->size_ = std::max({ norm(whole.corners[1] - whole.corners[0]),
    norm(whole.corners[2] - whole.corners[1]), norm(whole.corners[0] - whole.corners[2]) });
  this->parts_ = 1;
  this->slack_ = tolerance::IsolineValue * (this->level_ + this->size_);
  this->gap_ = tolerance::IsolineGap * std::min(this->size_, level);
  this->offsetScale_ = level + std::min(this->size_, tolerance::OffsetFaceInValues * level);
  this->places_.box = boxAround(whole.corners, this->size_);
  if (!this->drawWhole(whole))
  {
    this->drawPart(whole);
  }
}

// Draws the face in one part if that is possible. Paths that bend at a window's end only fill gaps
// that rounding leaves between pencils: they are tried last. So is a larger offset between curves,
// which orders curves that nearly coincide.
bool FaceIsolines::drawWhole(const Part& whole)
{
  for (const bool withBent : { false, true })
  {
    for (const double offset : { tolerance::CurveOffset, tolerance::LargerCurveOffset })
    {
      this->findRegions(withBent, offset);
      if (this->drawAtOnce(whole))
      {
        return true;
      }
    }
  }
  return false;
}

// Makes the regions of the candidates, each for a slightly different value
// (tolerance::CurveOffset).
void FaceIsolines::findRegions(bool withBent, double offset)
{
  const std::vector<DistanceCandidate>& candidates = this->face_->candidates();
  this->regions_.clear();
  this->curves_.clear();
  this->bent_.clear();
  for (const DistanceCandidate& c : candidates)
  {
    this->addRegion(c, offset);
    if (withBent && c.hasPencil())
    {
      using Kind = DistanceCandidate::Kind;
      this->bent_.push_back({ Kind::Cone, c.atBegin, c.begin, {}, {}, 0.0, 0.0 });
      this->bent_.push_back({ Kind::Cone, c.atEnd, c.end, {}, {}, 0.0, 0.0 });
    }
  }
  for (const DistanceCandidate& c : this->bent_)
  {
    this->addRegion(c, offset);
  }
}

void FaceIsolines::addRegion(const DistanceCandidate& candidate, double offset)
{
  const std::size_t number = this->regions_.size();
  const LevelRegion region(candidate, number,
    this->level_ - static_cast<double>(number) * offset * this->offsetScale_,
    tolerance::PencilMargin * this->size_, this->places_.box);
  if (!region.isEmpty())
  {
    region.addCurves(this->places_.box, this->curves_);
    this->regions_.push_back(region);
  }
}

// Whether the part lies in one region, which is convex.
bool FaceIsolines::isBelowThroughout(const Part& part) const
{
  return std::any_of(this->regions_.begin(), this->regions_.end(),
    [&part](const LevelRegion& region)
    {
      return std::all_of(part.corners.begin(), part.corners.end(),
        [&region](Vec2 corner) { return region.contains(corner); });
    });
}

// Draws the part without cutting it. Returns whether that was possible.
bool FaceIsolines::drawAtOnce(const Part& part)
{
  if (part.outline.empty() && part.below && this->isBelowThroughout(part))
  {
    return true;
  }
  this->findRemainders(part);
  if (!this->joinEnds(part))
  {
    return false;
  }
  this->addLines(part);
  return true;
}

void FaceIsolines::drawPart(const Part& part)
{
  if (this->drawAtOnce(part))
  {
    return;
  }
  if (part.depth == MaximumDepth || this->parts_ >= MaximumParts)
  {
    this->crossStraight(part);
  }
  else
  {
    this->split(part);
  }
}

void FaceIsolines::findRemainders(const Part& part)
{
  this->remainders_.clear();
  for (std::size_t i = 0; i < this->curves_.size(); ++i)
  {
    this->cutCurve(i, part);
  }
}

// Cuts a curve first to where it lies in the part, then by the regions that come near.
void FaceIsolines::cutCurve(std::size_t index, const Part& part)
{
  const LevelCurve& curve = this->curves_[index];
  this->places_.at.clear();
  const std::array<Vec2, 4> box = boxAround(curve, 0.0, curve.extent, this->gap_).corners();
  bool isWithin = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec2 begin = part.corners[k];
    const Vec2 edge = part.corners[(k + 1) % 3] - begin;
    const auto outside =
      std::count_if(box.begin(), box.end(), [&](Vec2 p) { return cross(edge, p - begin) < 0.0; });
    if (outside == 4)
    {
      return;
    }
    const double length = norm(edge);
    if (outside > 0 && length > 0.0)
    {
      isWithin = false;
      addMeetings(curve, { begin, (1.0 / length) * edge }, this->places_);
    }
  }
  std::sort(this->places_.at.begin(), this->places_.at.end());
  this->places_.at.push_back(curve.extent);
  double begin = 0.0;
  for (const double end : this->places_.at)
  {
    if (end > begin && (isWithin || isInside(part.corners, curve.at(0.5 * (begin + end)))))
    {
      this->cutCurveBetween(index, begin, end);
    }
    begin = std::max(begin, end);
  }
}

void FaceIsolines::cutCurveBetween(std::size_t index, double first, double last)
{
  const LevelCurve& curve = this->curves_[index];
  CurvePlaces& places = this->innerPlaces_;
  places.at.clear();
  places.box = boxAround(curve, first, last, this->gap_);
  this->near_.clear();
  for (std::size_t i = 0; i < this->regions_.size(); ++i)
  {
    if (i != curve.candidate && !this->regions_[i].misses(places.box))
    {
      this->near_.push_back(i);
      this->regions_[i].addMeetings(curve, places);
    }
  }
  std::sort(places.at.begin(), places.at.end());
  places.at.push_back(last);
  this->work(this->regions_.size() + places.at.size() * this->near_.size());
  double begin = first;
  bool goesOn = false;
  for (const double place : places.at)
  {
    const double end = std::min(place, last);
    if (end > begin)
    {
      const bool remains = this->remains(curve.at(0.5 * (begin + end)));
      if (remains && goesOn)
      {
        this->remainders_.back().end = end;
      }
      else if (remains)
      {
        this->remainders_.push_back({ index, begin, end });
      }
      goesOn = remains;
      begin = end;
    }
  }
}

// Whether a point of a curve is outside the regions nearby. Between pencils that rounding has
// parted, a path that bends at the end of one of them may be shorter.
bool FaceIsolines::remains(Vec2 p) const
{
  return std::none_of(this->near_.begin(), this->near_.end(),
           [&](std::size_t i) { return this->regions_[i].contains(p); }) &&
    this->face_->distance(p) >= this->level_ - this->slack_;
}

// Joins ends of lines, the nearest ones first. Returns whether every line can continue.
bool FaceIsolines::joinEnds(const Part& part)
{
  this->from_.clear();
  this->to_.clear();
  for (std::size_t i = 0; i < this->remainders_.size(); ++i)
  {
    const Remainder& r = this->remainders_[i];
    this->from_.push_back({ this->curves_[r.curve].at(r.end), i });
    this->to_.push_back({ this->curves_[r.curve].at(r.begin), i });
  }
  const std::size_t owners = this->remainders_.size() + part.outline.size();
  for (std::size_t i = 0; i < part.outline.size(); ++i)
  {
    (part.outline[i].leaves ? this->to_ : this->from_)
      .push_back({ part.outline[i].at, this->remainders_.size() + i });
  }
  this->next_.assign(owners, None);
  if (this->from_.size() != this->to_.size())
  {
    return false;
  }
  this->used_.assign(this->to_.size(), 0);
  return this->joinEndsWithin(this->gap_) || this->joinEndsWithin(Infinity);
}

// Joins loose ends that are no farther apart. Returns whether every line can continue.
bool FaceIsolines::joinEndsWithin(double largestGap)
{
  this->pairs_.clear();
  for (std::size_t i = 0; i < this->from_.size(); ++i)
  {
    this->work(this->to_.size());
    for (std::size_t j = 0; j < this->to_.size(); ++j)
    {
      const double gap = norm(this->to_[j].at - this->from_[i].at);
      const bool isLoose = this->next_[this->from_[i].owner] == None && !this->used_[j];
      if (isLoose && gap <= largestGap)
      {
        this->pairs_.push_back({ gap, i, j });
      }
    }
  }
  std::stable_sort(this->pairs_.begin(), this->pairs_.end(),
    [](const Pair& a, const Pair& b) { return a.gap < b.gap; });
  bool allMeet = true;
  for (const Pair& pair : this->pairs_)
  {
    const LooseEnd& from = this->from_[pair.from];
    const LooseEnd& to = this->to_[pair.to];
    if (this->next_[from.owner] == None && !this->used_[pair.to])
    {
      allMeet = allMeet && this->isJoint(from.at, to.at);
      this->next_[from.owner] = to.owner;
      this->used_[pair.to] = 1;
    }
  }
  return allMeet &&
    std::all_of(
      this->used_.begin(), this->used_.end(), [](std::uint8_t used) { return used != 0; });
}

// Whether a line may go straight from one end to another.
bool FaceIsolines::isJoint(Vec2 a, Vec2 b) const
{
  if (norm(b - a) <= this->gap_)
  {
    return true;
  }
  for (const double t : { 0.25, 0.5, 0.75 })
  {
    if (!(std::abs(this->face_->distance(a + t * (b - a)) - this->level_) <= this->slack_))
    {
      return false;
    }
  }
  return true;
}

// Adds first the lines that cross the part, then the closed ones that are left.
void FaceIsolines::addLines(const Part& part)
{
  const std::size_t remainders = this->remainders_.size();
  this->used_.assign(remainders + part.outline.size(), 0);
  for (std::size_t i = 0; i < part.outline.size(); ++i)
  {
    if (!part.outline[i].leaves)
    {
      this->line_ = { { part.outline[i].at, part.outline[i].id } };
      this->followFrom(remainders + i, part);
      this->addLine(false);
    }
  }
  for (std::size_t i = 0; i < remainders; ++i)
  {
    if (!this->used_[i])
    {
      const Remainder& last = this->remainders_[i];
      this->line_ = { { this->curves_[last.curve].at(last.end) } };
      this->followFrom(i, part);
      if (this->line_.size() > 3) // others are scraps between two places that rounding tells apart
      {
        this->addLine(true);
      }
    }
  }
}

// Follows a line from the end of the owner to an exit, or to the end of the owner again. Each owner
// follows at most one other, and none follows an entry, so that no other loop is possible.
void FaceIsolines::followFrom(std::size_t owner, const Part& part)
{
  const std::size_t remainders = this->remainders_.size();
  std::size_t at = this->next_[owner];
  while (at < remainders)
  {
    this->used_[at] = 1;
    this->followRemainder(this->remainders_[at]);
    if (at == owner)
    {
      return;
    }
    at = this->next_[at];
  }
  if (this->line_.size() > 1)
  {
    this->line_.pop_back(); // the exit stands for it
  }
  this->line_.push_back({ part.outline[at - remainders].at, part.outline[at - remainders].id });
}

// Adds the points of a remainder to its end. No chord is farther from an arc than the tolerance.
void FaceIsolines::followRemainder(const Remainder& remainder)
{
  const LevelCurve& curve = this->curves_[remainder.curve];
  if (curve.isArc)
  {
    const double first = 2.0 * std::atan(remainder.begin);
    const double angle = 2.0 * std::atan(remainder.end) - first;
    const double chords =
      std::max(1.0, std::ceil(angle / angleOfChord(curve.radius, this->chordTolerance_)));
    const double sine = std::sin(0.25 * angle / chords);
    const double sagitta = 2.0 * curve.radius * sine * sine;
    this->line_.back().sagitta = sagitta;
    const auto count = static_cast<std::size_t>(chords);
    for (std::size_t i = 1; i < count; ++i)
    {
      const double place = std::tan(0.5 * (first + static_cast<double>(i) / chords * angle));
      this->line_.push_back({ curve.at(place), NoId, sagitta });
    }
  }
  this->line_.push_back({ curve.at(remainder.end) });
}

// Adds the line at hand without the points that the chord tolerance does not need.
void FaceIsolines::addLine(bool isClosed)
{
  std::vector<Id>& ids = this->result_.ids;
  const std::size_t begin = ids.size();
  const std::size_t last = this->line_.size() - 1;
  const auto idOf = [this](std::size_t i)
  {
    const LinePoint& p = this->line_[i];
    return p.id == NoId ? this->addPoint(p.at) : p.id;
  };
  ids.push_back(idOf(0));
  for (std::size_t at = 0; at < last;)
  {
    // A closed line has three corners at least.
    const std::size_t third = at < last / 3 ? last / 3 : at < 2 * last / 3 ? 2 * last / 3 : last;
    const std::size_t next = std::min(this->chordFrom(at), isClosed ? third : last);
    ids.push_back(isClosed && next == last ? ids[begin] : idOf(next));
    at = next;
  }
  this->closePiece();
}

// The end of the longest chord from a point that is near enough to all of the line below it.
std::size_t FaceIsolines::chordFrom(std::size_t first) const
{
  const auto isNear = [&](std::size_t end)
  {
    const Vec2 chord = this->line_[end].at - this->line_[first].at;
    const double squared = dot(chord, chord);
    for (std::size_t i = first + 1; i < end; ++i)
    {
      const Vec2 p = this->line_[i].at - this->line_[first].at;
      const double t = squared > 0.0 ? std::clamp(dot(p, chord) / squared, 0.0, 1.0) : 0.0;
      const double sagitta = std::max(this->line_[i - 1].sagitta, this->line_[i].sagitta);
      if (!(norm(p - t * chord) + sagitta <= this->chordTolerance_))
      {
        return false;
      }
    }
    return true;
  };
  std::size_t end = first + 1;
  while (end + 1 < this->line_.size() && isNear(end + 1))
  {
    ++end;
  }
  return end;
}

void FaceIsolines::closePiece()
{
  this->result_.pieces.push_back({ this->face_->face(), this->valueId_, this->result_.ids.size() });
}

Id FaceIsolines::addPoint(Vec2 p)
{
  this->result_.points.push_back({ this->face_->face(), this->face_->fromPlane(p) });
  return this->firstNewId_ + static_cast<Id>(this->result_.points.size() - 1);
}

// Cuts a part in four, which share points on the segments between them.
void FaceIsolines::split(const Part& part)
{
  std::array<Vec2, 3> middles;
  std::array<std::uint8_t, 3> cornerBelow{};
  std::array<std::uint8_t, 3> middleBelow{};
  /// Of each edge, before and behind its middle.
  std::array<std::array<std::vector<OutlinePoint>, 2>, 3> halves;
  bool below = part.below;
  auto point = part.outline.begin();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec2 edge = part.corners[(k + 1) % 3] - part.corners[k];
    middles[k] = part.corners[k] + 0.5 * edge;
    cornerBelow[k] = below;
    middleBelow[k] = below;
    for (; point != part.outline.end() && point->edge == k; ++point)
    {
      const bool isBefore = dot(point->at - middles[k], edge) < 0.0 && halves[k][1].empty();
      below = !point->leaves;
      middleBelow[k] = isBefore ? below : middleBelow[k];
      halves[k][isBefore ? 0 : 1].push_back(*point);
    }
  }
  std::array<Part, 4> parts;
  this->parts_ += parts.size();
  Part& center = parts[3];
  center = { middles, {}, middleBelow[0] != 0, part.depth + 1 };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t before = (k + 2) % 3;
    Part& corner = parts[k];
    corner = { { part.corners[k], middles[k], middles[before] }, {}, cornerBelow[k] != 0,
      part.depth + 1 };
    addTo(corner.outline, 0, halves[k][0]);
    addTo(corner.outline, 1,
      this->pointsBetween(
        middles[k], middles[before], middleBelow[k] != 0, middleBelow[before] != 0));
    addTo(corner.outline, 2, halves[before][1]);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    addReversed(center.outline, k, parts[(k + 1) % 3].outline);
  }
  for (const Part& each : parts)
  {
    this->drawPart(each);
  }
}

std::vector<OutlinePoint> FaceIsolines::pointsBetween(Vec2 a, Vec2 b, bool aIsBelow, bool bIsBelow)
{
  this->crossings_.clear();
  findCrossings(
    this->envelope_.along(*this->face_, a, b), this->level_, aIsBelow, bIsBelow, this->crossings_);
  const double length = norm(b - a);
  std::vector<OutlinePoint> points;
  for (const SegmentCrossing& crossing : this->crossings_)
  {
    const Vec2 at = length > 0.0 ? a + (crossing.at / length) * (b - a) : a;
    points.push_back({ at, this->addPoint(at), 1, crossing.rises });
  }
  return points;
}

// Counts steps of work, and asks now and then whether to stop.
void FaceIsolines::work(std::size_t steps)
{
  constexpr std::size_t stepsPerLook = 1U << 14;
  this->stepsSinceLook_ += steps;
  if (this->stepsSinceLook_ >= stepsPerLook)
  {
    this->stepsSinceLook_ = 0;
    reportProgress(this->progress_, 0.0);
  }
}

// Joins each entry to the exit beside it, so that no two lines cross.
void FaceIsolines::crossStraight(const Part& part)
{
  ++this->partsCrossedStraight_;
  const std::size_t count = part.outline.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!part.outline[i].leaves)
    {
      this->result_.ids.push_back(part.outline[i].id);
      this->result_.ids.push_back(part.outline[(i + 1) % count].id);
      this->closePiece();
    }
  }
}

}
