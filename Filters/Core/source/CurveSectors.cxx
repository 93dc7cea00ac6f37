// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurveSectors.h"

#include "Trigonometry.h"
#include "source/TurnAroundPoint.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

void CurveSectors::assign(
  const SurfacePoint& point, const std::vector<SegmentEnd>& ends, Id curve, double parameter)
{
  this->whole_ = { curve, false, parameter };
  this->frames_.clear();
  this->totals_.clear();
  this->ends_.clear();
  if (!ends.empty())
  {
    forEachFace(this->mesh_, point, [&](Id face) { this->addFan(point, face); });
  }
  for (const SegmentEnd& end : ends)
  {
    this->addFan(end.from, end.face);
    this->addEnd(end);
  }
  std::stable_sort(this->ends_.begin(), this->ends_.end());
  this->findChanges();
}

// Adds the faces around the point in the order of a turn that begins in a face, if this one is new:
// counterclockwise as far as faces follow, and clockwise from the beginning if that does not close
// the fan.
void CurveSectors::addFan(const SurfacePoint& point, Id face)
{
  if (this->haveFace(face))
  {
    return;
  }
  const std::size_t fan = this->totals_.size();
  double& total = this->totals_.emplace_back(Infinity);
  if (point.kind == SurfacePoint::Kind::Face)
  {
    this->frames_[face] = { longestHalfedge(this->mesh_, face), { fan, 0.0 }, FullAngle };
    total = FullAngle;
    return;
  }
  TurnAroundPoint turn(this->mesh_, point, face);
  const auto addFrame = [&](double axis)
  {
    this->frames_.emplace(
      TriangleMesh::faceOf(turn.halfedge()), Frame{ turn.halfedge(), { fan, axis }, turn.width() });
  };
  double angle = 0.0;
  do
  {
    addFrame(angle);
    angle += turn.width();
  } while (turn.next());
  if (turn.isClosed())
  {
    total = angle;
    return;
  }
  double end = 0.0; // of the face
  for (bool isThere = turn.turnBack(); isThere; isThere = turn.next())
  {
    end -= turn.width();
    addFrame(end);
  }
}

void CurveSectors::addEnd(const SegmentEnd& end)
{
  const Frame& frame = *this->frameOf(end.face);
  // The counterclockwise side of a segment that begins here is its left side.
  this->ends_.push_back({ this->angleIn(frame, directionIn(this->mesh_, end, frame.halfedge)),
    { end.curve, !end.isBeginning, end.parameter },
    { end.curve, end.isBeginning, end.parameter } });
}

// At the segments themselves, and in the middle between consecutive ones.
void CurveSectors::findChanges()
{
  this->changes_.clear();
  std::size_t first = 0; // of the fan
  for (std::size_t i = 0; i < this->ends_.size(); ++i)
  {
    const End& end = this->ends_[i];
    this->changes_.push_back(end.at);
    const std::size_t fan = end.at.fan;
    first = this->ends_[first].at.fan == fan ? first : i;
    const bool isLast = i + 1 == this->ends_.size() || this->ends_[i + 1].at.fan != fan;
    const End& next = isLast ? this->ends_[first] : this->ends_[i + 1];
    const double nextAngle = next.at.angle + (isLast ? this->totals_[fan] : 0.0);
    if (nextAngle < Infinity && end.after != next.before)
    {
      const double middle = 0.5 * (end.at.angle + nextAngle);
      this->changes_.push_back(
        { fan, middle < this->totals_[fan] ? middle : middle - this->totals_[fan] });
    }
  }
  std::sort(this->changes_.begin(), this->changes_.end());
}

const CurveSectors::Frame* CurveSectors::frameOf(Id face) const
{
  const auto found = this->frames_.find(face);
  return found != this->frames_.end() ? &found->second : nullptr;
}

// Rounding may put the direction of a halfedge from the point slightly below the x axis.
CurveSectors::FanAngle CurveSectors::angleIn(const Frame& frame, Vec2 direction) const
{
  const double angle = polarAngle(direction);
  double around = frame.axis.angle + (angle < -RightAngle ? angle + FullAngle : angle);
  const double total = this->totals_[frame.axis.fan];
  if (total < Infinity)
  {
    around -= total * std::floor(around / total);
  }
  return { frame.axis.fan, around };
}

SideOfCurve CurveSectors::of(Id halfedge, Vec2 direction) const
{
  const Frame* frame = this->frameOf(TriangleMesh::faceOf(halfedge));
  if (frame == nullptr || !(dot(direction, direction) > 0.0))
  {
    return this->whole_;
  }
  const FanAngle at =
    this->angleIn(*frame, turned(this->mesh_, direction, halfedge, frame->halfedge));
  const auto begin =
    std::lower_bound(this->ends_.begin(), this->ends_.end(), End{ { at.fan, -Infinity }, {}, {} });
  const auto end = std::upper_bound(begin, this->ends_.end(), End{ { at.fan, Infinity }, {}, {} });
  if (begin == end)
  {
    return this->whole_;
  }
  const auto next = std::upper_bound(begin, end, End{ at, {}, {} });
  // The segments before and behind the direction, across the beginning of a closed fan.
  const double total = this->totals_[at.fan];
  const End& before = next != begin ? *(next - 1) : *(end - 1);
  const End& behind = next != end ? *next : *begin;
  const double turn = at.angle - before.at.angle + (next != begin ? 0.0 : total);
  const double turnBack = behind.at.angle - at.angle + (next != end ? 0.0 : total);
  return turn <= turnBack ? before.after : behind.before;
}

std::vector<Vec2> CurveSectors::changesIn(Id halfedge) const
{
  std::vector<Vec2> changes;
  const Frame* frame = this->frameOf(TriangleMesh::faceOf(halfedge));
  if (frame == nullptr || this->changes_.empty())
  {
    return changes;
  }
  const double total = this->totals_[frame->axis.fan];
  for (const double shift : { 0.0, total })
  {
    if (!(shift < Infinity))
    {
      continue;
    }
    const FanAngle axis = { frame->axis.fan, frame->axis.angle - shift };
    for (auto change = std::lower_bound(this->changes_.begin(), this->changes_.end(), axis);
         change != this->changes_.end() && change->fan == axis.fan &&
         change->angle <= axis.angle + frame->width;
         ++change)
    {
      const double turn = change->angle - axis.angle;
      changes.push_back(turned(this->mesh_, unitVector(turn), frame->halfedge, halfedge));
    }
  }
  return changes;
}

}
