// SPDX-License-Identifier: BSD-3-Clause
#include "truth/DirectionAngles.h"

#include <algorithm>
#include <cmath>

namespace geodesictest
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

Vec3 minus(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double dot(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 cross(const Vec3& a, const Vec3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vec3 unit(const Vec3& a)
{
  const double length = std::sqrt(dot(a, a));
  return { a[0] / length, a[1] / length, a[2] / length };
}

double between(const Vec3& a, const Vec3& b)
{
  const Vec3 c = cross(a, b);
  return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}

double wrapped(double angle)
{
  return std::remainder(angle, 2.0 * Pi);
}

Vec3 edgeOf(const PlainMesh& mesh, Index from, Index to)
{
  return unit(minus(mesh.points[to], mesh.points[from]));
}

std::size_t cornerWith(const Triangle& t, Index vertex)
{
  return static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin());
}

// Segments that leave a point by the same direction may be in either order.
constexpr double SameDirection = 1e-9;
constexpr double AtRightAngle = 1e-6;

/// The counterclockwise angles from a segment to a direction, and from the direction to the
/// segment.
struct Turn
{
  const SegmentAt* segment;
  double from;
  double to;
};

// Where one curve continues another, the direction belongs to the curve that the caller asks for.
bool isForward(const SegmentAt& segment, const std::vector<SegmentAt>& segments, std::size_t curve)
{
  const auto own = std::find_if(segments.begin(), segments.end(),
    [&](const SegmentAt& s) { return s.curve == curve && s.pass == segment.pass; });
  return segment.curve == curve || own == segments.end() ? segment.isForward : !own->isForward;
}

double angleBetween(bool isClosed, double total, const Turn& before, const Turn& behind,
  const std::vector<SegmentAt>& segments, std::size_t curve)
{
  const double after = isForward(*before.segment, segments, curve) ? 0.0 : -Pi;
  if (isClosed && before.segment == behind.segment)
  {
    return after + before.from * 2.0 * Pi / total;
  }
  if (isClosed && before.segment->pass == behind.segment->pass)
  {
    return after + before.from * Pi / (before.from + behind.to);
  }
  return before.from <= behind.to
    ? after + before.from
    : (isForward(*behind.segment, segments, curve) ? 0.0 : Pi) - behind.to;
}

/// The faces that have both vertices.
std::vector<Index> facesWith(const PlainMesh& mesh, Index a, Index b)
{
  std::vector<Index> faces;
  for (Index face = 0; face < mesh.triangles.size(); ++face)
  {
    const Triangle& t = mesh.triangles[face];
    if (cornerWith(t, a) < 3 && cornerWith(t, b) < 3)
    {
      faces.push_back(face);
    }
  }
  return faces;
}

/// The third vertex of a face.
Index thirdVertex(const Triangle& t, Index a, Index b)
{
  return *std::find_if(t.begin(), t.end(), [&](Index v) { return v != a && v != b; });
}

/// The face and the vertex behind an edge of two faces; the same face where there is none.
std::pair<Index, Index> behind(const PlainMesh& mesh, Index vertex, Index face, Index other)
{
  const std::vector<Index> faces = facesWith(mesh, vertex, other);
  const Index next = faces.size() != 2 ? face : faces[0] == face ? faces[1] : faces[0];
  return { next, thirdVertex(mesh.triangles[next], vertex, other) };
}

} // anonymous namespace

DirectionAngles::DirectionAngles(const PlainMesh& mesh, const MeshPoint& point)
  : mesh_(mesh)
  , point_(point)
  , firstFace_(point.face)
{
  std::vector<std::size_t> on;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (point.weights[k] != 0.0)
    {
      on.push_back(k);
    }
  }
  const Triangle& t = mesh.triangles[point.face];
  if (on.size() == 1)
  {
    this->isVertex_ = true;
    this->addFans(t[on[0]]);
    return;
  }
  this->fans_.emplace_back().isClosed = true;
  this->fans_.back().total = 2.0 * Pi;
  if (on.size() == 2)
  {
    this->isOnEdge_ = true;
    this->edge_ = edgeOf(mesh, t[on[0]], t[on[1]]);
    const std::vector<Index> faces = facesWith(mesh, t[on[0]], t[on[1]]);
    this->firstFace_ = faces.front();
    this->fans_.back().isClosed = faces.size() > 1;
    this->facesOfEdge_ = faces;
    const Vec3 third = mesh.points[thirdVertex(mesh.triangles[faces[0]], t[on[0]], t[on[1]])];
    this->middle_ = this->inFirstFace({ faces[0], minus(third, position(mesh, point)) });
  }
}

void DirectionAngles::addFans(Index vertex)
{
  std::vector<Index> known;
  for (Index face = 0; face < this->mesh_.triangles.size(); ++face)
  {
    const Triangle& t = this->mesh_.triangles[face];
    const std::size_t k = cornerWith(t, vertex);
    if (k == 3 || std::find(known.begin(), known.end(), face) != known.end())
    {
      continue;
    }
    // Clockwise to the first face, and then counterclockwise.
    Index current = face;
    Index right = t[(k + 1) % 3];
    Index left = t[(k + 2) % 3];
    Fan& fan = this->fans_.emplace_back();
    for (;;)
    {
      const auto [next, third] = behind(this->mesh_, vertex, current, right);
      if (next == current)
      {
        break;
      }
      current = next;
      left = right;
      right = third;
      if (current == face)
      {
        fan.isClosed = true;
        break;
      }
    }
    const Index first = current;
    do
    {
      known.push_back(current);
      const Triangle& c = this->mesh_.triangles[current];
      const Vec3 a = edgeOf(this->mesh_, vertex, right);
      const Vec3 b = edgeOf(this->mesh_, vertex, left);
      const double width = between(a, b);
      const bool isMirrored = c[(cornerWith(c, vertex) + 1) % 3] != right;
      fan.faces.push_back({ current, fan.total, width, isMirrored, a, b });
      fan.total += width;
      const auto [next, third] = behind(this->mesh_, vertex, current, left);
      if (next == current)
      {
        break;
      }
      current = next;
      right = left;
      left = third;
    } while (current != first);
  }
}

