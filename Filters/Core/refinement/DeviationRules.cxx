// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/DeviationRules.h"

#include "Trigonometry.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// Refinement makes no angle (in radians) smaller than this (14 degrees) and than this fraction of
// the input face's smallest angle. With smaller fractions, the worst of a hundred angles decays
// from level to level by more than a fifth; with larger ones, many more triangles are needed, and
// those that close them are thin again.
constexpr double LeastAngle = 0.25;
constexpr double LeastAngleFraction = 0.6;

// If an edge's deviation exceeds this multiple of the tolerance, the smallest angle may be this (4
// degrees): a split exactly where the distance bends saves levels of triangles there. Below the
// multiple it saves about one level, and most triangles of a refined surface arise there, so their
// shapes matter most.
constexpr double WorthThinParts = 2.5;
constexpr double LeastAngleOfThinParts = 0.07;

// The triangles of a strip may have this fraction of the input face's smallest angle; ways from a
// corner grow a little slower than that, as those on both sides of the corner differ.
constexpr double LeastAngleFractionOfStrips = 0.5;
constexpr double LeastAngleFactorOfGrowth = 1.05 * LeastAngleFractionOfStrips;

// The triangles of a strip become parts if they have this fraction of it.
constexpr double LeastAngleFractionOfParts = 0.95;

// A round triangle that is closed by a strip is not split any further, so that angles do not get
// smaller from level to level if those of the strip are as large as this (20 degrees), or as the
// fraction above.
constexpr double LeastAngleOfRoundStrips = 0.35;

// No part of an edge between thin leaves is shorter than this fraction of the edge. The shapes do
// not need this, as corners limit the pieces; it makes lengths fall from level to level.
constexpr double LeastWeightOfStrips = 0.1;

double angleBetween(Vec2 a, Vec2 b)
{
  return polarAngle({ dot(a, b), std::abs(cross(a, b)) });
}

double leastAngle(Vec2 a, Vec2 b, Vec2 c)
{
  return std::min(
    { angleBetween(b - a, c - a), angleBetween(c - b, a - b), angleBetween(a - c, b - c) });
}

// What to split if a triangle of a strip is too thin; it has a side of the strip's polygon, and an
// apex on the other side of the strip. If the apex is over the triangle's side, the side is too
// long, or too short if the apex is far; else one of the two sides at the apex is too long. No side
// is split that is not twice as long as another one there, so the shortest of all sides stays the
// shortest and splitting ends. Returns the number of the side to split, or NoId.
Id partToSplit(const std::vector<Vec2>& places, Id begin, Id apex)
{
  const Id size = static_cast<Id>(places.size());
  const Vec2 side = places[(begin + 1) % size] - places[begin];
  const Vec2 toApex = places[apex] - places[begin];
  const double at = dot(toApex, side);
  const Id before = (apex + size - 1) % size;
  const double length = norm(side);
  const double lengthBefore = norm(places[apex] - places[before]);
  const double lengthBehind = norm(places[(apex + 1) % size] - places[apex]);
  const bool isFar = cross(side, toApex) > dot(side, side);
  const bool mayBefore = at < 0.0 || (isFar && lengthBefore >= lengthBehind);
  const bool mayBehind = at > dot(side, side) || (isFar && lengthBehind > lengthBefore);
  Id longer = begin;
  double ofLonger = length;
  if (mayBefore && lengthBefore > length)
  {
    longer = before;
    ofLonger = lengthBefore;
  }
  else if (mayBehind && lengthBehind > length)
  {
    longer = apex;
    ofLonger = lengthBehind;
  }
  return ofLonger >= 2.0 * std::min({ length, lengthBefore, lengthBehind }) ? longer : NoId;
}

} // anonymous namespace

RedGreenMesh::Placement DeviationRules::place(Id edge)
{
  const double weight = this->weightOf(edge);
  return { weight, this->workers_.first().distances.onEdge(edge, weight) };
}

bool DeviationRules::isBetweenThinLeaves(Id edge) const
{
  bool areThin = true;
  this->triangles_.forEachLeafAround(
    edge, [&](Id leaf) { areThin = areThin && this->triangles_.isThin(leaf); });
  return areThin;
}

bool DeviationRules::mustSplit(Id part) const
{
  const double length = this->triangles_.lengthOf(part);
  bool must = this->workers_.deviation(part).largest() > this->tolerance_;
  this->triangles_.forEachLeafAround(part,
    [&](Id leaf)
    { must = must && this->triangles_.isThin(leaf) && length > this->triangles_.height(leaf); });
  return must;
}

