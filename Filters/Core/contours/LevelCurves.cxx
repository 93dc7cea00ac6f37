// SPDX-License-Identifier: BSD-3-Clause
#include "contours/LevelCurves.h"

#include "Tolerance.h"
#include "Trigonometry.h"

#include <algorithm>

namespace geodesic
{

namespace
{

Vec2 unitOr(Vec2 v, Vec2 otherwise)
{
  const double length = norm(v);
  return length > 0.0 ? (1.0 / length) * v : otherwise;
}

/// By the angle whose half has this tangent.
Vec2 turnedClockwise(Vec2 v, double halfTangent)
{
  const double squared = halfTangent * halfTangent;
  const double c = (1.0 - squared) / (1.0 + squared);
  const double s = 2.0 * halfTangent / (1.0 + squared);
  return { c * v.x + s * v.y, c * v.y - s * v.x };
}

/// The clockwise angle from one unit vector to another, in [0, 2 pi).
double clockwiseAngle(Vec2 from, Vec2 to)
{
  const double angle = polarAngle({ dot(from, to), cross(to, from) });
  return angle < 0.0 ? angle + 2.0 * Pi : angle;
}

/// Appends an arc in parts of a right angle at most.
void addArcs(Vec2 center, double radius, Vec2 axis, double angle, std::vector<LevelCurve>& curves)
{
  const double parts = std::ceil(angle / (0.5 * Pi) - tolerance::Tie);
  const double halfTangent = tangent(0.5 * angle / parts);
  for (int i = 0; i < static_cast<int>(parts); ++i)
  {
    curves.push_back({ true, center, axis, radius, halfTangent });
    axis = turnedClockwise(axis, halfTangent);
  }
}

void addParameter(const LevelCurve& curve, Vec2 p, std::vector<double>& parameters)
{
  const Vec2 v = p - curve.origin;
  const double along = dot(curve.axis, v);
  const double t = curve.isArc ? cross(v, curve.axis) / std::max(along + curve.radius, 0.0) : along;
  if (t > 0.0 && t < curve.extent)
  {
    parameters.push_back(t);
  }
}

/// Appends the parameters where a line meets a circle; one of them is the curve's.
void addLineWithCircle(const PlaneLine& line, Vec2 center, double radius, const LevelCurve& curve,
  std::vector<double>& parameters)
{
  const Vec2 toCenter = center - line.point;
  const double aside = line.aside(center);
  const double squared = (radius - aside) * (radius + aside);
  if (squared >= 0.0)
  {
    const double foot = dot(line.along, toCenter);
    const double half = std::sqrt(squared);
    for (const double along : { foot - half, foot + half })
    {
      addParameter(curve, line.point + along * line.along, parameters);
    }
  }
}

/// Appends the parameters on the curve where it meets a circle, in no order.
void addMeetingsWithCircle(
  const LevelCurve& curve, Vec2 center, double radius, std::vector<double>& parameters)
{
  if (!curve.isArc)
  {
    addLineWithCircle({ curve.origin, curve.axis }, center, radius, curve, parameters);
    return;
  }
  const Vec2 toCenter = center - curve.origin;
  const double between = norm(toCenter);
  if (!(between > 0.0))
  {
    return;
  }
  const double along =
    0.5 * (between + (curve.radius - radius) * (curve.radius + radius) / between);
  const double squared = (curve.radius - along) * (curve.radius + along);
  if (squared >= 0.0)
  {
    const Vec2 axis = (1.0 / between) * toCenter;
    const Vec2 foot = curve.origin + along * axis;
    const Vec2 aside = std::sqrt(squared) * leftOf(axis);
    addParameter(curve, foot + aside, parameters);
    addParameter(curve, foot - aside, parameters);
  }
}

} // anonymous namespace

// An arc is not farther from its chord than this, nor than its own length.
CurvePart::CurvePart(const LevelCurve& levelCurve, double from, double to, double gap)
  : curve(levelCurve)
  , begin(levelCurve.at(from))
  , end(levelCurve.at(to))
  , room(gap)
  , endShare(tolerance::CurveEndShare)
{
  const double chord = norm(this->end - this->begin);
  if (gap < tolerance::CurveEndShare * chord)
  {
    this->endShare = gap / chord;
  }
  if (levelCurve.isArc)
  {
    const double length = 2.0 * levelCurve.radius * (to - from); // or a little less
    this->room += std::min(length, 0.125 * length * length / levelCurve.radius);
  }
}

Vec2 LevelCurve::at(double t) const
{
  return this->isArc ? this->origin + this->radius * turnedClockwise(this->axis, t)
                     : this->origin + t * this->axis;
}

void addMeetings(const LevelCurve& curve, const PlaneLine& line, std::vector<double>& parameters)
{
  if (curve.isArc)
  {
    addLineWithCircle(line, curve.origin, curve.radius, curve, parameters);
    return;
  }
  const double slope = cross(line.along, curve.axis);
  if (slope != 0.0)
  {
    const double t = cross(line.along, line.point - curve.origin) / slope;
    addParameter(curve, curve.at(t), parameters);
  }
}

bool hasPointsBefore(const DistanceCandidate& c, double value)
{
  if (!c.hasPencil())
  {
    return c.sigma < value;
  }
  if (std::min(c.atBegin, c.atEnd) < value || c.kind == DistanceCandidate::Kind::Linear)
  {
    return std::min(c.atBegin, c.atEnd) < value;
  }
  const Vec2 along = unitOr(c.end - c.begin, { 1.0, 0.0 });
  const double x = std::clamp(dot(c.source - c.begin, along), 0.0, norm(c.end - c.begin));
  return c.sigma + norm(c.begin + x * along - c.source) < value;
}

LevelRegion::LevelRegion(const DistanceCandidate& candidate, double value, double margin)
  : candidate_(candidate)
  , level_(value - candidate.sigma)
  , margin_(margin)
{
  const bool isLinear = candidate.kind == DistanceCandidate::Kind::Linear;
  if (candidate.hasPencil())
  {
    const Vec2 along = unitOr(candidate.end - candidate.begin, { 1.0, 0.0 });
    const Vec2 first =
      isLinear ? candidate.source : unitOr(candidate.begin - candidate.source, -1.0 * along);
    const Vec2 last = isLinear ? candidate.source : unitOr(candidate.end - candidate.source, along);
    this->rays_ = { { { candidate.begin, first }, { candidate.end, -1.0 * last } } };
  }
}

double LevelRegion::straightTo(Vec2 p) const
{
  const DistanceCandidate& c = this->candidate_;
  return c.kind == DistanceCandidate::Kind::Linear ? dot(c.source, p)
    : c.kind == DistanceCandidate::Kind::Segment   ? c.distance(p)
                                                   : norm(p - c.source);
}

// Slopes are at most 1.
double LevelRegion::leastStraightTo(const CurvePart& part) const
{
  const double atEnds = this->straightTo(part.begin) + this->straightTo(part.end);
  return 0.5 * (atEnds - norm(part.end - part.begin)) - part.room;
}

bool LevelRegion::covers(const CurvePart& part) const
{
  return std::all_of(this->rays().begin(), this->rays().end(),
           [&](const PlaneLine& ray) { return ray.mostAside(part) <= this->margin_; }) &&
    this->mostStraightTo(part) < this->level_;
}

// Rays go from the window no farther than the face is long, nor than the value is over the least
// distance there. In a pencil of up to 60 degrees they end before the chord between the two at its
// ends, if these are twice as long.
Interval LevelRegion::alongAxis(Vec2 axis, double size) const
{
  const Vec2 first = this->rays_[0].along;
  const Vec2 last = -1.0 * this->rays_[1].along;
  if (!(dot(first, last) > 0.5))
  {
    return { -Infinity, Infinity };
  }
  const DistanceCandidate& c = this->candidate_;
  const double least = std::min(c.atBegin, c.atEnd) - norm(c.end - c.begin);
  const double reach = 2.0 * std::min(size, this->level_ + c.sigma - least);
  const auto [low, high] = std::minmax({ dot(axis, c.begin), dot(axis, c.end),
    dot(axis, c.begin + reach * first), dot(axis, c.end + reach * last) });
  return { low - this->margin_, high + this->margin_ };
}

bool LevelRegion::contains(Vec2 p) const
{
  return std::all_of(this->rays().begin(), this->rays().end(),
           [&](const PlaneLine& ray) { return ray.aside(p) <= this->margin_; }) &&
    this->straightTo(p) < this->level_;
}

void LevelRegion::addCurves(
  const std::array<Vec2, 3>& corners, double gap, std::vector<LevelCurve>& curves) const
{
  const DistanceCandidate& c = this->candidate_;
  const double r = this->level_;
  const auto isReached = [&](Vec2 corner) { return r <= norm(corner - c.source) + gap; };
  switch (c.kind)
  {
    case DistanceCandidate::Kind::Cone:
      if (std::any_of(corners.begin(), corners.end(), isReached))
      {
        addArcs(c.source, r, { 1.0, 0.0 }, 2.0 * Pi, curves);
      }
      break;
    case DistanceCandidate::Kind::Circular:
      if (std::any_of(corners.begin(), corners.end(), isReached))
      {
        this->addArc(this->rays_[0].along, -1.0 * this->rays_[1].along, curves);
      }
      break;
    case DistanceCandidate::Kind::Linear:
    {
      const Vec2 along = -1.0 * leftOf(c.source);
      const double length = dot(along, c.end - c.begin) + 2.0 * this->margin_;
      const Vec2 begin = c.begin + (r - dot(c.source, c.begin)) * c.source;
      if (length > 0.0)
      {
        curves.push_back({ false, begin - this->margin_ * along, along, 0.0, length });
      }
      break;
    }
    case DistanceCandidate::Kind::Segment:
    {
      // Straight along both sides of the segment, round its ends.
      const double length = norm(c.end - c.begin);
      const Vec2 along = unitOr(c.end - c.begin, { 1.0, 0.0 });
      const Vec2 left = leftOf(along);
      curves.push_back({ false, c.begin + r * left, along, 0.0, length });
      addArcs(c.end, r, left, Pi, curves);
      curves.push_back({ false, c.end - r * left, -1.0 * along, 0.0, length });
      addArcs(c.begin, r, -1.0 * left, Pi, curves);
      break;
    }
  }
}

// From the margin before the one ray to that behind the other; the rays pass through the centre.
void LevelRegion::addArc(Vec2 first, Vec2 last, std::vector<LevelCurve>& curves) const
{
  constexpr double smallSine = 0.1;
  // The angle of the margin, seen from the centre.
  const double sine = std::min(1.0, this->margin_ / this->level_);
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  const Vec2 axis = turnedClockwise(first, -sine / (1.0 + cosine));
  const double towards = dot(first, last);
  if (towards > 0.0 && sine < smallSine)
  {
    // A narrow pencil. Rays that nearly coincide may seem to turn the other way.
    const double half = std::max(0.0, cross(last, first) / (1.0 + towards));
    const double more = sine / cosine;
    const double halfTangent = (half + more) / (1.0 - half * more);
    if (halfTangent <= 1.0)
    {
      curves.push_back({ true, this->candidate_.source, axis, this->level_, halfTangent });
      return;
    }
  }
  const double between = clockwiseAngle(first, last);
  const double angle = (between > 1.5 * Pi ? 0.0 : between) + 2.0 * arcSine(sine);
  addArcs(this->candidate_.source, this->level_, axis, std::min(angle, 2.0 * Pi), curves);
}

void LevelRegion::addMeetings(const CurvePart& part, std::vector<double>& parameters) const
{
  const LevelCurve& curve = part.curve;
  const DistanceCandidate& c = this->candidate_;
  for (const PlaneLine& ray : this->rays())
  {
    if (ray.mostAside(part) >= this->margin_)
    {
      geodesic::addMeetings(
        curve, { ray.point + this->margin_ * leftOf(ray.along), ray.along }, parameters);
    }
  }
  if (this->mostStraightTo(part) < this->level_)
  {
    return;
  }
  if (c.kind == DistanceCandidate::Kind::Linear)
  {
    geodesic::addMeetings(curve, { this->level_ * c.source, leftOf(c.source) }, parameters);
  }
  else if (c.kind == DistanceCandidate::Kind::Segment)
  {
    const Vec2 along = unitOr(c.end - c.begin, { 1.0, 0.0 });
    const Vec2 aside = this->level_ * leftOf(along);
    geodesic::addMeetings(curve, { c.begin + aside, along }, parameters);
    geodesic::addMeetings(curve, { c.begin - aside, along }, parameters);
    addMeetingsWithCircle(curve, c.begin, this->level_, parameters);
    addMeetingsWithCircle(curve, c.end, this->level_, parameters);
  }
  else
  {
    addMeetingsWithCircle(curve, c.source, this->level_, parameters);
  }
}

}
