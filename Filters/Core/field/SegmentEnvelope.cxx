// SPDX-License-Identifier: BSD-3-Clause
#include "field/SegmentEnvelope.h"

#include "Tolerance.h"
#include "window/Interval.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

double jointSlack(double length, double distance)
{
  return tolerance::JointFraction * length + tolerance::FaceRounding * distance;
}

/// A segment in the plane of a face, from p along the unit vector u.
struct PlaneSegment
{
  Vec2 p;
  Vec2 u;
  double length;
};

/// The pieces of candidates along a segment, which the functions below append.
using Pieces = std::vector<Window>;

/// \param atP the distance at the segment's begin.
void addLinear(
  Pieces& pieces, Vec2 rays, double atP, const PlaneSegment& segment, const Interval& x)
{
  if (!x.isEmpty())
  {
    pieces.push_back({ x.begin, x.end, dot(rays, segment.u), std::abs(cross(rays, segment.u)), atP,
      0.0, Window::Kind::Linear, 0 });
  }
}

void addCone(
  Pieces& pieces, Vec2 apex, double sigma, const PlaneSegment& segment, const Interval& x)
{
  if (!x.isEmpty())
  {
    const Vec2 toApex = apex - segment.p;
    pieces.push_back({ x.begin, x.end, dot(toApex, segment.u), std::abs(cross(toApex, segment.u)),
      sigma, 0.0, Window::Kind::Circular, 0 });
  }
}

/// Parallel rays to both sides of the source, and its two ends.
void addSource(Pieces& pieces, const DistanceCandidate& c, const PlaneSegment& segment)
{
  const auto& [p, u, length] = segment;
  addCone(pieces, c.begin, 0.0, segment, { 0.0, length });
  addCone(pieces, c.end, 0.0, segment, { 0.0, length });
  const double sourceLength = norm(c.end - c.begin);
  if (!(sourceLength > 0.0))
  {
    return;
  }
  const Vec2 t = (1.0 / sourceLength) * (c.end - c.begin);
  const double along = dot(p - c.begin, t);
  const double alongSlope = dot(u, t);
  Interval strip{ 0.0, length };
  strip.clip(along, alongSlope);
  strip.clip(sourceLength - along, -alongSlope);
  strip.widen(tolerance::PencilMargin * length, length);
  for (const Vec2 aside : { Vec2{ -t.y, t.x }, Vec2{ t.y, -t.x } })
  {
    const double height = dot(aside, p - c.begin);
    Interval oneSide = strip;
    oneSide.clip(height, dot(aside, u));
    addLinear(pieces, aside, height, segment, oneSide);
  }
}

/// Between the rays through the window's ends paths are straight, beyond these rays they bend at
/// the ends.
void addPencil(
  Pieces& pieces, const DistanceCandidate& c, const PlaneSegment& segment, bool withBent)
{
  const auto& [p, u, length] = segment;
  const Vec2 first = c.rayAtBegin();
  const Vec2 last = c.rayAtEnd();
  const double leftOfBegin = cross(first, p - c.begin);
  const double leftOfBeginSlope = cross(first, u);
  const double leftOfEnd = cross(last, p - c.end);
  const double leftOfEndSlope = cross(last, u);
  const double margin = tolerance::PencilMargin * length;
  Interval straight{ 0.0, length };
  straight.clip(-leftOfBegin, -leftOfBeginSlope);
  straight.clip(leftOfEnd, leftOfEndSlope);
  straight.widen(margin, length);
  if (c.kind == DistanceCandidate::Kind::Linear)
  {
    addLinear(pieces, c.source, c.sigma + dot(c.source, p), segment, straight);
  }
  else
  {
    addCone(pieces, c.source, c.sigma, segment, straight);
  }
  if (withBent)
  {
    Interval before{ 0.0, length };
    before.clip(leftOfBegin, leftOfBeginSlope);
    before.widen(margin, length);
    addCone(pieces, c.begin, c.atBegin, segment, before);
    Interval behind{ 0.0, length };
    behind.clip(-leftOfEnd, -leftOfEndSlope);
    behind.widen(margin, length);
    addCone(pieces, c.end, c.atEnd, segment, behind);
  }
}

void addPieces(
  Pieces& pieces, const DistanceCandidate& c, const PlaneSegment& segment, bool withBent)
{
  switch (c.kind)
  {
    case DistanceCandidate::Kind::Cone:
      addCone(pieces, c.source, c.sigma, segment, { 0.0, segment.length });
      break;
    case DistanceCandidate::Kind::Segment:
      addSource(pieces, c, segment);
      break;
    case DistanceCandidate::Kind::Circular:
    case DistanceCandidate::Kind::Linear:
      addPencil(pieces, c, segment, withBent);
      break;
  }
}

// Whether an envelope agrees with the distance at x. If a segment runs along the ray at the end of
// a pencil, rounding may lose the pencil. Then the envelope is above the distance; it is below if
// only a scrap of a neighbour was found, at an end of the segment.
bool agrees(const std::vector<Window>& envelope, double x, double distance)
{
  const auto window =
    std::find_if(envelope.begin(), envelope.end() - 1, [x](const Window& w) { return x <= w.end; });
  return std::abs(window->distance(x) - distance) <= jointSlack(envelope.back().end, distance);
}