// While the other side has no points, but is going to get some, these will fall between those of
// this side: then the way may grow by the square.
StripCorners DeviationRules::cornersAt(Id edge) const
{
  StripCorners corners;
  const std::array<Id, 2> ends = this->triangles_.edgeData(edge).ends;
  this->triangles_.forEachLeafAt(edge,
    [&](Id leaf)
    {
      const Id face = this->triangles_.faceOf(leaf);
      const Triangle points = this->triangles_.corners(leaf);
      const std::array<Vec2, 3> c = this->triangles_.inPlane(points, face);
      const double least = LeastAngleFactorOfGrowth * this->leastAngleOf(face);
      for (Id k = 0; k < 3; ++k)
      {
        if (points[k] != ends[0] && points[k] != ends[1])
        {
          continue;
        }
        const double angle = angleBetween(c[(k + 1) % 3] - c[k], c[(k + 2) % 3] - c[k]);
        const double growth = 1.0 + std::max(1.0, angle / least);
        const Id next = this->triangles_.ensureEdge(leaf, k);
        const Id other = next == edge ? this->triangles_.ensureEdge(leaf, (k + 2) % 3) : next;
        const bool takesTurns = !this->triangles_.isSplit(other) &&
          this->workers_.deviation(other).largest() > this->tolerance_;
        corners[points[k] == ends[0] ? 0 : 1].emplace_back(
          takesTurns ? growth * growth : growth, this->waysOfPoints(other, points[k]));
      }
    });
  return corners;
}

// The ways from a corner to the points on an edge that begins there, ascending.
std::vector<double> DeviationRules::waysOfPoints(Id edge, Id corner) const
{
  std::vector<double> ways;
  const Id face = this->triangles_.edgeData(edge).face;
  const Vec2 begin = this->triangles_.inPlane(corner, face);
  this->triangles_.forEachPartOf(edge,
    [&](Id part)
    {
      if (this->triangles_.isSplit(part))
      {
        const Id point = this->triangles_.edgeData(part).split;
        ways.push_back(norm(this->triangles_.inPlane(point, face) - begin));
      }
    });
  std::sort(ways.begin(), ways.end());
  return ways;
}

double DeviationRules::weightOf(Id edge) const
{
  constexpr double middle = 0.5;
  const Deviation deviation = this->workers_.deviation(edge);
  if (!(deviation.largest() > this->tolerance_))
  {
    return middle;
  }
  if (this->isBetweenThinLeaves(edge))
  {
    const double weight = this->workers_.bestSplit(edge, this->cornersAt(edge));
    return std::clamp(weight, LeastWeightOfStrips, 1.0 - LeastWeightOfStrips);
  }
  const double aimed = splitPosition(deviation.at());
  for (const double weight : { aimed, 0.5 * (aimed + middle) })
  {
    // whether the shapes of the leaves around the edge permit the split
    bool allowed = true;
    this->triangles_.forEachLeafAt(edge,
      [&](Id leaf)
      {
        allowed = allowed &&
          (this->triangles_.isThin(leaf) ||
            this->smallestAngleOfFour(leaf, edge, weight) >=
              this->allowedAngle(this->triangles_.faceOf(leaf), deviation.largest()));
      });
    if (allowed)
    {
      return weight;
    }
  }
  return middle;
}

// The smallest angle of a leaf's four parts if one edge is split at the weight, and the others
// where they are split already or in the middle.
double DeviationRules::smallestAngleOfFour(Id triangle, Id splitEdge, double weight) const
{
  const Id face = this->triangles_.faceOf(triangle);
  const Triangle corners = this->triangles_.corners(triangle);
  std::array<Vec2, 3> c;
  std::array<Vec2, 3> m;
  for (Id k = 0; k < 3; ++k)
  {
    c[k] = this->triangles_.inPlane(corners[k], face);
  }
  for (Id k = 0; k < 3; ++k)
  {
    const Id id = this->triangles_.ensureEdge(triangle, k);
    const RedGreenMesh::Edge& edge = this->triangles_.edgeData(id);
    double t = id == splitEdge ? weight : 0.5;
    t = edge.ends[0] == corners[k] ? t : 1.0 - t;
    m[k] = this->triangles_.isSplit(id) ? this->triangles_.inPlane(edge.split, face)
                                        : c[k] + t * (c[(k + 1) % 3] - c[k]);
  }
  return std::min({ leastAngle(c[0], m[0], m[2]), leastAngle(m[0], c[1], m[1]),
    leastAngle(m[2], m[1], c[2]), leastAngle(m[0], m[1], m[2]) });
}

