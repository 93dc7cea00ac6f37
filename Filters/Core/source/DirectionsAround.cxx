// SPDX-License-Identifier: BSD-3-Clause
#include "source/DirectionsAround.h"

#include "Trigonometry.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

constexpr std::size_t None = static_cast<std::size_t>(-1);
// A gap: rounding at the end of a fan must not lead into the next one.
constexpr double BetweenFans = 1.0;

/// In (-pi, pi].
double wrapped(double angle)
{
  const double turns = std::ceil((angle - Pi) / FullAngle);
  return std::clamp(angle - turns * FullAngle, -Pi, Pi);
}

} // anonymous namespace

void DirectionsAround::assign(const SurfacePoint& point, const std::vector<SegmentEnd>& ends)
{
  this->point_ = point;
  this->frames_.clear();
  this->fans_.clear();
  this->ends_.clear();
  this->toAxis_ = 0.0;
  switch (point.kind)
  {
    case SurfacePoint::Kind::Face:
      this->frames_.push_back({ TriangleMesh::halfedgeOf(point.id, 0), 0.0, false, 0 });
      this->fans_.push_back({ 0.0, FullAngle, true });
      break;
    case SurfacePoint::Kind::Edge:
      this->addFanOfEdge(point.id);
      break;
    case SurfacePoint::Kind::Vertex:
      for (const Id corner : this->mesh_.cornersAt(point.id))
      {
        this->frames_.push_back({ corner, 0.0, false, None });
      }
      for (const Id corner : this->mesh_.cornersAt(point.id))
      {
        if (this->frameOf(TriangleMesh::faceOf(corner)).fan == None)
        {
          this->addFanOfVertex(corner);
        }
      }
      break;
  }
  for (const SegmentEnd& end : ends)
  {
    const Id halfedge = longestHalfedge(this->mesh_, end.face);
    const double around = this->around(halfedge, directionIn(this->mesh_, end, halfedge));
    this->ends_.push_back(
      { this->fanOf(around).at(around), end.curve, end.parameter, end.isBeginning });
  }
  std::stable_sort(this->ends_.begin(), this->ends_.end());
}

// All other faces at the edge continue the first one.
void DirectionsAround::addFanOfEdge(Id halfedge)
{
  const Id first = this->mesh_.edgeOf(halfedge);
  this->frames_.push_back({ first, 0.0, false, 0 });
  for (Id s = this->mesh_.nextSibling(first); s != first; s = this->mesh_.nextSibling(s))
  {
    const bool isMirrored = this->mesh_.origin(s) == this->mesh_.origin(first);
    this->frames_.push_back({ s, isMirrored ? FullAngle : Pi, isMirrored, 0 });
  }
  std::sort(this->frames_.begin(), this->frames_.end(),
    [](const Frame& a, const Frame& b) { return a.halfedge < b.halfedge; });
  const bool isClosed = this->frames_.size() > 1;
  this->fans_.push_back({ 0.0, isClosed ? FullAngle : Pi, isClosed });
  const Id firstOfFace = TriangleMesh::halfedgeOf(TriangleMesh::faceOf(first), 0);
  const Vec2 axis = turned(this->mesh_, { 1.0, 0.0 }, first, firstOfFace);
  this->toAxis_ = polarAngle(axis);
}

// Clockwise to where the fan begins, or once around; then counterclockwise to its end.
void DirectionsAround::addFanOfVertex(Id corner)
{
  Stop begin = { corner, false };
  bool isClosed = false;
  for (Stop stop = this->beside(begin, true); stop.corner != NoId && !isClosed;
       stop = this->beside(stop, true))
  {
    isClosed = stop.corner == corner;
    begin = stop;
  }
  const double start =
    this->fans_.empty() ? 0.0 : this->fans_.back().begin + this->fans_.back().total + BetweenFans;
  double angle = start;
  Stop stop = begin;
  do
  {
    const double width = this->mesh_.cornerAngle(stop.corner);
    Frame& frame = this->frames_[this->indexOf(TriangleMesh::faceOf(stop.corner))];
    frame.axis = stop.isMirrored ? angle + width : angle;
    frame.isMirrored = stop.isMirrored;
    frame.fan = this->fans_.size();
    angle += width;
    stop = this->beside(stop, false);
  } while (stop.corner != NoId && stop.corner != begin.corner);
  this->fans_.push_back({ start, angle - start, isClosed });
}

