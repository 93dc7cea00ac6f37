// SPDX-License-Identifier: BSD-3-Clause
#include "source/FanAround.h"

#include "Trigonometry.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// A gap: rounding at the end of a fan must not lead into the next one.
constexpr double BetweenFans = 1.0;

/// In (-pi, pi].
double wrapped(double angle)
{
  const double turns = std::ceil((angle - Pi) / FullAngle);
  return std::clamp(angle - turns * FullAngle, -Pi, Pi);
}

/// The angle of a direction in a face from the halfedge whose frame it is in. Rounding may put the
/// direction of a halfedge slightly below the x axis.
double angleInFace(Vec2 direction)
{
  const double angle = polarAngle(direction);
  return angle < -RightAngle ? angle + FullAngle : angle;
}

} // anonymous namespace

FanAround::FanAround(const TriangleMesh& mesh, const PointOfSource& at)
  : mesh_(mesh)
  , kind_(at.place.kind)
  , own_{ at.point, false }
{
  const auto addFace = [this](const SurfacePoint& point, Id face)
  {
    if (!this->hasFace(face))
    {
      this->addFan(point, face);
    }
  };
  forEachFace(mesh, at.place, [&](Id face) { addFace(at.place, face); });
  for (const SegmentEnd& end : at.ends)
  {
    addFace(end.from, end.face);
  }
  for (const SegmentEnd& end : at.ends)
  {
    this->addEnd(end);
  }
  std::stable_sort(this->ends_.begin(), this->ends_.end());
  this->findChanges();
}

void FanAround::addFan(const SurfacePoint& point, Id face)
{
  switch (point.kind)
  {
    case SurfacePoint::Kind::Face:
      this->addSector(longestHalfedge(this->mesh_, face), this->begin_, FullAngle, false);
      this->closeFan(FullAngle, true);
      break;
    case SurfacePoint::Kind::Edge:
      this->addFanOfEdge(this->mesh_.edgeOf(point.id));
      break;
    case SurfacePoint::Kind::Vertex:
      this->addFanOfVertex(this->mesh_.cornerAt(face, point.id));
      break;
  }
}

// The other faces of an edge of three and more all lie at the same angles.
void FanAround::addFanOfEdge(Id halfedge)
{
  const bool isOfOnePart = this->mesh_.acrossOriented(halfedge) != NoId;
  Id s = halfedge;
  do
  {
    const bool isMirrored = s != halfedge && this->mesh_.origin(s) == this->mesh_.origin(halfedge);
    if (!isOfOnePart)
    {
      this->addWall();
    }
    const double axis = s == halfedge ? 0.0 : isMirrored ? FullAngle : Pi;
    this->addSector(s, this->begin_ + axis, Pi, isMirrored);
    s = this->mesh_.nextSibling(s);
  } while (s != halfedge);
  const bool isClosed = !this->mesh_.isBoundary(halfedge);
  if (this->fans_.empty())
  {
    const Id firstOfFace = TriangleMesh::halfedgeOf(TriangleMesh::faceOf(halfedge), 0);
    this->toAxis_ = polarAngle(turned(this->mesh_, { 1.0, 0.0 }, halfedge, firstOfFace));
  }
  this->closeFan(isClosed ? FullAngle : Pi, isClosed);
}

// Clockwise to where the fan begins, or once around; then counterclockwise to its end.
void FanAround::addFanOfVertex(Id corner)
{
  const Id vertex = this->mesh_.origin(corner);
  Stop begin = { corner, false };
  bool isClosed = false;
  for (Stop stop = this->beside(vertex, begin, true); stop.corner != NoId && !isClosed;
       stop = this->beside(vertex, stop, true))
  {
    isClosed = stop.corner == corner;
    begin = stop;
  }
  double angle = this->begin_;
  Stop before = this->beside(vertex, begin, true);
  Stop stop = begin;
  do
  {
    if (before.corner == NoId || before.isMirrored != stop.isMirrored)
    {
      this->addWall();
    }
    const double width = this->mesh_.cornerAngle(stop.corner);
    this->addSector(stop.corner, stop.isMirrored ? angle + width : angle, width, stop.isMirrored);
    angle += width;
    before = stop;
    stop = this->beside(vertex, stop, false);
  } while (stop.corner != NoId && stop.corner != begin.corner);
  this->closeFan(angle - this->begin_, isClosed);
}

