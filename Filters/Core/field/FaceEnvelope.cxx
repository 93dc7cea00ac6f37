// SPDX-License-Identifier: BSD-3-Clause
#include "field/FaceEnvelope.h"

#include "Errors.h"
#include "Tolerance.h"
#include "window/Interval.h"

#include <algorithm>
#include <iterator>

namespace geodesic
{

namespace
{

/// Whether a window's rays run along its halfedge. Such a pencil has no inside, and points of the
/// halfedge before it and behind it would be told apart by rounding alone.
bool isGrazing(const Window& w)
{
  if (w.isLinear())
  {
    return w.sourceDepth <= tolerance::GrazingAngle;
  }
  const double before = std::max(w.begin - w.sourceX, w.sourceX - w.end);
  return before > 0.0 && w.sourceDepth <= tolerance::GrazingAngle * before;
}

double jointSlack(double length, double distance)
{
  return tolerance::JointFraction * length + tolerance::FaceRounding * distance;
}

double squaredNorm(Vec2 v)
{
  return dot(v, v);
}

Vec2 nearestOnSegment(Vec2 a, Vec2 b, Vec2 p)
{
  const Vec2 ab = b - a;
  const double squared = squaredNorm(ab);
  const double t = squared > 0.0 ? std::clamp(dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
  return a + t * ab;
}

} // anonymous namespace

double DistanceCandidate::distance(Vec2 p) const
{
  if (this->kind == Kind::Cone)
  {
    return this->sigma + norm(p - this->source);
  }
  if (this->kind == Kind::Segment)
  {
    return norm(p - nearestOnSegment(this->begin, this->end, p));
  }
  const bool linear = this->kind == Kind::Linear;
  const Vec2 fromBegin = p - this->begin;
  if (cross(linear ? this->source : this->begin - this->source, fromBegin) > 0.0)
  {
    return this->atBegin + norm(fromBegin);
  }
  const Vec2 fromEnd = p - this->end;
  if (cross(linear ? this->source : this->end - this->source, fromEnd) < 0.0)
  {
    return this->atEnd + norm(fromEnd);
  }
  return this->sigma + (linear ? dot(this->source, p) : norm(p - this->source));
}

Deviation largestDeviation(
  const std::vector<Window>& envelope, double length, double atBegin, double atEnd)
{
  Deviation deviation;
  if (!(length > 0.0))
  {
    return deviation;
  }
  const double a = (atEnd - atBegin) / length;
  const double slope = (1.0 - a) * (1.0 + a); // of the ray that a x is the distance of, squared
  const double shift = slope > 0.0 ? a / std::sqrt(slope) : 0.0;
  const auto look = [&](const Window& w, double x)
  {
    const double e = w.distance(x) - (atBegin + a * x);
    if (e > deviation.above)
    {
      deviation.above = e;
      deviation.aboveAt = x / length;
    }
    if (-e > deviation.below)
    {
      deviation.below = -e;
      deviation.belowAt = x / length;
    }
  };
  for (const Window& w : envelope)
  {
    look(w, w.begin);
    look(w, w.end);
    const double x = w.sourceX + shift * w.sourceDepth;
    if (!w.isLinear() && slope > 0.0 && x > w.begin && x < w.end)
    {
      look(w, x);
    }
  }
  return deviation;
}

double splitPosition(double t)
{
  if (t < 0.125)
  {
    return 0.25;
  }
  if (t < 0.25)
  {
    return 2.0 * t;
  }
  if (t <= 0.75)
  {
    return t;
  }
  return t < 0.875 ? 2.0 * t - 1.0 : 0.75;
}

FaceEnvelope::FaceEnvelope(const DistanceField& field)
  : field_(field)
  , mesh_(field.mesh())
  , exact_(field.relativeErrorBound() == 0.0)
{
  if (!field.hasWindows())
  {
    throw Error("The distance inside faces was asked for, but the solve kept no windows.");
  }
}

Vec2 FaceEnvelope::inPlane(const std::array<double, 3>& b) const
{
  return inHalfedgeFrame(this->mesh_, this->frame_, b);
}

void FaceEnvelope::enter(Id face)
{
  if (face == this->face_)
  {
    return;
  }
  this->face_ = face;
  this->frame_ = 3 * face + static_cast<Id>(this->mesh_.shape(face).longestEdge());
  this->candidates_.clear();
  for (Id k = 0; k < 3; ++k)
  {
    this->addHalfedge(3 * face + k);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    std::array<double, 3> corner{};
    corner[k] = 1.0;
    const double sigma = this->field_.vertexDistances()[this->mesh_.triangle(face)[k]];
    this->candidates_.push_back(
      { DistanceCandidate::Kind::Cone, sigma, this->inPlane(corner), {}, {}, 0.0, 0.0 });
  }
  for (const SourceInFace& source : this->field_.sourcesIn(face))
  {
    this->addSource(source);
  }
}

void FaceEnvelope::addHalfedge(Id halfedge)
{
  const WindowRuns windows = this->field_.windowsOn(halfedge);
  const double length = this->mesh_.length(halfedge);
  if (windows.empty() || !(length > 0.0))
  {
    return;
  }
  std::array<double, 3> corner{};
  corner[halfedge % 3] = 1.0;
  const Vec2 origin = this->inPlane(corner);
  corner = {};
  corner[(halfedge + 1 - 3 * this->face_) % 3] = 1.0;
  const Vec2 along = (1.0 / length) * (this->inPlane(corner) - origin);
  const Vec2 into = { -along.y, along.x };
  for (const Window& w : windows)
  {
    DistanceCandidate c;
    c.begin = origin + w.begin * along;
    c.end = origin + w.end * along;
    c.atBegin = std::max(w.distance(w.begin), 0.0);
    c.atEnd = std::max(w.distance(w.end), 0.0);
    if (isGrazing(w))
    {
      c.kind = DistanceCandidate::Kind::Cone; // with the same values on the halfedge
      c.source = c.atBegin < c.atEnd ? c.begin : c.end;
      c.sigma = std::min(c.atBegin, c.atEnd);
    }
    else if (w.isLinear())
    {
      c.kind = DistanceCandidate::Kind::Linear;
      c.source = w.sourceX * along + w.sourceDepth * into;
      c.sigma = w.sigma - dot(c.source, origin);
    }
    else
    {
      c.kind = DistanceCandidate::Kind::Circular;
      c.source = origin + w.sourceX * along - w.sourceDepth * into;
      c.sigma = w.sigma;
    }
    this->candidates_.push_back(c);
  }
}

void FaceEnvelope::addSource(const SourceInFace& source)
{
  const Vec2 a = this->inPlane(source.a);
  const Vec2 b = this->inPlane(source.b);
  if (source.a == source.b)
  {
    this->candidates_.push_back({ DistanceCandidate::Kind::Cone, 0.0, a, a, a, 0.0, 0.0 });
    return;
  }
  this->candidates_.push_back({ DistanceCandidate::Kind::Segment, 0.0, {}, a, b, 0.0, 0.0 });
}

double FaceEnvelope::distance(Vec2 p) const
{
  double least = Infinity;
  for (const DistanceCandidate& c : this->candidates_)
  {
    least = std::min(least, c.distance(p));
  }
  return std::max(least, 0.0);
}

const std::vector<Window>& FaceEnvelope::along(Vec2 p, Vec2 q)
{
  const double length = norm(q - p);
  this->envelope_.clear();
  if (!(length > 0.0))
  {
    return this->envelope_;
  }
  // A candidate that is longer in the middle by the length is so throughout.
  const Vec2 middle = 0.5 * (p + q);
  this->middle_.clear();
  double least = Infinity;
  for (const DistanceCandidate& c : this->candidates_)
  {
    this->middle_.push_back(c.distance(middle));
    least = std::min(least, this->middle_.back());
  }
  const double bound = (least + length) * (1.0 + tolerance::Tie);
  this->near_.clear();
  for (std::size_t i = 0; i < this->middle_.size(); ++i)
  {
    if (this->middle_[i] <= bound)
    {
      this->near_.push_back(&this->candidates_[i]);
    }
  }
  // In the exact field bent paths only fill gaps of rounding; merged windows may need them.
  const Vec2 u = (1.0 / length) * (q - p);
  const bool done = this->exact_ && this->buildAlong(p, u, length, false) &&
    this->reaches(0.5 * length, least) && this->reaches(0.0, this->leastNear(p)) &&
    this->reaches(length, this->leastNear(q));
  if (!done)
  {
    this->buildAlong(p, u, length, true);
  }
  return this->envelope_;
}

double FaceEnvelope::leastNear(Vec2 p) const
{
  double least = Infinity;
  for (const DistanceCandidate* c : this->near_)
  {
    least = std::min(least, c->distance(p));
  }
  return least;
}

// Whether the envelope comes down to the distance at x: a segment along a ray at the end of a
// pencil may be lost to rounding.
bool FaceEnvelope::reaches(double x, double distance) const
{
  const auto window = std::find_if(this->envelope_.begin(), this->envelope_.end() - 1,
    [x](const Window& w) { return x <= w.end; });
  return window->distance(x) <= distance + jointSlack(this->envelope_.back().end, distance);
}

// Returns whether neighbours are equal where they meet.
bool FaceEnvelope::buildAlong(Vec2 p, Vec2 u, double length, bool withBent)
{
  this->pieces_.clear();
  for (const DistanceCandidate* c : this->near_)
  {
    this->addPieces(*c, p, u, length, withBent);
  }
  std::sort(this->pieces_.begin(), this->pieces_.end(),
    [](const Window& a, const Window& b) { return a.begin < b.begin; });
  this->builder_.reset(length);
  for (const Window& piece : this->pieces_)
  {
    this->builder_.append(piece);
  }
  // What fills a gap of rounding may be far above; the neighbours stand for it.
  this->envelope_.clear();
  std::copy_if(this->builder_.windows().begin(), this->builder_.windows().end(),
    std::back_inserter(this->envelope_),
    [length](const Window& w) { return w.width() > tolerance::PencilMargin * length; });
  if (this->envelope_.empty())
  {
    return false;
  }
  bool continuous = true;
  this->envelope_.front().begin = 0.0;
  this->envelope_.back().end = length;
  for (std::size_t i = 1; i < this->envelope_.size(); ++i)
  {
    Window& left = this->envelope_[i - 1];
    const Window& right = this->envelope_[i];
    left.end = right.begin;
    const double value = right.distance(right.begin);
    const double slack = jointSlack(length, value);
    continuous = continuous && std::abs(left.distance(left.end) - value) <= slack;
  }
  return continuous;
}

void FaceEnvelope::addPieces(
  const DistanceCandidate& c, Vec2 p, Vec2 u, double length, bool withBent)
{
  switch (c.kind)
  {
    case DistanceCandidate::Kind::Cone:
      this->addCone(c.source, c.sigma, p, u, 0.0, length);
      break;
    case DistanceCandidate::Kind::Segment:
      this->addSegment(c, p, u, length);
      break;
    case DistanceCandidate::Kind::Circular:
    case DistanceCandidate::Kind::Linear:
      this->addWindow(c, p, u, length, withBent);
      break;
  }
}

namespace
{

Window linearAlong(double sigma, double slope, double depth, Interval interval)
{
  return { interval.begin, interval.end, slope, std::abs(depth), sigma, 0.0, Window::Kind::Linear,
    0 };
}

} // anonymous namespace

void FaceEnvelope::addWindow(
  const DistanceCandidate& c, Vec2 p, Vec2 u, double length, bool withBent)
{
  const bool linear = c.kind == DistanceCandidate::Kind::Linear;
  const Vec2 first = linear ? c.source : c.begin - c.source;
  const Vec2 last = linear ? c.source : c.end - c.source;
  const double leftOfBegin = cross(first, p - c.begin);
  const double leftOfBeginSlope = cross(first, u);
  const double leftOfEnd = cross(last, p - c.end);
  const double leftOfEndSlope = cross(last, u);
  Interval interval{ 0.0, length };
  interval.clip(-leftOfBegin, -leftOfBeginSlope);
  interval.clip(leftOfEnd, leftOfEndSlope);
  interval.widen(tolerance::PencilMargin * length, length);
  if (interval.end > interval.begin)
  {
    if (linear)
    {
      this->pieces_.push_back(
        linearAlong(c.sigma + dot(c.source, p), dot(c.source, u), cross(c.source, u), interval));
    }
    else
    {
      this->addCone(c.source, c.sigma, p, u, interval.begin, interval.end);
    }
  }
  if (withBent)
  {
    Interval bent{ 0.0, length };
    bent.clip(leftOfBegin, leftOfBeginSlope);
    bent.widen(tolerance::PencilMargin * length, length);
    this->addCone(c.begin, c.atBegin, p, u, bent.begin, bent.end);
    bent = { 0.0, length };
    bent.clip(-leftOfEnd, -leftOfEndSlope);
    bent.widen(tolerance::PencilMargin * length, length);
    this->addCone(c.end, c.atEnd, p, u, bent.begin, bent.end);
  }
}

// Parallel rays to both sides of the source's segment, and its two ends.
void FaceEnvelope::addSegment(const DistanceCandidate& c, Vec2 p, Vec2 u, double length)
{
  this->addCone(c.begin, 0.0, p, u, 0.0, length);
  this->addCone(c.end, 0.0, p, u, 0.0, length);
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
  for (const double sign : { 1.0, -1.0 })
  {
    const double height = sign * cross(t, p - c.begin);
    const double slope = sign * cross(t, u);
    Interval oneSide = strip;
    oneSide.clip(height, slope);
    if (oneSide.end > oneSide.begin)
    {
      this->pieces_.push_back(linearAlong(height, slope, alongSlope, oneSide));
    }
  }
}

void FaceEnvelope::addCone(Vec2 apex, double sigma, Vec2 p, Vec2 u, double begin, double end)
{
  if (end > begin)
  {
    const Vec2 toApex = apex - p;
    this->pieces_.push_back({ begin, end, dot(toApex, u), std::abs(cross(toApex, u)), sigma, 0.0,
      Window::Kind::Circular, 0 });
  }
}

}
