// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LevelCurves_h
#define geodesic_LevelCurves_h

#include "field/FaceDistance.h"
#include "window/Interval.h"

#include <algorithm>
#include <array>
#include <vector>

namespace geodesic
{

/// A part of the curve on which one distance candidate has a value: an arc of a circle or a
/// straight piece. It runs so that the distance grows to its left.
struct LevelCurve
{
  bool isArc;
  /// The centre of an arc; where a straight piece begins.
  Vec2 origin;
  /// A unit vector: from the centre to where an arc begins; along a straight piece.
  Vec2 axis;
  double radius;
  /// The end of the curve's parameter: the tangent of half the angle of an arc, clockwise, at most
  /// 1; the length of a straight piece. On an arc, this parameter needs no trigonometry.
  double extent;
  /// The number of the region that it bounds.
  std::size_t region = 0;

  /// The point at t, from 0 to extent.
  Vec2 at(double t) const;
};

/// A part of a level curve.
struct CurvePart
{
  const LevelCurve& curve;
  Vec2 begin;
  Vec2 end;
  /// The part lies within this of its chord, with a gap to spare.
  double room;
  /// What share of it at one end is no longer than a gap (see tolerance::CurveEndShare).
  double endShare;

  CurvePart(const LevelCurve& levelCurve, double from, double to, double gap);

  /// Where its points lie along an axis.
  Interval alongAxis(Vec2 axis) const
  {
    const auto [least, most] = std::minmax({ dot(axis, this->begin), dot(axis, this->end) });
    return { least - this->room, most + this->room };
  }
  /// Whether its farthest point in a direction is between its ends. Arcs run clockwise.
  bool bulges(Vec2 direction) const
  {
    return this->curve.isArc && cross(direction, this->begin - this->curve.origin) > 0.0 &&
      cross(this->end - this->curve.origin, direction) > 0.0;
  }
};

inline Vec2 leftOf(Vec2 direction)
{
  return { -direction.y, direction.x };
}

/// A line through a point; `along` is a unit vector wherever lengths matter.
struct PlaneLine
{
  Vec2 point;
  Vec2 along;

  /// How far to the left of the line a point lies.
  double aside(Vec2 p) const { return cross(this->along, p - this->point); }
  /// Bounds of the same for the points of a part of a curve.
  double leastAside(const CurvePart& part) const
  {
    return std::min(this->aside(part.begin), this->aside(part.end)) - part.room;
  }
  double mostAside(const CurvePart& part) const
  {
    return std::max(this->aside(part.begin), this->aside(part.end)) + part.room;
  }
  /// Whether a part of a curve lies farther to the left than this, but for a gap at its end.
  bool hasOnLeft(const CurvePart& part, double aside) const
  {
    const auto [least, most] = std::minmax({ this->aside(part.begin), this->aside(part.end) });
    return least - part.room > aside ||
      (aside - least < part.endShare * (most - least) && !part.bulges(-1.0 * leftOf(this->along)));
  }
};

/// Appends the parameters on the curve where it meets a line, in no order.
void addMeetings(const LevelCurve& curve, const PlaneLine& line, std::vector<double>& parameters);

/// Whether a window or a source of the candidate is nearer than the value somewhere.
bool hasPointsBefore(const DistanceCandidate& candidate, double value);

/// The points that one distance candidate reaches straight within a value: a convex region bounded
/// by the rays at the ends of the candidate's window and by level curves.
class LevelRegion
{
public:
  /// \param margin by which the pencil is widened, so that those of neighbours leave no gap.
  LevelRegion(const DistanceCandidate& candidate, double value, double margin);

  bool contains(Vec2 p) const;
  /// The direction of one of its rays; zero without a pencil.
  Vec2 direction() const { return this->rays_[0].along; }
  /// Bounds of where its points in a face of that size lie along an axis.
  Interval alongAxis(Vec2 axis, double size) const;
  /// Appends the curves that bound it near a face, each as far as the widened pencil goes.
  void addCurves(
    const std::array<Vec2, 3>& corners, double gap, std::vector<LevelCurve>& curves) const;
  /// Whether one of the lines that bound the region separates it from a part of a curve, but for
  /// gaps: where the widened pencils of neighbours overlap, the ends of their curves are one, and
  /// need not be cut. If not, it may miss the part nevertheless.
  bool misses(const CurvePart& part) const
  {
    return std::any_of(this->rays().begin(), this->rays().end(),
             [&](const PlaneLine& ray) { return ray.hasOnLeft(part, this->margin_); }) ||
      this->leastStraightTo(part) > this->level_;
  }
  /// Whether all of a part of a curve certainly lies in the region.
  bool covers(const CurvePart& part) const;
  /// Appends the parameters where a part of a curve may enter or leave the region, and others.
  void addMeetings(const CurvePart& part, std::vector<double>& parameters) const;

private:
  ArrayRange<PlaneLine> rays() const
  {
    return { this->rays_.data(), this->rays_.data() + (this->candidate_.hasPencil() ? 2 : 0) };
  }
  // The length of the way straight to a point, from the source or along parallel rays; a lower
  // bound of it to the points of a part of a curve, and an upper one.
  double straightTo(Vec2 p) const;
  double leastStraightTo(const CurvePart& part) const;
  double mostStraightTo(const CurvePart& part) const
  {
    return std::max(this->straightTo(part.begin), this->straightTo(part.end)) + part.room;
  }
  void addArc(Vec2 first, Vec2 last, std::vector<LevelCurve>& curves) const;

  DistanceCandidate candidate_;
  /// How far from the source it reaches; with parallel rays, along these from the origin.
  double level_;
  double margin_;
  /// The rays at the window's ends, the second one backwards: the pencil lies to the right of both,
  /// up to the margin. Without a pencil there are none.
  std::array<PlaneLine, 2> rays_{};
};

}

#endif