// Closes the gaps between windows. Returns whether neighbours are equal where they meet.
bool joinNeighbours(std::vector<Window>& envelope, double length)
{
  bool continuous = true;
  envelope.front().begin = 0.0;
  envelope.back().end = length;
  for (std::size_t i = 1; i < envelope.size(); ++i)
  {
    Window& left = envelope[i - 1];
    left.end = envelope[i].begin;
    const double value = envelope[i].distance(left.end);
    continuous =
      continuous && std::abs(left.distance(left.end) - value) <= jointSlack(length, value);
  }
  return continuous;
}

/// The two places where a window has a value, in their order; one of a linear window is infinite.
/// If a window has the value nowhere, the place where it is least.
std::pair<double, double> placesOf(const Window& w, double value)
{
  if (w.isLinear())
  {
    if (w.sourceX == 0.0)
    {
      return { -Infinity, Infinity };
    }
    const double at = (value - w.sigma) / w.sourceX;
    return w.sourceX > 0.0 ? std::make_pair(-Infinity, at) : std::make_pair(at, Infinity);
  }
  const double radius = value - w.sigma;
  const double squared = (radius - w.sourceDepth) * (radius + w.sourceDepth);
  const double half = radius > 0.0 && squared > 0.0 ? std::sqrt(squared) : 0.0;
  return { w.sourceX - half, w.sourceX + half };
}

/// Whether a window dips below the value between its ends, which do not.
bool dipsBelow(const Window& w, double value)
{
  return !w.isLinear() && w.begin < w.sourceX && w.sourceX < w.end &&
    w.sigma + w.sourceDepth < value;
}

// Finds the crossings on an envelope, which may be empty where the segment has hardly any length.
// Windows are convex functions: below a value on an interval, if at all.
void findCrossings(const std::vector<Window>& envelope, double value, bool beginsBelow,
  bool endsBelow, std::vector<SegmentCrossing>& result)
{
  if (envelope.empty() && beginsBelow != endsBelow)
  {
    result.push_back({ 0.0, beginsBelow });
  }
  // Where the distance equals the value all along, its rounding must not make crossings.
  const double clearly =
    envelope.empty() ? value : value - tolerance::Evaluation * (value + envelope.back().end);
  bool below = beginsBelow;
  for (std::size_t i = 0; i < envelope.size(); ++i)
  {
    const Window& w = envelope[i];
    const bool belowNext =
      i + 1 < envelope.size() ? w.distance(w.end) < (below ? value : clearly) : endsBelow;
    const auto [before, behind] = placesOf(w, value);
    const bool dips = !below && !belowNext && dipsBelow(w, clearly);
    if ((!below && belowNext) || dips)
    {
      result.push_back({ std::clamp(before, w.begin, w.end), false });
    }
    if ((below && !belowNext) || dips)
    {
      result.push_back({ std::clamp(behind, w.begin, w.end), true });
    }
    below = belowNext;
  }
}

} // anonymous namespace

// In the exact field bent paths only fill gaps of rounding; merged windows may need them.
const std::vector<Window>& SegmentEnvelope::along(const FaceDistance& face, Vec2 p, Vec2 q)
{
  const double length = norm(q - p);
  this->envelope_.clear();
  if (!(length > 0.0))
  {
    return this->envelope_;
  }
  const double inMiddle = this->near_.choose(face, 0.5 * (p + q), 0.5 * length);
  const Vec2 u = (1.0 / length) * (q - p);
  const bool done = face.isExact() && this->build(p, u, length, false) &&
    agrees(this->envelope_, 0.5 * length, inMiddle) &&
    agrees(this->envelope_, 0.0, this->near_.distance(p)) &&
    agrees(this->envelope_, length, this->near_.distance(q));
  if (!done)
  {
    this->build(p, u, length, true);
  }
  return this->envelope_;
}

double SegmentEnvelope::least(const FaceDistance& face, Vec2 p, Vec2 q, double value)
{
  const double length = norm(q - p);
  double least = this->near_.choose(face, 0.5 * (p + q), 0.5 * length, value);
  if (length > 0.0)
  {
    this->cutNear(p, (1.0 / length) * (q - p), length, !face.isExact());
    for (const Window& piece : this->pieces_)
    {
      least = std::min(least, piece.minimum());
    }
  }
  return std::max(least, 0.0);
}

void SegmentEnvelope::cutNear(Vec2 p, Vec2 u, double length, bool withBent)
{
  this->pieces_.clear();
  for (const DistanceCandidate* c : this->near_)
  {
    addPieces(this->pieces_, *c, { p, u, length }, withBent);
  }
}

