// SPDX-License-Identifier: BSD-3-Clause
#include "truth/AnalyticDistances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace geodesictest
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double Pi = 3.14159265358979323846;
// How far rounding may put a point off the line it is on, relative to the size of the domain.
constexpr double OnLine = 1e-12;

Vec2 minus(const Vec2& a, const Vec2& b)
{
  return { a[0] - b[0], a[1] - b[1] };
}

double cross(const Vec2& a, const Vec2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

double dot(const Vec2& a, const Vec2& b)
{
  return a[0] * b[0] + a[1] * b[1];
}

double dot(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double size(const Vec2& a)
{
  return std::hypot(a[0], a[1]);
}

Vec2 between(const Vec2& a, const Vec2& b, double t)
{
  return { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) };
}

/// The fraction of the segment's point closest to p.
double closestFraction(const Vec2& p, const Vec2& a, const Vec2& b)
{
  const Vec2 ab = minus(b, a);
  const double length2 = dot(ab, ab);
  return length2 > 0.0 ? std::clamp(dot(minus(p, a), ab) / length2, 0.0, 1.0) : 0.0;
}

}

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b)
{
  return size(minus(p, between(a, b, closestFraction(p, a, b))));
}

//----------------------------------------------------------------------------
namespace
{

/// The box with its faces rolled one after the other onto the plane.
class BoxRoller
{
public:
  BoxRoller(const Vec3& boxSize, const Vec3& a, const Vec3& b)
    : size_(boxSize)
    , a_(a)
    , b_(b)
  {
  }

  double distanceFrom(const Vec3& p)
  {
    this->best_ = Infinite;
    for (Index face = 0; face < 6; ++face)
    {
      const Index axis = face / 2;
      if (p[axis] == this->border(face))
      {
        // Any isometry of the first face will do: p at the origin, two axes as they are.
        Placement start;
        start.origin = p;
        start.image = { 0.0, 0.0 };
        start.axes[(axis + 1) % 3] = { 1.0, 0.0 };
        start.axes[(axis + 2) % 3] = { 0.0, 1.0 };
        this->visited_.assign(6, false);
        this->roll(face, start);
      }
    }
    return this->best_;
  }

private:
  /// Where a face lies in the plane: the image of one of its points and of the coordinate axes.
  struct Placement
  {
    Vec3 origin;
    Vec2 image;
    std::array<Vec2, 3> axes{};

    Vec2 operator()(const Vec3& x) const
    {
      Vec2 y = this->image;
      for (Index k = 0; k < 3; ++k)
      {
        y[0] += (x[k] - this->origin[k]) * this->axes[k][0];
        y[1] += (x[k] - this->origin[k]) * this->axes[k][1];
      }
      return y;
    }
  };

  double border(Index face) const { return face % 2 == 0 ? 0.0 : this->size_[face / 2]; }

  /// Whether the line from the origin to y crosses every edge that was rolled over.
  bool passes(const Vec2& y) const
  {
    const double slack = OnLine * (this->size_[0] + this->size_[1] + this->size_[2]);
    const double length = size(y);
    if (length <= slack)
    {
      return true;
    }
    for (const auto& [a, b] : this->crossed_)
    {
      const double sideA = cross(y, a) / length;
      const double sideB = cross(y, b) / length;
      const bool touches = std::abs(sideA) <= slack || std::abs(sideB) <= slack;
      if (!touches && (sideA > 0.0) == (sideB > 0.0))
      {
        return false;
      }
      const double t = sideA != sideB ? std::clamp(sideA / (sideA - sideB), 0.0, 1.0) : 0.0;
      const double along = dot(between(a, b, t), y) / length;
      if (along < -slack || along > length + slack)
      {
        return false;
      }
    }
    return true;
  }

