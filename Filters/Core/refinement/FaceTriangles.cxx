// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/FaceTriangles.h"

#include "Tolerance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geodesic
{

FaceTriangles::FaceTriangles(
  Id face, const std::array<Point, 3>& corners, const std::array<Side, 3>& sides)
  : face_(face)
  , points_(corners.begin(), corners.end())
  , sides_(sides)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->points_[k].sides = static_cast<std::uint8_t>((1U << k) | (1U << ((k + 2) % 3)));
  }
  this->parts_.push_back({ { 0, 1, 2 } });
  this->changed_.push_back(0);
}

std::array<Vec2, 3> FaceTriangles::places(const Triangle& c) const
{
  return { this->points_[c[0]].place, this->points_[c[1]].place, this->points_[c[2]].place };
}

std::size_t FaceTriangles::sideWith(Id a, Id b) const
{
  const unsigned both = this->points_[a].sides & this->points_[b].sides;
  return (both & 1U) != 0 ? 0 : (both & 2U) != 0 ? 1 : (both & 4U) != 0 ? 2 : 3;
}

bool FaceTriangles::isTriangle(const Triangle& c) const
{
  const Point& a = this->points_[c[0]];
  const Point& b = this->points_[c[1]];
  const Point& d = this->points_[c[2]];
  if ((a.sides & b.sides & d.sides) != 0)
  {
    return false;
  }
  // In barycentric coordinates a needle is as wide as any other face.
  const Vec2 toB = { b.weights[1] - a.weights[1], b.weights[2] - a.weights[2] };
  const Vec2 toD = { d.weights[1] - a.weights[1], d.weights[2] - a.weights[2] };
  const double size = std::abs(toB.x) + std::abs(toB.y) + std::abs(toD.x) + std::abs(toD.y);
  return cross(toB, toD) > tolerance::PlaceRounding * size;
}

Id FaceTriangles::addPoint(const Point& point)
{
  this->points_.push_back(point);
  this->pointsForShapes_ += point.isForShape ? 1 : 0;
  return static_cast<Id>(this->points_.size()) - 1;
}

void FaceTriangles::change(Id part)
{
  Part& p = this->parts_[part];
  ++p.version;
  p.bound = Infinity;
  this->changed_.push_back(part);
}

std::size_t FaceTriangles::sideTo(Id part, Id other) const
{
  const std::array<Id, 3>& across = this->parts_[part].across;
  return across[0] == other ? 0 : across[1] == other ? 1 : 2;
}

// Tells a part that what was one triangle across a side is another one now.
void FaceTriangles::relink(Id part, Id before, Id now)
{
  if (part != NoId)
  {
    this->parts_[part].across[this->sideTo(part, before)] = now;
  }
}

Id FaceTriangles::split(Id part, std::size_t k, Id point)
{
  const auto halve = [&](Id t, std::size_t side)
  {
    const std::size_t next = (side + 1) % 3;
    const Id added = this->numberOfParts();
    Part other = this->parts_[t];
    other.corners[side] = point;
    other.across[(side + 2) % 3] = t;
    this->parts_.push_back(other);
    this->relink(other.across[next], t, added);
    this->parts_[t].corners[next] = point;
    this->parts_[t].across[next] = added;
    this->change(t);
    this->change(added);
    return added;
  };
  const Id opposite = this->parts_[part].across[k];
  const std::size_t j = opposite == NoId ? 0 : this->sideTo(opposite, part);
  const Id added = halve(part, k);
  if (opposite != NoId)
  {
    // Each half is across from the one that was added on the other side.
    const Id addedThere = halve(opposite, j);
    this->parts_[part].across[k] = addedThere;
    this->parts_[addedThere].across[j] = part;
    this->parts_[added].across[k] = opposite;
    this->parts_[opposite].across[j] = added;
  }
  return added;
}

std::array<Triangle, 2> FaceTriangles::flipped(Id part, std::size_t k) const
{
  const Triangle& c = this->parts_[part].corners;
  const Id other = this->parts_[part].across[k];
  const Id apex = this->parts_[other].corners[(this->sideTo(other, part) + 2) % 3];
  return { { { c[k], apex, c[(k + 2) % 3] }, { apex, c[(k + 1) % 3], c[(k + 2) % 3] } } };
}

void FaceTriangles::flip(Id part, std::size_t k)
{
  const Id other = this->parts_[part].across[k];
  const std::size_t j = this->sideTo(other, part);
  Part& t = this->parts_[part];
  Part& o = this->parts_[other];
  const std::size_t kNext = (k + 1) % 3;
  const std::size_t jNext = (j + 1) % 3;
  t.corners[kNext] = o.corners[(j + 2) % 3];
  o.corners[jNext] = t.corners[(k + 2) % 3];
  t.across[k] = o.across[jNext];
  o.across[j] = t.across[kNext];
  t.across[kNext] = other;
  o.across[jNext] = part;
  this->relink(t.across[k], other, part);
  this->relink(o.across[j], part, other);
  this->change(part);
  this->change(other);
}

// Whether the apex across side k lies in the circle around the triangle: the angles opposite the
// side add up to more than pi. By a little more, so that flips end.
bool FaceTriangles::isInCircle(Id part, std::size_t k) const
{
  const Triangle& c = this->parts_[part].corners;
  const Id other = this->parts_[part].across[k];
  const Id apex = this->parts_[other].corners[(this->sideTo(other, part) + 2) % 3];
  const Vec2 a = this->points_[c[k]].place;
  const Vec2 b = this->points_[c[(k + 1) % 3]].place;
  const auto at = [](Vec2 toA, Vec2 toB) { return Vec2{ dot(toA, toB), cross(toA, toB) }; };
  const Vec2 p = this->points_[c[(k + 2) % 3]].place;
  const Vec2 q = this->points_[apex].place;
  const Vec2 here = at(a - p, b - p);
  const Vec2 there = at(b - q, a - q);
  const double sine = here.y * there.x + here.x * there.y;
  return sine < -tolerance::Tie * norm(here) * norm(there);
}

void FaceTriangles::flipChanged()
{
  std::vector<Id> open = this->changed_;
  while (!open.empty())
  {
    const Id part = open.back();
    open.pop_back();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id other = this->parts_[part].across[k];
      if (other == NoId || !this->isInCircle(part, k))
      {
        continue;
      }
      const std::array<Triangle, 2> after = this->flipped(part, k);
      if (this->isTriangle(after[0]) && this->isTriangle(after[1]))
      {
        this->flip(part, k);
        open.push_back(other);
        open.push_back(part);
        break;
      }
    }
  }
}

std::vector<Id> FaceTriangles::takeChanged()
{
  std::sort(this->changed_.begin(), this->changed_.end());
  this->changed_.erase(
    std::unique(this->changed_.begin(), this->changed_.end()), this->changed_.end());
  return std::exchange(this->changed_, {});
}

}