// Angle 0 of a fan in whose first face angles are mirrored lies along the face's other edge.
void FanAround::addSector(Id halfedge, double axis, double width, bool isMirrored)
{
  const Id face = TriangleMesh::faceOf(halfedge);
  if (this->sectors_.empty())
  {
    this->axis_ = this->kind_ != SurfacePoint::Kind::Vertex
      ? Axis{ TriangleMesh::halfedgeOf(face, 0), false }
      : Axis{ isMirrored ? TriangleMesh::previousInFace(halfedge) : halfedge, isMirrored };
  }
  this->sectors_.emplace(
    face, Sector{ halfedge, axis, width, isMirrored, this->fans_.size(), this->part_ });
}

void FanAround::addWall()
{
  ++this->part_;
  this->borders_.push_back(
    { { this->fans_.size(), this->part_, -Infinity }, this->own_, this->own_ });
}

void FanAround::closeFan(double total, bool isClosed)
{
  const bool hasWalls = !this->borders_.empty() && this->borders_.back().fan == this->fans_.size();
  this->fans_.push_back({ this->begin_, total, isClosed, hasWalls });
  this->begin_ = this->begin_ + total + BetweenFans;
}

// In a mirrored face a walk comes across the edges in the opposite order.
FanAround::Stop FanAround::beside(Id vertex, const Stop& stop, bool isClockwise) const
{
  const Id edge =
    stop.isMirrored == isClockwise ? TriangleMesh::previousInFace(stop.corner) : stop.corner;
  if (!this->mesh_.isInner(edge))
  {
    return {};
  }
  const EnteredCorner entered(this->mesh_, vertex, this->mesh_.nextSibling(edge));
  return { entered.corner, (entered.onward != entered.corner) == isClockwise };
}

// The counterclockwise side of a segment that begins here is its left side.
void FanAround::addEnd(const SegmentEnd& end)
{
  const Sector& sector = this->sectors_.at(end.face);
  this->borders_.push_back(
    { { sector.fan, sector.part,
        this->sideAngle(sector, directionIn(this->mesh_, end, sector.halfedge)) },
      { end.point, end.isBeginning != sector.isMirrored },
      { end.point, end.isBeginning == sector.isMirrored } });

  const Id longest = longestHalfedge(this->mesh_, end.face);
  const double angle = this->angleOf(longest, directionIn(this->mesh_, end, longest));
  this->ends_.push_back({ this->fans_[sector.fan].at(angle), end.point, end.isBeginning });
}

// At the segments themselves, and in the middle between consecutive ones.
void FanAround::findChanges()
{
  std::stable_sort(this->borders_.begin(), this->borders_.end());
  std::size_t first = 0; // of the fan
  for (std::size_t i = 0; i < this->borders_.size(); ++i)
  {
    const Border& border = this->borders_[i];
    const Fan& fan = this->fans_[border.fan];
    first = this->borders_[first].fan == border.fan ? first : i;
    const bool isLast = i + 1 == this->borders_.size() || this->borders_[i + 1].fan != border.fan;
    const Border& next = this->borders_[isLast ? first : i + 1];
    if (border.isWall())
    {
      continue;
    }
    this->changes_.push_back(border);
    if (!next.isWall() && border.behind != next.before)
    {
      const double nextAngle = next.angle + (isLast ? fan.total : 0.0);
      const double middle = 0.5 * (border.angle + nextAngle);
      const bool isInNextTurn = isLast && !(middle < fan.begin + fan.total);
      this->changes_.push_back({ border.fan, isInNextTurn ? next.part : border.part,
        isInNextTurn ? middle - fan.total : middle });
    }
  }
  std::sort(this->changes_.begin(), this->changes_.end());
}

double FanAround::angleOf(Id halfedge, Vec2 direction) const
{
  const Id face = TriangleMesh::faceOf(halfedge);
  const Sector& sector = this->sectors_.at(face);
  const bool isInside = sector.width == FullAngle; // angles count from the face's first edge
  const Id axis = isInside ? TriangleMesh::halfedgeOf(face, 0) : sector.halfedge;
  return sector.angleAt(angleInFace(turned(this->mesh_, direction, halfedge, axis)));
}

