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

// If an edge's deviation exceeds this multiple of the tolerance, the smallest angle may be this (3
// degrees): a split exactly where the distance bends saves levels of triangles there. Below the
// multiple it saves about one level, and most triangles of a refined surface arise there, so their
// shapes matter most.
constexpr double WorthThinParts = 2.5;
constexpr double LeastAngleOfThinParts = 0.05;

double angleBetween(Vec2 a, Vec2 b)
{
  return polarAngle({ dot(a, b), std::abs(cross(a, b)) });
}

double leastAngle(Vec2 a, Vec2 b, Vec2 c)
{
  return std::min(
    { angleBetween(b - a, c - a), angleBetween(c - b, a - b), angleBetween(a - c, b - c) });
}

} // anonymous namespace

RedGreenMesh::Placement DeviationRules::place(Id edge)
{
  const double weight = this->weightOf(edge);
  return { weight, this->workers_.first().distances.onEdge(edge, weight) };
}

double DeviationRules::weightOf(Id edge) const
{
  constexpr double middle = 0.5;
  const Deviation deviation = this->workers_.deviation(edge);
  if (!(deviation.largest() > this->tolerance_))
  {
    return middle;
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
          this->smallestAngleOfFour(leaf, edge, weight) >=
            this->allowedAngle(this->triangles_.faceOf(leaf), deviation.largest());
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
  const double allowed = this->allowedAngle(leaf);
  const Id ways = RedGreenMesh::waysToClose(this->triangles_.splitEdges(leaf));
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
  const Triangle& corners = this->triangles_.mesh().triangle(face);
  const double least = leastAngle(this->triangles_.inPlane(corners[0], face),
    this->triangles_.inPlane(corners[1], face), this->triangles_.inPlane(corners[2], face));
  const double allowed =
    deviation > WorthThinParts * this->tolerance_ ? LeastAngleOfThinParts : LeastAngle;
  return std::min(allowed, LeastAngleFraction * least);
}

double DeviationRules::smallestAngle(Id leaf, Id way) const
{
  const Id face = this->triangles_.faceOf(leaf);
  const RedGreenMesh::Closing closing = this->triangles_.closing(leaf, way);
  std::array<Vec2, 6> p;
  for (std::size_t i = 0; i < closing.size; ++i)
  {
    p[i] = this->triangles_.inPlane(closing.points[i], face);
  }
  double least = Infinity;
  for (Id i = 0; i < closing.count; ++i)
  {
    const std::array<Id, 3>& t = closing.triangles[i];
    least = std::min(least, leastAngle(p[t[0]], p[t[1]], p[t[2]]));
  }
  return least;
}

}
