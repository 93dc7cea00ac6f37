// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths, traced through a field or found between two points, compared with what holds for
// any shortest path: its length is the true distance, each piece is in one face, it is straight
// across edges, and it bends only at vertices where both sides have half a turn or more. The truth
// comes from the plain mesh.
#include "EngineSupport.h"
#include "Seeds.h"
#include "paths/PathChecker.h"
#include "truth/AnalyticCases.h"
#include "truth/RandomMeshKinds.h"

#include "paths/JoinPoints.h"
#include "paths/PathInWindows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// Traces paths from the queries and checks them.
void expectPathsToTheSource(const PlainMesh& mesh, const std::vector<geodesic::SourceCurve>& curves,
  const TriangleMesh& engine, const Sources& sources, const std::vector<MeshPoint>& queries,
  const std::vector<double>& truth, double slack)
{
  const PathChecker checker(mesh);
  const DistanceField field = solveKeepingAll(engine, curves);
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    SCOPED_TRACE("path " + std::to_string(i));
    const std::vector<SurfacePoint> path = pathInWindows(field, enginePoint(engine, queries[i]));
    if (truth[i] == geodesic::Infinity)
    {
      EXPECT_TRUE(path.empty());
      continue;
    }
    ASSERT_FALSE(path.empty());
    const std::vector<PathPoint> plain = checker.plain(path);
    EXPECT_LE(spaceDistance(plain.front().place, position(mesh, queries[i])), slack);
    EXPECT_LE(distanceInSpace(mesh, plain.back().place, sources), slack) << "ends off the source";
    checker.expectShortest(plain, truth[i], slack);
  }
}

/// Finds paths from the source, which is one point, to the queries.
void expectPathsBetween(const PlainMesh& mesh, const TriangleMesh& engine, const MeshPoint& source,
  const std::vector<MeshPoint>& queries, const std::vector<double>& truth, double slack)
{
  const PathChecker checker(mesh);
  const geodesic::JoinPoints join = geodesic::joinByShortestPaths(engine);
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    SCOPED_TRACE("path " + std::to_string(i));
    const SurfacePoint from = enginePoint(engine, source);
    const SurfacePoint to = enginePoint(engine, queries[i]);
    const std::vector<SurfacePoint> path = join(from, to, {});
    if (truth[i] == geodesic::Infinity)
    {
      EXPECT_TRUE(path.empty());
      continue;
    }
    ASSERT_GE(path.size(), 2U);
    EXPECT_TRUE(samePlace(engine, path.front(), from));
    EXPECT_TRUE(samePlace(engine, path.back(), to));
    checker.expectShortest(checker.plain(path), truth[i], slack);
  }
}

void expectAnalyticPaths(AnalyticCase (*makeCase)(Random&))
{
  std::size_t single = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const AnalyticCase c = makeCase(random);
    const double slack = OrdinaryAccuracy * largestFinite(c.vertexTruth);
    const TriangleMesh engine = engineMesh(c.mesh);
    expectPathsToTheSource(
      c.mesh, engineCurves(engine, c.sources), engine, c.sources, c.queries, c.queryTruth, slack);
    if (c.sources.points.size() == 1 && c.sources.segments.empty())
    {
      ++single;
      expectPathsBetween(c.mesh, engine, c.sources.points[0], c.queries, c.queryTruth, slack);
    }
  }
  EXPECT_GE(single, 3U);
}

class ShortestPaths : public ::testing::TestWithParam<MeshKind>
{
};

}

TEST(ShortestPath, InTheConvexPlaneItIsStraight)
{
  expectAnalyticPaths(planeCase);
}

TEST(ShortestPath, OnARegularGridItIsStraightThroughVerticesToo)
{
  expectAnalyticPaths(regularGridCase);
}

TEST(ShortestPath, AmongNeedlesItIsStraight)
{
  expectAnalyticPaths(stretchedPlaneCase);
}

TEST(ShortestPath, OnABoxItIsStraightInAnUnfolding)
{
  expectAnalyticPaths(boxCase);
}

TEST(ShortestPath, OnACylinderItIsStraightUnrolled)
{
  expectAnalyticPaths(cylinderCase);
}

TEST(ShortestPath, OnAConeItIsStraightUnrolled)
{
  expectAnalyticPaths(coneCase);
}

TEST(ShortestPath, BendsAtASaddleVertex)
{
  expectAnalyticPaths(saddleFanCase);
}

TEST(ShortestPath, OnATetrahedronItIsStraightInAnUnfolding)
{
  expectAnalyticPaths(tetrahedronCase);
}

TEST(ShortestPath, BendsAtTheCornersOfHoles)
{
  expectAnalyticPaths(holesCase);
}

TEST(ShortestPath, BendsAtTheCornerOfAnL)
{
  expectAnalyticPaths(lShapeCase);
}

TEST(ShortestPath, GoesFromPageToPageOfABook)
{
  expectAnalyticPaths(bookCase);
}

TEST(ShortestPath, GoesThroughTheVertexOfABowTie)
{
  expectAnalyticPaths(bowTieCase);
}