double FanAround::turn(double from, double to) const
{
  const Fan& fan = this->fanOf(from);
  const double turn = to - from;
  return fan.isClosed ? turn - fan.total * std::floor(turn / fan.total + 0.5) : turn;
}

const FanAround::Fan& FanAround::fanOf(double angle) const
{
  const auto next = std::find_if(this->fans_.begin() + 1, this->fans_.end(),
    [angle](const Fan& fan) { return angle < fan.begin - 0.5 * BetweenFans; });
  return *(next - 1);
}

double FanAround::angleFromCurve(double angle) const
{
  const Fan& fan = this->fanOf(angle);
  const double at = fan.at(angle);
  const auto first = std::lower_bound(this->ends_.begin(), this->ends_.end(), End{ fan.begin });
  const auto last = std::upper_bound(first, this->ends_.end(), End{ fan.begin + fan.total });
  return first == last ? this->withoutSegments(fan, at)
                       : this->betweenSegments(fan, at, &*first, &*first + (last - first));
}

// The angles of a single closed fan are scaled. Several fans follow one another.
double FanAround::withoutSegments(const Fan& fan, double at) const
{
  if (this->kind_ != SurfacePoint::Kind::Vertex)
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
double FanAround::betweenSegments(
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

/// The angle of a direction, in the frame of the sector's halfedge, among borders.
double FanAround::sideAngle(const Sector& sector, Vec2 direction) const
{
  const double angle = sector.angleAt(angleInFace(direction));
  const Fan& fan = this->fans_[sector.fan];
  return fan.hasWalls ? angle : fan.at(angle);
}

SideOfCurve FanAround::sideOf(Id halfedge, Vec2 direction) const
{
  const auto found = this->sectors_.find(TriangleMesh::faceOf(halfedge));
  if (found == this->sectors_.end() || !(dot(direction, direction) > 0.0))
  {
    return this->own_;
  }
  const Sector& sector = found->second;
  const double angle =
    this->sideAngle(sector, turned(this->mesh_, direction, halfedge, sector.halfedge));
  const FanAngle at = { sector.fan, sector.part, angle };
  const auto isOfEarlierFan = [](const Border& border, std::size_t fan)
  { return border.fan < fan; };
  const auto first =
    std::lower_bound(this->borders_.begin(), this->borders_.end(), sector.fan, isOfEarlierFan);
  const auto last = std::lower_bound(first, this->borders_.end(), sector.fan + 1, isOfEarlierFan);
  if (first == last)
  {
    return this->own_;
  }
  // The borders on both sides of the direction, across the beginning of a closed fan.
  const auto next = std::upper_bound(first, last, at);
  const Border& before = next != first ? *(next - 1) : *(last - 1);
  const Border& behind = next != last ? *next : *first;
  if (before.isWall() || behind.isWall())
  {
    return behind.isWall() ? before.behind : behind.before;
  }
  const double total = this->fans_[sector.fan].total;
  const double turn = angle - before.angle + (next != first ? 0.0 : total);
  const double turnBack = behind.angle - angle + (next != last ? 0.0 : total);
  return turn <= turnBack ? before.behind : behind.before;
}

std::vector<Vec2> FanAround::sideChangesIn(Id halfedge) const
{
  std::vector<Vec2> changes;
  const auto found = this->sectors_.find(TriangleMesh::faceOf(halfedge));
  if (found == this->sectors_.end())
  {
    return changes;
  }
  const Sector& sector = found->second;
  const Fan& fan = this->fans_[sector.fan];
  for (int turns = 0; turns < (fan.hasWalls ? 1 : 2); ++turns)
  {
    const double axis = sector.axis - turns * fan.total;
    const double begin = sector.isMirrored ? axis - sector.width : axis;
    for (auto change = std::lower_bound(this->changes_.begin(), this->changes_.end(),
           FanAngle{ sector.fan, sector.part, begin });
         change != this->changes_.end() && change->fan == sector.fan &&
         change->part == sector.part && change->angle <= begin + sector.width;
         ++change)
    {
      const double turn = sector.isMirrored ? axis - change->angle : change->angle - axis;
      changes.push_back(turned(this->mesh_, unitVector(turn), sector.halfedge, halfedge));
    }
  }
  return changes;
}

}
