// SPDX-License-Identifier: BSD-3-Clause
// A point beside the surface goes to its closest point, whatever the precision of the coordinates:
// a face that is almost as close would put it far from there.
#include "EngineSupport.h"
#include "Seeds.h"

#include "mesh/SurfaceSnap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>

using namespace geodesictest;
using geodesic::LocatedPolyline;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

constexpr int PointsOnAMesh = 40;

constexpr std::uint64_t SeedsOfAKind = 6;

using Long = long double;
using Long3 = std::array<Long, 3>;

Long3 minus(const Long3& a, const Long3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
Long dot(const Long3& a, const Long3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Long3 along(const Long3& origin, Long s, const Long3& a, Long t, const Long3& b)
{
  return { origin[0] + s * a[0] + t * b[0], origin[1] + s * a[1] + t * b[1],
    origin[2] + s * a[2] + t * b[2] };
}
Long distance(const Long3& a, const Long3& b)
{
  return std::sqrt(dot(minus(a, b), minus(a, b)));
}
Long3 exact(const Vec3& p)
{
  return { p[0], p[1], p[2] };
}

Long3 closestOnSegment(const Long3& a, const Long3& b, const Long3& p)
{
  const Long3 way = minus(b, a);
  const Long square = dot(way, way);
  const Long t = square > 0 ? std::clamp(dot(minus(p, a), way) / square, Long(0), Long(1)) : 0;
  return along(a, t, way, 0, way);
}

/// By the normal equations of the face's plane.
Long3 closestOnFace(const Long3& a, const Long3& b, const Long3& c, const Long3& p)
{
  const Long3 u = minus(b, a);
  const Long3 v = minus(c, a);
  const Long3 w = minus(p, a);
  const Long determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
  const Long s = dot(v, v) * dot(u, w) - dot(u, v) * dot(v, w);
  const Long t = dot(u, u) * dot(v, w) - dot(u, v) * dot(u, w);
  if (s > 0 && t > 0 && s + t < determinant)
  {
    return along(a, s / determinant, u, t / determinant, v);
  }
  Long3 best = closestOnSegment(a, b, p);
  for (const Long3& other : { closestOnSegment(b, c, p), closestOnSegment(c, a, p) })
  {
    best = distance(other, p) < distance(best, p) ? other : best;
  }
  return best;
}

Long3 closestOnSurface(const PlainMesh& mesh, const Vec3& point)
{
  const Long3 p = exact(point);
  Long3 best{};
  Long least = std::numeric_limits<Long>::infinity();
  for (const Triangle& t : mesh.triangles)
  {
    const Long3 here = closestOnFace(
      exact(mesh.points[t[0]]), exact(mesh.points[t[1]]), exact(mesh.points[t[2]]), p);
    if (distance(here, p) < least)
    {
      least = distance(here, p);
      best = here;
    }
  }
  return best;
}

double largestCoordinate(const Vec3& p)
{
  return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
}

Vec3 toFloat(const Vec3& p)
{
  return { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) };
}

class PlacesBesideSurface : public ::testing::TestWithParam<MeshKind>
{
};

}

TEST_P(PlacesBesideSurface, APointGoesToTheClosestOne)
{
  double worst = 0.0;
  for (Random& random : EachSeed(SeedsOfAKind, 41000))
  {
    const PlainMesh plain = GetParam().make(random.between(20, 120), random);
    const TriangleMesh mesh = engineMesh(plain);
    const bool isFloat = random.chance(0.5);
    const double coordinatePrecision =
      isFloat ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
    double largest = 0.0;
    for (const Vec3& p : plain.points)
    {
      largest = std::max(largest, largestCoordinate(p));
    }
    std::vector<LocatedPolyline> points(PointsOnAMesh);
    for (LocatedPolyline& point : points)
    {
      Vec3 p = position(plain, randomPoint(plain, random));
      const double away = std::pow(10.0, random.uniform(-5.0, 0.5));
      for (double& x : p)
      {
        x += random.uniform(-away, away);
      }
      point.points = { isFloat ? toFloat(p) : p };
    }
    geodesictest::locate(mesh, points, coordinatePrecision);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Vec3& point = points[i].points.front();
      const double precision =
        4.0 * coordinatePrecision * std::max(largest, largestCoordinate(point));
      const Long3 closest = closestOnSurface(plain, point);
      // If a point is on the surface, all faces that are as close within the precision may have it.
      const bool isOnSurface = distance(closest, exact(point)) <= precision;
      EXPECT_FALSE(points[i].faces.front().empty());
      for (const geodesic::Id face : points[i].faces.front())
      {
        const SurfacePoint place =
          geodesic::snapToFace(mesh, face, point, coordinatePrecision).place;
        const auto off =
          static_cast<double>(distance(exact(geodesic::position(mesh, place)), closest)) /
          precision;
        EXPECT_LE(off, isOnSurface ? 4.0 : 1.01) << "point " << i << ", face " << face;
        worst = std::max(worst, isOnSurface ? 0.0 : off);
      }
    }
  }
  std::cout << "worst on " << GetParam().name << ": " << worst << " precisions\n";
}

/// In needles, places are rounded more along the needle.
std::vector<MeshKind> kindsWithoutNeedles()
{
  std::vector<MeshKind> kinds;
  std::copy_if(meshKinds().begin(), meshKinds().end(), std::back_inserter(kinds),
    [](const MeshKind& kind) { return accuracyOn(kind) == OrdinaryAccuracy; });
  return kinds;
}

INSTANTIATE_TEST_SUITE_P(Kinds, PlacesBesideSurface, ::testing::ValuesIn(kindsWithoutNeedles()),
  [](const ::testing::TestParamInfo<MeshKind>& kind) { return std::string(kind.param.name); });