// In the plane of the first face, into which another face at the edge is unfolded.
double DirectionAngles::inFirstFace(const Direction& direction) const
{
  const Triangle& t = this->mesh_.triangles[this->firstFace_];
  const Vec3 x = edgeOf(this->mesh_, t[0], t[1]);
  const Vec3 normal = unit(cross(x, edgeOf(this->mesh_, t[0], t[2])));
  const Vec3 y = cross(normal, x);
  Vec3 d = direction.along;
  if (this->isOnEdge_ && direction.face != this->firstFace_)
  {
    const double along = dot(d, this->edge_);
    Vec3 across = d;
    for (std::size_t k = 0; k < 3; ++k)
    {
      across[k] -= along * this->edge_[k];
    }
    const double away = std::sqrt(dot(across, across));
    Vec3 out = cross(normal, this->edge_);
    Vec3 middle = {};
    for (const Index vertex : t)
    {
      const Vec3 toVertex = minus(this->mesh_.points[vertex], position(this->mesh_, this->point_));
      middle = { middle[0] + toVertex[0], middle[1] + toVertex[1], middle[2] + toVertex[2] };
    }
    const double side = dot(out, middle) > 0.0 ? -away : away;
    for (std::size_t k = 0; k < 3; ++k)
    {
      d[k] = along * this->edge_[k] + side * out[k];
    }
  }
  return std::atan2(dot(d, y), dot(d, x));
}

DirectionAngles::At DirectionAngles::find(const Direction& direction) const
{
  if (!this->isVertex_)
  {
    // On the boundary, the line of the edge is no place to begin.
    const double angle = this->inFirstFace(direction);
    return { 0, this->fans_[0].isClosed ? angle : wrapped(angle - this->middle_) };
  }
  for (std::size_t number = 0; number < this->fans_.size(); ++number)
  {
    for (const Face& f : this->fans_[number].faces)
    {
      if (f.face == direction.face)
      {
        const double toFirst = between(f.first, direction.along);
        const double toSecond = between(f.second, direction.along);
        const double angle = toFirst <= toSecond ? toFirst : f.width - toSecond;
        return { number, f.begin + angle };
      }
    }
  }
  return { this->fans_.size(), 0.0 };
}

bool DirectionAngles::hasFace(Index face) const
{
  if (this->isVertex_)
  {
    return this->find({ face, {} }).fan < this->fans_.size();
  }
  return face == this->firstFace_ ||
    (this->isOnEdge_ &&
      std::find(this->facesOfEdge_.begin(), this->facesOfEdge_.end(), face) !=
        this->facesOfEdge_.end());
}

double DirectionAngles::ofPoint(const Direction& direction) const
{
  const At at = this->find(direction);
  if (!this->isVertex_)
  {
    return this->inFirstFace(direction);
  }
  if (this->fans_.size() == 1 && this->fans_[0].isClosed)
  {
    return wrapped(at.angle * 2.0 * Pi / this->fans_[0].total);
  }
  double before = 0.0;
  for (std::size_t fan = 0; fan < at.fan; ++fan)
  {
    before += this->fans_[fan].total;
  }
  return before + at.angle;
}

std::vector<double> DirectionAngles::ofCurve(
  const Direction& direction, const std::vector<SegmentAt>& segments, std::size_t curve) const
{
  const At at = this->find(direction);
  const Fan& fan = this->fans_[at.fan];
  std::vector<Turn> turns;
  for (const SegmentAt& segment : segments)
  {
    const At end = this->find(segment.direction);
    if (end.fan == at.fan)
    {
      turns.push_back({ &segment, at.angle - end.angle, end.angle - at.angle });
    }
  }
  if (turns.empty())
  {
    return { this->ofPoint(direction) };
  }
  Turn least = { nullptr, 1e300, 1e300 };
  for (Turn& turn : turns)
  {
    for (double* angle : { &turn.from, &turn.to })
    {
      *angle = fan.isClosed       ? *angle - fan.total * std::floor(*angle / fan.total)
        : *angle < -SameDirection ? 1e300
                                  : *angle;
    }
    least.from = std::min(least.from, turn.from);
    least.to = std::min(least.to, turn.to);
  }
  std::vector<double> angles;
  // The rays of the segment begin there.
  if (std::abs(least.from - 0.5 * Pi) <= AtRightAngle ||
    std::abs(least.to - 0.5 * Pi) <= AtRightAngle)
  {
    angles = { -0.5 * Pi, 0.5 * Pi };
  }
  for (const Turn& before : turns)
  {
    for (const Turn& behind : turns)
    {
      if (before.from <= least.from + SameDirection && behind.to <= least.to + SameDirection)
      {
        angles.push_back(angleBetween(fan.isClosed, fan.total, before, behind, segments, curve));
      }
    }
  }
  return angles;
}

}