  void tryTarget(Index face, const Placement& place)
  {
    const Index axis = face / 2;
    if (this->a_[axis] != this->border(face) || this->b_[axis] != this->border(face))
    {
      return;
    }
    const Vec2 a = place(this->a_);
    const Vec2 b = place(this->b_);
    const Vec2 foot = between(a, b, closestFraction({ 0.0, 0.0 }, a, b));
    for (const Vec2& y : { a, b, foot })
    {
      if (this->passes(y))
      {
        this->best_ = std::min(this->best_, size(y));
      }
    }
  }

  void roll(Index face, const Placement& place)
  {
    this->visited_[face] = true;
    this->tryTarget(face, place);
    for (Index next = 0; next < 6; ++next)
    {
      const Index axis = face / 2;
      const Index nextAxis = next / 2;
      if (nextAxis == axis || this->visited_[next])
      {
        continue;
      }
      Vec3 corner = place.origin;
      corner[axis] = this->border(face);
      corner[nextAxis] = this->border(next);
      Vec3 other = corner;
      const Index along = 3 - axis - nextAxis;
      corner[along] = 0.0;
      other[along] = this->size_[along];
      Placement nextPlace = place;
      nextPlace.origin = corner;
      nextPlace.image = place(corner);
      // Going on past the edge is going inwards along the axis of the face just left.
      const double sign = (face % 2 == 0) == (next % 2 == 0) ? -1.0 : 1.0;
      nextPlace.axes[axis] = { sign * place.axes[nextAxis][0], sign * place.axes[nextAxis][1] };
      nextPlace.axes[nextAxis] = { 0.0, 0.0 };
      this->crossed_.push_back({ place(corner), place(other) });
      this->roll(next, nextPlace);
      this->crossed_.pop_back();
    }
    this->visited_[face] = false;
  }

  Vec3 size_;
  Vec3 a_;
  Vec3 b_;
  std::vector<std::pair<Vec2, Vec2>> crossed_;
  std::vector<bool> visited_;
  double best_ = Infinite;
};

}

double boxDistance(const Vec3& boxSize, const Vec3& p, const Vec3& a, const Vec3& b)
{
  return BoxRoller(boxSize, a, b).distanceFrom(p);
}

//----------------------------------------------------------------------------
double prismDistance(double perimeter, const Vec2& p, const Vec2& a, const Vec2& b)
{
  double best = Infinite;
  for (double shift : { -perimeter, 0.0, perimeter })
  {
    best = std::min(best, distanceToSegment(p, { a[0] + shift, a[1] }, { b[0] + shift, b[1] }));
  }
  return best;
}

//----------------------------------------------------------------------------
double coneDistance(double totalAngle, const Polar& p, const Polar& a, const Polar& b)
{
  const auto place = [&p](const Polar& x, double shift) -> Vec2
  {
    const double angle = x.angle - p.angle + shift;
    return { x.radius * std::cos(angle), x.radius * std::sin(angle) };
  };
  const Vec2 flatA = place(a, p.angle - a.angle);
  const Vec2 flatB = place(b, p.angle - a.angle);
  double best = p.radius + distanceToSegment({ 0.0, 0.0 }, flatA, flatB);
  for (int turn = -2; turn <= 2; ++turn)
  {
    const double shift = turn * totalAngle;
    const double lowest = std::min(a.angle, b.angle) - p.angle + shift;
    const double highest = std::max(a.angle, b.angle) - p.angle + shift;
    const Vec2 here = { p.radius, 0.0 };
    if (lowest >= -Pi && highest <= Pi)
    {
      best = std::min(best, distanceToSegment(here, place(a, shift), place(b, shift)));
    }
    else if (lowest < Pi && highest > -Pi)
    {
      // Part of the segment is behind the apex: cut it off along the line through the apex.
      const Vec2 qa = place(a, shift);
      const Vec2 qb = place(b, shift);
      const double cut = qa[1] / (qa[1] - qb[1]);
      const bool keepA = std::abs(a.angle - p.angle + shift) <= Pi;
      const Vec2 middle = between(qa, qb, std::clamp(cut, 0.0, 1.0));
      best = std::min(best, distanceToSegment(here, keepA ? qa : qb, middle));
    }
  }
  return best;
}

