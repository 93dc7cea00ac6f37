// SPDX-License-Identifier: BSD-3-Clause
#include "truth/PlaneEnds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodesictest
{

namespace
{

constexpr double Pi = 3.14159265358979323846;
/// Lengths that differ by less may be either's.
constexpr double SameLength = 1e-9;
/// Two paths are as long to the engine, relative to their length and the mesh.
constexpr double Tie = 1e-12;

Vec3 crossProduct(const Vec3& a, const Vec3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// Counterclockwise, in [0, 2 pi).
double turn(const Vec3& from, const Vec3& to, const Vec3& normal)
{
  const double angle = std::atan2(dotProduct(crossProduct(from, to), normal), dotProduct(from, to));
  return angle < 0.0 ? angle + 2.0 * Pi : angle;
}

/// The nearest point of a segment, or of a point given twice: how far along it is, and its place.
struct OnSegment
{
  double along;
  double length;
  Vec3 place;
};

OnSegment nearestOn(const Vec3& a, const Vec3& b, const Vec3& place)
{
  const Vec3 ab = minus(b, a);
  const double square = dotProduct(ab, ab);
  const double t =
    square > 0.0 ? std::clamp(dotProduct(minus(place, a), ab) / square, 0.0, 1.0) : 0.0;
  const double length = std::sqrt(square);
  return { t * length, length,
    t < 1.0 ? Vec3{ a[0] + t * ab[0], a[1] + t * ab[1], a[2] + t * ab[2] } : b };
}

/// Around a point of a line: 0 ahead, pi back on the left and -pi on the right, each side scaled;
/// at an end of the line simply from the line's direction.
double angleAround(
  const std::vector<Vec3>& line, std::size_t i, const Vec3& away, const Vec3& normal)
{
  const std::size_t last = line.size() - 1;
  const bool isClosed = spaceDistance(line.front(), line.back()) < SameLength;
  const auto along = [&](std::size_t segment) { return minus(line[segment + 1], line[segment]); };
  if (!isClosed && (i == 0 || i == last))
  {
    return std::remainder(turn(along(std::min(i, last - 1)), away, normal), 2.0 * Pi);
  }
  const Vec3 ahead = along(i < last ? i : 0);
  const Vec3 behind = along(i > 0 ? i - 1 : last - 1);
  const double toAway = turn(ahead, away, normal);
  const double left = turn(ahead, { -behind[0], -behind[1], -behind[2] }, normal);
  return toAway < left ? Pi * toAway / left : -Pi * (2.0 * Pi - toAway) / (2.0 * Pi - left);
}

} // anonymous namespace

Vec3 minus(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double dotProduct(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double angleIn(const PlainFrame& frame, const Vec3& v)
{
  return std::atan2(dotProduct(v, frame.y), dotProduct(v, frame.x));
}

double gapOfAngles(double a, double b)
{
  return std::abs(std::remainder(a - b, 2.0 * Pi));
}

PlaneEnds::PlaneEnds(const PlainMesh& mesh, const std::vector<Polyline>& sources, bool bends)
{
  for (const Polyline& source : sources)
  {
    Line line = { position(mesh, { source.segments[0].face, source.segments[0].from }) };
    for (const MeshSegment& s : source.segments)
    {
      if (!source.isPoint())
      {
        line.push_back(position(mesh, { s.face, s.to }));
      }
    }
    this->lines_.push_back(line);
  }
  for (const Vec3& vertex : mesh.points)
  {
    this->size_ = std::max(this->size_, spaceDistance(vertex, mesh.points[0]));
  }
  if (bends)
  {
    this->vertices_ = mesh.points;
    const std::vector<PlainFrame> anyFrames(sources.size());
    for (const Vec3& vertex : mesh.points)
    {
      this->toVertices_.push_back(this->straight(vertex, anyFrames).front().length);
    }
  }
}

std::vector<TrueEnd> PlaneEnds::of(const Vec3& place, const std::vector<PlainFrame>& frames) const
{
  std::vector<TrueEnd> ends = this->straight(place, frames);
  const double length = ends.front().length;
  const double size = length + this->size_;
  for (std::size_t v = 0; v < this->vertices_.size(); ++v)
  {
    const double toVertex = this->toVertices_[v];
    if (toVertex + spaceDistance(this->vertices_[v], place) <= length + 2.0 * Tie * size)
    {
      for (TrueEnd end : this->straight(this->vertices_[v], frames))
      {
        end.length = length;
        end.slack = 2.0 * std::numeric_limits<double>::epsilon() * size / toVertex;
        ends.push_back(end);
      }
    }
  }
  return ends;
}

std::vector<TrueEnd> PlaneEnds::straight(
  const Vec3& place, const std::vector<PlainFrame>& frames) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Line& line : this->lines_)
  {
    for (std::size_t i = 0; i + 1 < std::max<std::size_t>(line.size(), 2); ++i)
    {
      const OnSegment foot = nearestOn(line[i], line[std::min(i + 1, line.size() - 1)], place);
      least = std::min(least, spaceDistance(place, foot.place));
    }
  }
  std::vector<TrueEnd> ends;
  for (Index source = 0; source < this->lines_.size(); ++source)
  {
    this->addStraight(source, place, frames[source], least + SameLength, ends);
  }
  for (TrueEnd& end : ends)
  {
    end.length = least;
  }
  return ends;
}

void PlaneEnds::addStraight(Index source, const Vec3& place, const PlainFrame& frame,
  double longest, std::vector<TrueEnd>& ends) const
{
  const Line& line = this->lines_[source];
  double before = 0.0;
  if (line.size() == 1 && spaceDistance(place, line[0]) <= longest)
  {
    ends.push_back(
      { source, 0.0, 0.0, angleIn(frame, minus(place, line[0])), 0.0, false, line[0] });
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const OnSegment foot = nearestOn(line[i], line[i + 1], place);
    const Vec3 away = minus(place, foot.place);
    const double length = std::sqrt(dotProduct(away, away));
    if (length <= longest)
    {
      const Vec3 along = minus(line[i + 1], line[i]);
      const bool isAtBegin = foot.along <= SameLength;
      const bool isAtEnd = foot.length - foot.along <= SameLength;
      const auto add = [&](double angle)
      {
        ends.push_back(
          { source, 0.0, before + foot.along, angle, 0.0, !isAtBegin && !isAtEnd, foot.place });
      };
      // A ray at a right angle to a segment's end is the segment's or the point's. Without length
      // it has no direction.
      if (length <= SameLength ||
        std::abs(dotProduct(along, away)) <= SameLength * foot.length * length)
      {
        const double side = dotProduct(crossProduct(along, away), frame.normal);
        add(std::copysign(0.5 * Pi, side));
      }
      if (isAtBegin || isAtEnd)
      {
        add(angleAround(line, isAtBegin ? i : i + 1, away, frame.normal));
      }
    }
    before += foot.length;
  }
}

}