// In a mirrored face a turn comes across the edges in the opposite order.
DirectionsAround::Stop DirectionsAround::beside(const Stop& stop, bool isClockwise) const
{
  const Id edge =
    stop.isMirrored == isClockwise ? TriangleMesh::previousInFace(stop.corner) : stop.corner;
  if (!this->mesh_.isInner(edge))
  {
    return {};
  }
  const Id entered = this->mesh_.nextSibling(edge);
  const bool isOutgoing = this->mesh_.origin(entered) == this->point_.id;
  return { isOutgoing ? entered : TriangleMesh::nextInFace(entered), isOutgoing == isClockwise };
}

// The index of a face's frame; None if the face is not around the point.
std::size_t DirectionsAround::indexOf(Id face) const
{
  const auto frame =
    std::lower_bound(this->frames_.begin(), this->frames_.end(), TriangleMesh::halfedgeOf(face, 0),
      [](const Frame& f, Id halfedge) { return f.halfedge < halfedge; });
  const bool isThere =
    frame != this->frames_.end() && TriangleMesh::faceOf(frame->halfedge) == face;
  return isThere ? static_cast<std::size_t>(frame - this->frames_.begin()) : None;
}

// Rounding may put the direction of a halfedge from the point slightly below the x axis.
double DirectionsAround::around(Id halfedge, Vec2 direction) const
{
  const Frame& frame = this->frameOf(TriangleMesh::faceOf(halfedge));
  const Vec2 d = turned(this->mesh_, direction, halfedge, frame.halfedge);
  const double turn = polarAngle(d);
  const double angle = turn < -RightAngle ? turn + FullAngle : turn;
  return frame.axis + (frame.isMirrored ? -angle : angle);
}

const DirectionsAround::Fan& DirectionsAround::fanOf(double around) const
{
  const auto next = std::find_if(this->fans_.begin() + 1, this->fans_.end(),
    [around](const Fan& fan) { return around < fan.begin - 0.5 * BetweenFans; });
  return *(next - 1);
}

double DirectionsAround::angleOf(double around) const
{
  const Fan& fan = this->fanOf(around);
  const double at = fan.at(around);
  const auto first = std::lower_bound(this->ends_.begin(), this->ends_.end(), End{ fan.begin });
  const auto last = std::upper_bound(first, this->ends_.end(), End{ fan.begin + fan.total });
  return first == last ? this->withoutSegments(fan, at)
                       : this->betweenSegments(fan, at, &*first, &*first + (last - first));
}

// The angles of a single closed fan are scaled. Several fans follow one another.
double DirectionsAround::withoutSegments(const Fan& fan, double at) const
{
  if (this->point_.kind != SurfacePoint::Kind::Vertex)
  {
    return wrapped(at + this->toAxis_);
  }
  if (fan.isClosed && this->fans_.size() == 1)
  {
    return wrapped(at * FullAngle / fan.total);
  }
  const auto number = static_cast<double>(&fan - this->fans_.data());
  return at - number * BetweenFans;
}

// A direction between the segment that a turn has passed last and the one that it passes next.
double DirectionsAround::betweenSegments(
  const Fan& fan, double at, const End* first, const End* last) const
{
  const End* const next = std::upper_bound(first, last, End{ at });
  const End* const before = next != first ? next - 1 : last - 1;
  const End* const behind = next != last ? next : first;
  const double total = fan.isClosed ? fan.total : Infinity; // no turn closes an open fan
  const double turn = at - before->at + (next != first ? 0.0 : total);
  const double turnBack = behind->at - at + (next != last ? 0.0 : total);
  if (fan.isClosed && before == behind)
  {
    return wrapped(before->angle(false) + turn * FullAngle / fan.total);
  }
  if (fan.isClosed && before->isContinuedBy(*behind))
  {
    return before->angle(false) + turn * Pi / (turn + turnBack);
  }
  return turn <= turnBack ? before->angle(false) + turn : behind->angle(true) - turnBack;
}

// Angle 0 of a fan in whose first face angles are mirrored lies along the face's other edge.
DirectionsAround::Axis DirectionsAround::axis() const
{
  if (this->point_.kind != SurfacePoint::Kind::Vertex)
  {
    const Id face = TriangleMesh::faceOf(this->frames_.front().halfedge);
    return { TriangleMesh::halfedgeOf(face, 0), false };
  }
  const auto begin = std::find_if(this->frames_.begin(), this->frames_.end(),
    [this](const Frame& frame)
    {
      const double width = this->mesh_.cornerAngle(frame.halfedge);
      return frame.fan == 0 && frame.axis == (frame.isMirrored ? width : 0.0);
    });
  return begin->isMirrored ? Axis{ TriangleMesh::previousInFace(begin->halfedge), true }
                           : Axis{ begin->halfedge, false };
}

}
