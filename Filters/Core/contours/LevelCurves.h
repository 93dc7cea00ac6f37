// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LevelCurves_h
#define geodesic_LevelCurves_h

#include "field/FaceDistance.h"

#include <array>
#include <vector>

namespace geodesic
{

/// A part of the curve on which one distance candidate has a value: an arc of a circle or a
/// straight piece. It runs so that the distance grows to its left.
struct LevelCurve
{
  /// Number of the face's candidate.
  std::size_t candidate;
  bool isArc;
  /// The centre of an arc; where a straight piece begins.
  Vec2 origin;
  /// A unit vector: from the centre to where an arc begins; along a straight piece.
  Vec2 axis;
  double radius;
  /// The end of the curve's parameter: the tangent of half the angle of an arc, clockwise, at most
  /// 1; the length of a straight piece. On an arc, this parameter needs no trigonometry.
  double extent;

  /// The point at t, from 0 to extent.
  Vec2 at(double t) const;
};

/// A rectangle around a face. Places outside it do not matter.
struct PlaneBox
{
  Vec2 low;
  Vec2 high;

  /// The corner that is farthest in a direction, also if all are compared with rounding: rounding
  /// keeps the order.
  Vec2 corner(Vec2 direction) const
  {
    return { direction.x < 0.0 ? this->low.x : this->high.x,
      direction.y < 0.0 ? this->low.y : this->high.y };
  }
  /// The least distance of its points from p, and the largest.
  double nearest(Vec2 p) const;
  double farthest(Vec2 p) const;
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
  /// The same of the points of a box that lie farthest to the left, and to the right.
  double mostAside(const PlaneBox& box) const
  {
    return this->aside(box.corner(leftOf(this->along)));
  }
  double leastAside(const PlaneBox& box) const
  {
    return this->aside(box.corner(-1.0 * leftOf(this->along)));
  }
};

/// Appends the parameters on the curve where it meets a line, in no order.
void addMeetings(const LevelCurve& curve, const PlaneLine& line, std::vector<double>& parameters);

/// The points that one distance candidate reaches straight within a value: a convex region bounded
/// by the rays at the ends of the candidate's window and by level curves.
class LevelRegion
{
public:
  /// \param margin by which the pencil is widened, so that those of neighbours leave no gap.
  LevelRegion(const DistanceCandidate& candidate, std::size_t number, double value, double margin);

  /// Whether a way through the window's nearest point, or from the source, begins before the value.
  /// If not, the region is empty.
  bool hasPointsBefore(double value) const;
  bool contains(Vec2 p) const;
  /// Appends the curves that bound it in the box, each as far as the widened pencil goes.
  void addCurves(const PlaneBox& box, std::vector<LevelCurve>& curves) const;
  /// Whether one of the lines that bound the region separates it from a box. If not, it may miss
  /// the box nevertheless.
  bool misses(const PlaneBox& box) const;
  /// Appends the parameters where a curve may enter or leave the region, and others.
  void addMeetings(const LevelCurve& curve, std::vector<double>& parameters) const;

private:
  ArrayRange<PlaneLine> rays() const
  {
    return { this->rays_.data(), this->rays_.data() + (this->candidate_.hasPencil() ? 2 : 0) };
  }
  double straightTo(Vec2 p) const;
  double leastStraightTo(const PlaneBox& box) const;
  void addArc(std::vector<LevelCurve>& curves) const;

  DistanceCandidate candidate_;
  std::size_t number_;
  /// How far from the source it reaches; with parallel rays, along these from the origin.
  double level_;
  double margin_;
  /// The rays at the window's ends, the second one backwards: the pencil lies to the right of both,
  /// up to the margin. Without a pencil there are none.
  std::array<PlaneLine, 2> rays_;
};

}

#endif