// Among slivers thousands of pieces may cover the segment, each of which the builder compares with
// all that are there. The envelopes of both halves, whose pieces do not overlap, take far less.
void SegmentEnvelope::buildFrom(std::size_t first, std::size_t last, double length)
{
  constexpr std::size_t Many = 512;
  if (last - first > Many)
  {
    const std::size_t middle = first + (last - first) / 2;
    this->buildFrom(first, middle, length);
    const std::vector<Window> ofFirst = this->builder_.windows();
    this->buildFrom(middle, last, length);
    const std::vector<Window> ofSecond = this->builder_.windows();
    this->builder_.reset(length);
    this->builder_.appendLists({ ofFirst.data(), ofFirst.data() + ofFirst.size() },
      { ofSecond.data(), ofSecond.data() + ofSecond.size() });
    return;
  }
  this->builder_.reset(length);
  for (std::size_t i = first; i < last; ++i)
  {
    this->builder_.append(this->pieces_[i]);
  }
}

// Returns whether neighbours are equal where they meet. A piece that fills a gap of rounding may be
// far above the distance: its neighbours replace it.
bool SegmentEnvelope::build(Vec2 p, Vec2 u, double length, bool withBent)
{
  this->cutNear(p, u, length, withBent);
  // Of pieces that begin in one place, the order decides about rounding: it is not left to the
  // library.
  const auto rest = [](const Window& w)
  { return std::tie(w.end, w.sourceX, w.sourceDepth, w.sigma); };
  std::sort(this->pieces_.begin(), this->pieces_.end(),
    [&rest](const Window& a, const Window& b)
    { return a.begin != b.begin ? a.begin < b.begin : rest(a) < rest(b); });
  this->buildFrom(0, this->pieces_.size(), length);
  this->envelope_.clear();
  std::copy_if(this->builder_.windows().begin(), this->builder_.windows().end(),
    std::back_inserter(this->envelope_),
    [length](const Window& w) { return w.width() > tolerance::PencilMargin * length; });
  return !this->envelope_.empty() && joinNeighbours(this->envelope_, length);
}

// The distance is below the value in the union of the intervals where the candidates are (paper,
// equation 1 and section 4.2.2, solved for the place). The envelope, which costs more, is needed
// only where rounding decides.
void SegmentEnvelope::findCrossings(const FaceDistance& face, Vec2 p, Vec2 q, double value,
  bool beginsBelow, bool endsBelow, std::vector<SegmentCrossing>& result)
{
  const double length = norm(q - p);
  if (length > 0.0 && face.isExact())
  {
    const double inMiddle = this->near_.choose(face, 0.5 * (p + q), 0.5 * length, value);
    this->cutNear(p, (1.0 / length) * (q - p), length, false);
    if (this->findSublevels(length, value) && this->isBelow(0.0) == beginsBelow &&
      this->isBelow(length) == endsBelow && this->isBelow(0.5 * length) == (inMiddle < value))
    {
      for (const Sublevel& below : this->sublevels_)
      {
        if (below.begin > 0.0)
        {
          result.push_back({ below.begin, false });
        }
        if (below.end < length)
        {
          result.push_back({ below.end, true });
        }
      }
      return;
    }
  }
  geodesic::findCrossings(this->along(face, p, q), value, beginsBelow, endsBelow, result);
}

bool SegmentEnvelope::isBelow(double x) const
{
  return std::any_of(this->sublevels_.begin(), this->sublevels_.end(),
    [x](const Sublevel& below) { return below.begin <= x && x <= below.end; });
}

// Finds the union of the intervals where the pieces are below the value. Returns whether it is
// certain: no piece hardly dips below, and the union ends only where the distance is the value, not
// where rounding has parted two pencils.
bool SegmentEnvelope::findSublevels(double length, double value)
{
  const double slack = tolerance::Evaluation * (value + length);
  this->inPieces_.clear();
  for (const Window& w : this->pieces_)
  {
    const double least = w.minimum();
    if (std::abs(least - value) <= slack)
    {
      return false;
    }
    if (least < value)
    {
      const auto [before, behind] = placesOf(w, value);
      this->inPieces_.push_back({ std::max(before, w.begin), std::min(behind, w.end),
        before > w.begin || w.begin == 0.0, behind < w.end || w.end == length });
    }
  }
  const auto key = [](const Sublevel& s)
  { return std::tie(s.begin, s.beginsAtValue, s.end, s.endsAtValue); };
  std::sort(this->inPieces_.begin(), this->inPieces_.end(),
    [&key](const Sublevel& a, const Sublevel& b) { return key(a) < key(b); });
  this->sublevels_.clear();
  for (const Sublevel& below : this->inPieces_)
  {
    if (this->sublevels_.empty() || below.begin > this->sublevels_.back().end)
    {
      this->sublevels_.push_back(below);
    }
    else if (below.end > this->sublevels_.back().end)
    {
      this->sublevels_.back().end = below.end;
      this->sublevels_.back().endsAtValue = below.endsAtValue;
    }
  }
  return std::all_of(this->sublevels_.begin(), this->sublevels_.end(),
    [](const Sublevel& below) { return below.beginsAtValue && below.endsAtValue; });
}

}