Polar fanCoordinates(
  Index sectors, double angle, Index n, const PlainMesh& mesh, const MeshPoint& p)
{
  const Index sector = std::min(p.face / (n * n), sectors - 1);
  const Vec3& apex = mesh.points[0];
  // Corner 0 of a sector's first face is the apex, corners 1 and 2 are on the sector's legs.
  const Triangle& first = mesh.triangles[sector * n * n];
  const Vec3 x = position(mesh, p);
  Vec3 leg{};
  Vec3 otherLeg{};
  Vec3 arm{};
  for (Index k = 0; k < 3; ++k)
  {
    leg[k] = n * (mesh.points[first[1]][k] - apex[k]);
    otherLeg[k] = n * (mesh.points[first[2]][k] - apex[k]);
    arm[k] = x[k] - apex[k];
  }
  const double along = dot(arm, leg);
  const double across = (dot(arm, otherLeg) - along * std::cos(angle)) / std::sin(angle);
  return { std::hypot(along, across), sector * angle + std::atan2(across, along) };
}

//----------------------------------------------------------------------------
Vec2 tetrahedronCoordinates(Index tetrahedronFace, const Vec3& x)
{
  // Corners 0, 1, 2, 3 have the lattice classes (even, even), (odd, even), (even, odd), (odd, odd);
  // each face is placed on one triangle of the lattice with its classes.
  static const std::array<std::array<Vec2, 4>, 4> places = { {
    { { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } } },
    { { { 0, 2 }, { 0, 0 }, { 0, 1 }, { 1, 1 } } },
    { { { 2, 0 }, { 1, 0 }, { 0, 0 }, { 1, 1 } } },
    { { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 } } },
  } };
  const std::array<Vec3, 4> corners = tetrahedronCorners();
  Vec2 lattice = { 0.0, 0.0 };
  for (Index k = 0; k < 4; ++k)
  {
    if (k == tetrahedronFace)
    {
      continue;
    }
    // The corners are at right angles to the opposite faces: x . c_k = 3/8 w_k - 1/8 (1 - w_k).
    const double weight = 2.0 * dot(x, corners[k]) + 0.25;
    lattice[0] += weight * places[tetrahedronFace][k][0];
    lattice[1] += weight * places[tetrahedronFace][k][1];
  }
  return lattice;
}

double tetrahedronDistance(const Vec2& p, const Vec2& a, const Vec2& b)
{
  const auto place = [](double i, double j) -> Vec2 {
    return { i + 0.5 * j, std::sqrt(0.75) * j };
  };
  double best = Infinite;
  for (double sign : { -1.0, 1.0 })
  {
    for (int i = -6; i <= 6; i += 2)
    {
      for (int j = -6; j <= 6; j += 2)
      {
        best = std::min(best,
          distanceToSegment(place(p[0], p[1]), place(sign * a[0] + i, sign * a[1] + j),
            place(sign * b[0] + i, sign * b[1] + j)));
      }
    }
  }
  return best;
}

//----------------------------------------------------------------------------
PlanarDomain::PlanarDomain(std::vector<std::pair<Vec2, Vec2>> edges)
  : edges_(std::move(edges))
{
  std::set<Vec2> corners;
  for (const auto& edge : this->edges_)
  {
    corners.insert(edge.first);
    corners.insert(edge.second);
    this->size_ = std::max({ this->size_, size(edge.first), size(edge.second) });
  }
  this->corners_.assign(corners.begin(), corners.end());
}

