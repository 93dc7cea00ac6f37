// SPDX-License-Identifier: BSD-3-Clause
// The place of a surface does not matter: far from the origin, where coordinates are coarse, the
// results are those of the same surface at the origin.
#include "EngineSupport.h"
#include "paths/PathChecker.h"

#include "paths/JoinPoints.h"
#include "paths/PathsToSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
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

constexpr double Epsilon = std::numeric_limits<double>::epsilon();

constexpr std::uint64_t SeedsOfAKind = 6;

/// A surface with edges of about 1e-3 some 1e8 from the origin, and the same surface moved,
/// exactly, so that its first point is the origin.
struct Surfaces
{
  PlainMesh far;
  PlainMesh atOrigin;
};

Surfaces surfacesOf(PlainMesh mesh, Random& random)
{
  Surfaces result{ mesh, mesh };
  Vec3 shift;
  for (double& s : shift)
  {
    s = random.uniform(0.7e8, 1.3e8) * (random.chance(0.5) ? 1.0 : -1.0);
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      result.far.points[i][k] = 1e-3 * mesh.points[i][k] + shift[k];
      result.atOrigin.points[i][k] = result.far.points[i][k] - result.far.points[0][k];
      EXPECT_EQ(result.atOrigin.points[i][k] + result.far.points[0][k], result.far.points[i][k]);
    }
  }
  return result;
}

std::vector<SurfacePoint> placesOf(const TriangleMesh& mesh, std::vector<LocatedPolyline>& points)
{
  geodesictest::locate(mesh, points, Epsilon);
  const geodesic::SourceCurves curves =
    geodesic::putOntoSurface(mesh, points, DBL_EPSILON, geodesic::joinByShortestPaths(mesh));
  std::vector<SurfacePoint> places;
  for (const geodesic::SourceCurve& curve : curves.curves)
  {
    places.push_back(curve.points.front());
  }
  return places;
}

class FarFromOrigin : public ::testing::TestWithParam<MeshKind>
{
};

bool isSame(const SurfacePoint& a, const SurfacePoint& b)
{
  return a.kind == b.kind && a.id == b.id && a.u == b.u && a.v == b.v;
}

void expectSame(const std::vector<SurfacePoint>& far, const std::vector<SurfacePoint>& atOrigin)
{
  ASSERT_EQ(far.size(), atOrigin.size());
  for (std::size_t i = 0; i < far.size(); ++i)
  {
    EXPECT_TRUE(isSame(far[i], atOrigin[i])) << "point " << i << " of " << far.size();
  }
}

}

TEST_P(FarFromOrigin, PathsAreThoseAtTheOriginAndShortest)
{
  double worst = 0.0;
  for (Random& random : EachSeed(SeedsOfAKind, 52000))
  {
    const Surfaces surfaces = surfacesOf(GetParam().make(random.between(30, 300), random), random);
    CurveMaker maker(surfaces.atOrigin, random);
    const std::vector<Polyline> curves = maker.anySource();
    const TriangleMesh far = engineMesh(surfaces.far);
    const TriangleMesh atOrigin = engineMesh(surfaces.atOrigin);
    std::vector<SurfacePoint> targets;
    for (int i = 0; i < 25; ++i)
    {
      targets.push_back(enginePoint(atOrigin, randomPoint(surfaces.atOrigin, random)));
    }
    const std::vector<FoundPath> farPaths = findPaths(far, engineCurves(far, curves), targets);
    const std::vector<FoundPath> paths =
      findPaths(atOrigin, engineCurves(atOrigin, curves), targets);
    const geodesic::DistanceField field = solveKeepingAll(atOrigin, engineCurves(atOrigin, curves));
    const PathChecker checker(surfaces.atOrigin);
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      SCOPED_TRACE("target " + std::to_string(i));
      expectSame(farPaths[i].points, paths[i].points);
      if (!farPaths[i].points.empty())
      {
        const double length = PathChecker::length(checker.plain(farPaths[i].points));
        const double distance = field.distance(targets[i]);
        const double error = std::abs(length - distance) / (distance + 1e-3);
        EXPECT_LE(error, 1e-9);
        worst = std::max(worst, error);
      }
    }
    const geodesic::JoinPoints joinFar = geodesic::joinByShortestPaths(far);
    const geodesic::JoinPoints join = geodesic::joinByShortestPaths(atOrigin);
    for (int i = 0; i < 8; ++i)
    {
      const SurfacePoint first = enginePoint(far, randomFacePoint(surfaces.far, random));
      const SurfacePoint second = enginePoint(far, randomFacePoint(surfaces.far, random));
      expectSame(joinFar(first, second, {}), join(first, second, {}));
    }
  }
  std::cout << "worst relative error on " << GetParam().name << ": " << worst << "\n";
}

TEST_P(FarFromOrigin, PointsAreAtTheSamePlacesUpToTheirPrecision)
{
  for (Random& random : EachSeed(SeedsOfAKind, 53000))
  {
    const Surfaces surfaces = surfacesOf(GetParam().make(random.between(30, 300), random), random);
    const TriangleMesh far = engineMesh(surfaces.far);
    const TriangleMesh atOrigin = engineMesh(surfaces.atOrigin);
    std::vector<LocatedPolyline> farPoints(25);
    std::vector<LocatedPolyline> points(25);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      Vec3 p = position(surfaces.far, randomFacePoint(surfaces.far, random));
      const double away = 1e-3 * random.uniform();
      for (std::size_t k = 0; k < 3; ++k)
      {
        p[k] += i % 2 == 0 ? 0.0 : random.uniform(-away, away);
      }
      farPoints[i].points = { p };
      points[i].points = { geodesic::operator-(p, surfaces.far.points[0]) };
    }
    const std::vector<SurfacePoint> farPlaces = placesOf(far, farPoints);
    const std::vector<SurfacePoint> places = placesOf(atOrigin, points);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double precision = 4.0 * Epsilon * 1.4e8;
      const double apart = spaceDistance(
        geodesic::position(atOrigin, farPlaces[i]), geodesic::position(atOrigin, places[i]));
      EXPECT_LE(apart, 1.01 * precision) << "point " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FarFromOrigin, ::testing::ValuesIn(meshKinds()),
  [](const ::testing::TestParamInfo<MeshKind>& kind) { return std::string(kind.param.name); });