// (1 - 1.8e-15, 9e-16, 9e-16) in a face, two faces away from the vertex that is the source.
TEST(ShortestPath, ToAPointARoundingBesideAVertexIsFound)
{
  Random random(83);
  const AnalyticCase c = geodesictest::boxCase(random);
  const TriangleMesh mesh = engineMesh(c.mesh);
  const geodesic::JoinPoints join = geodesic::joinByShortestPaths(mesh);
  const std::vector<SurfacePoint> path =
    join(enginePoint(mesh, c.sources.points[0]), enginePoint(mesh, c.queries[18]), {});
  EXPECT_GE(path.size(), 2U);
}

// Rounding of the long way to the edge is a large part of the edge. Moving the crossing to the
// edge's end would turn the path behind it by half a right angle.
// The patch of a path has such a point at the vertex or on the edge.
TEST(ShortestPath, FromAPointARoundingBesideAVertexOrAnEdgeIsWhole)
{
  const Seeds seeds = seedsOfTest(20);
  for (const MeshKind& kind : meshKinds())
  {
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      Random random(seed);
      const PlainMesh plain = kind.make(random.between(10, 60), random);
      const TriangleMesh mesh = engineMesh(plain);
      const Index k = random.below(3);
      const double rounding = std::pow(10.0, random.uniform(-20.0, -15.0));
      const double along = random.chance(0.5) ? rounding : random.uniform(0.1, 0.9);
      MeshPoint beside{ static_cast<Index>(random.below(plain.triangles.size())), {} };
      beside.weights[k] = 1.0 - along;
      beside.weights[(k + 1) % 3] = along;
      MeshPoint at = beside;
      beside.weights[(k + 2) % 3] = rounding;
      const SurfacePoint to = enginePoint(mesh, randomPoint(plain, random));
      const geodesic::JoinPoints join = geodesic::joinByShortestPaths(mesh);
      const auto lengthFrom = [&](const MeshPoint& from)
      {
        const auto path = join(enginePoint(mesh, from), to, {});
        double length = path.empty() ? geodesic::Infinity : 0.0;
        for (std::size_t i = 1; i < path.size(); ++i)
        {
          EXPECT_NE(geodesic::commonFace(mesh, path[i - 1], path[i]), geodesic::NoId);
          length += geodesic::distanceInSpace(mesh, path[i - 1], path[i]);
        }
        return length;
      };
      const double length = lengthFrom(at);
      SCOPED_TRACE(std::string(kind.name) + ", seed " + std::to_string(seed));
      if (length < geodesic::Infinity)
      {
        EXPECT_NEAR(
          lengthFrom(beside), length, 1e-12 * (length + mesh.shape(beside.face).longest()));
      }
    }
  }
}

TEST(ShortestPath, CrossesATinyEdgeAtTheEndOfALongWayWhereTheStraightLineDoes)
{
  const double h = 5e-14;
  PlainMesh mesh;
  mesh.points = { { -1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, h, 0.0 },
    { 2.0 * h, 0.5 * h, 0.0 } };
  mesh.triangles = { { 0, 1, 2 }, { 2, 1, 3 } };
  const TriangleMesh engine = engineMesh(mesh);
  const geodesic::JoinPoints join = geodesic::joinByShortestPaths(engine);
  for (const double part : { 0.2, 0.5, 0.8 })
  {
    // A quarter of the way from (0, part h) to the far corner.
    const MeshPoint end{ 1, { 0.75 * part, 0.75 * (1.0 - part), 0.25 } };
    const std::vector<SurfacePoint> path =
      join(SurfacePoint::atVertex(0), enginePoint(engine, end), {});
    ASSERT_EQ(path.size(), 3U);
    const double crossing = position(mesh, end)[1] / (1.0 + position(mesh, end)[0]);
    EXPECT_NEAR(PathChecker(mesh).plain(path[1]).place[1], crossing, 0.02 * h) << part;
  }
}

TEST_P(ShortestPaths, AreAsLongAsTheBruteForceDistanceAndBendOnlyWhereTheyMay)
{
  for (std::uint64_t seed = 0; seed < meshesOfAKind(12); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + 52000);
    const PlainMesh mesh = GetParam().make(random.between(20, 300), random);
    const TriangleMesh engine = engineMesh(mesh);
    CurveMaker maker(mesh, random);
    const std::vector<Polyline> curves = maker.anySource();
    const std::vector<MeshPoint> queries = randomPoints(mesh, 30, random);
    const BruteForceResult truth = bruteForceDistances(mesh, toSources(curves), queries);
    const double slack = accuracyOn(GetParam()) * largestFinite(truth.vertices);
    {
      SCOPED_TRACE(describe(curves));
      expectPathsToTheSource(mesh, engineCurves(engine, curves), engine, toSources(curves), queries,
        truth.queries, slack);
    }
    const Polyline one = maker.point();
    SCOPED_TRACE(describe({ one }));
    const BruteForceResult fromOne = bruteForceDistances(mesh, toSources({ one }), queries);
    expectPathsBetween(mesh, engine, toSources({ one }).points[0], queries, fromOne.queries, slack);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ShortestPaths, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