bool DeviationRules::mayClose(Id leaf)
{
  if (this->triangles_.isSplitTwice(leaf))
  {
    const double least = this->leastAngleOf(this->triangles_.faceOf(leaf));
    return this->triangles_.hasArea(leaf) &&
      this->mayClose(leaf, std::min(LeastAngleOfRoundStrips, LeastAngleFractionOfParts * least));
  }
  return this->mayClose(leaf, this->allowedAngle(leaf));
}

bool DeviationRules::mayClose(Id leaf, double allowed) const
{
  const Id ways = this->triangles_.waysToClose(leaf);
  for (Id way = 0; way < ways; ++way)
  {
    if (this->smallestAngle(leaf, way) >= allowed)
    {
      return true;
    }
  }
  return false;
}

double DeviationRules::allowedAngle(Id leaf) const
{
  double largest = 0.0;
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->triangles_.ensureEdge(leaf, k);
    largest = std::max(largest, this->workers_.deviation(edge).largest());
  }
  return this->allowedAngle(this->triangles_.faceOf(leaf), largest);
}

double DeviationRules::allowedAngle(Id face, double deviation) const
{
  const double allowed =
    deviation > WorthThinParts * this->tolerance_ ? LeastAngleOfThinParts : LeastAngle;
  return std::min(allowed, LeastAngleFraction * this->leastAngleOf(face));
}

double DeviationRules::leastAngleOf(Id face) const
{
  const auto [a, b, c] = this->triangles_.inPlane(this->triangles_.mesh().triangle(face), face);
  return leastAngle(a, b, c);
}

double DeviationRules::smallestAngle(Id leaf, Id way) const
{
  const Id face = this->triangles_.faceOf(leaf);
  const RedGreenMesh::Closing closing = this->triangles_.closing(leaf, way);
  const std::vector<Vec2> p = this->triangles_.inPlane(closing, face);
  double least = Infinity;
  for (const std::array<Id, 3>& t : closing.triangles)
  {
    least = std::min(least, leastAngle(p[t[0]], p[t[1]], p[t[2]]));
  }
  return least;
}

bool DeviationRules::isAnyOverTolerance(Id leaf) const
{
  bool isAny = false;
  this->triangles_.forEachPartOfEdges(leaf,
    [&](Id edge) { isAny = isAny || this->workers_.deviation(edge).largest() > this->tolerance_; });
  return isAny;
}

Id DeviationRules::edgeToSplit(Id leaf)
{
  if (this->triangles_.pointsOnEdges(leaf) == 0)
  {
    return NoId;
  }
  const Id longest = this->triangles_.ensureEdge(leaf, this->triangles_.longestEdge(leaf));
  if (this->triangles_.splitEdges(leaf) == 2 && !this->triangles_.isSplit(longest))
  {
    return longest; // no strip runs between the other two
  }
  const Id face = this->triangles_.faceOf(leaf);
  const double allowed = LeastAngleFractionOfStrips * this->leastAngleOf(face);
  if (this->isAnyOverTolerance(leaf) || this->mayClose(leaf, allowed))
  {
    return NoId;
  }
  return this->longerPart(leaf, 0, allowed);
}

Id DeviationRules::edgeToSplitBeforeParts(Id leaf)
{
  const Id face = this->triangles_.faceOf(leaf);
  return this->longerPart(
    leaf, this->triangles_.wayOf(leaf), LeastAngleFractionOfParts * this->leastAngleOf(face));
}

// The longer one of two parts of edges at a triangle with an angle under the allowed one; NoId if
// there is none.
Id DeviationRules::longerPart(Id leaf, Id way, double allowed) const
{
  const RedGreenMesh::Closing closing = this->triangles_.closing(leaf, way);
  const std::vector<Vec2> places = this->triangles_.inPlane(closing, this->triangles_.faceOf(leaf));
  for (const std::array<Id, 3>& t : closing.triangles)
  {
    if (leastAngle(places[t[0]], places[t[1]], places[t[2]]) >= allowed)
    {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const bool isSide = closing.edgeBetween(t[k], t[(k + 1) % 3]) != NoId;
      const Id side = isSide ? partToSplit(places, t[k], t[(k + 2) % 3]) : NoId;
      if (side != NoId)
      {
        return closing.edges[side];
      }
    }
  }
  return NoId;
}

}