/// Inside or on the outline.
bool PlanarDomain::isInside(const Vec2& p) const
{
  bool inside = false;
  for (const auto& [a, b] : this->edges_)
  {
    if (distanceToSegment(p, a, b) <= OnLine * this->size_)
    {
      return true;
    }
    if ((a[1] > p[1]) != (b[1] > p[1]) &&
      p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
    {
      inside = !inside;
    }
  }
  return inside;
}

/// Cuts the line where it meets an edge; it is clear if the middle of each piece is inside.
bool PlanarDomain::isVisible(const Vec2& p, const Vec2& q) const
{
  const double slack = OnLine * this->size_;
  const Vec2 pq = minus(q, p);
  const double length = size(pq);
  if (length <= slack)
  {
    return true;
  }
  std::vector<double> cuts = { 0.0, 1.0 };
  for (const auto& [a, b] : this->edges_)
  {
    const double sideA = cross(pq, minus(a, p)) / length;
    const double sideB = cross(pq, minus(b, p)) / length;
    for (const auto& [corner, side] : { std::pair(a, sideA), std::pair(b, sideB) })
    {
      if (std::abs(side) <= slack)
      {
        cuts.push_back(dot(minus(corner, p), pq) / (length * length));
      }
    }
    if ((sideA > slack && sideB < -slack) || (sideA < -slack && sideB > slack))
    {
      const Vec2 x = between(a, b, sideA / (sideA - sideB));
      cuts.push_back(dot(minus(x, p), pq) / (length * length));
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    if (cuts[i - 1] < 0.0 || cuts[i] > 1.0 || (cuts[i] - cuts[i - 1]) * length <= 2.0 * slack)
    {
      continue;
    }
    if (!this->isInside(between(p, q, 0.5 * (cuts[i - 1] + cuts[i]))))
    {
      return false;
    }
  }
  return true;
}

/// To the closest point of the segment or to one of its ends, where it can be seen. If the closest
/// visible point is another one, the line to it touches a corner, and the graph has that way.
double PlanarDomain::visibleDistance(const Vec2& p, const Vec2& a, const Vec2& b) const
{
  double best = Infinite;
  for (const Vec2& q : { between(a, b, closestFraction(p, a, b)), a, b })
  {
    const double length = size(minus(p, q));
    if (length < best && this->isVisible(p, q))
    {
      best = length;
    }
  }
  return best;
}

std::vector<double> PlanarDomain::distances(
  const Vec2& a, const Vec2& b, const std::vector<Vec2>& points) const
{
  const std::size_t n = this->corners_.size();
  std::vector<double> atCorner;
  for (const Vec2& corner : this->corners_)
  {
    atCorner.push_back(this->visibleDistance(corner, a, b));
  }
  std::vector<bool> done(n, false);
  for (std::size_t round = 0; round < n; ++round)
  {
    std::size_t next = n;
    for (std::size_t i = 0; i < n; ++i)
    {
      if (!done[i] && (next == n || atCorner[i] < atCorner[next]))
      {
        next = i;
      }
    }
    done[next] = true;
    for (std::size_t i = 0; i < n; ++i)
    {
      const double through = atCorner[next] + size(minus(this->corners_[i], this->corners_[next]));
      if (through < atCorner[i] && this->isVisible(this->corners_[i], this->corners_[next]))
      {
        atCorner[i] = through;
      }
    }
  }
  std::vector<double> result;
  for (const Vec2& p : points)
  {
    double best = this->visibleDistance(p, a, b);
    for (std::size_t i = 0; i < n; ++i)
    {
      const double through = atCorner[i] + size(minus(p, this->corners_[i]));
      if (through < best && this->isVisible(p, this->corners_[i]))
      {
        best = through;
      }
    }
    result.push_back(best);
  }
  return result;
}

PlanarDomain planarDomain(const PlainMesh& mesh)
{
  std::vector<std::pair<Vec2, Vec2>> edges;
  for (const auto& edge : boundaryEdges(mesh))
  {
    const Vec3& a = mesh.points[edge.first];
    const Vec3& b = mesh.points[edge.second];
    edges.push_back({ Vec2{ a[0], a[1] }, Vec2{ b[0], b[1] } });
  }
  return PlanarDomain(std::move(edges));
}

}
