// SPDX-License-Identifier: BSD-3-Clause
// Sources that start later than others, compared with brute force and with solves of each alone;
// and points that are each the farthest from those before, compared with a loop of solves.
#include "EngineSupport.h"
#include "OnThreads.h"

#include "Tolerance.h"
#include "field/FarthestPoints.h"
#include "front/Front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace geodesictest;
using geodesic::FrontOptions;
using geodesic::Id;
using geodesic::Job;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

using Curves = std::vector<SourceCurve>;

class LaterSources : public ::testing::TestWithParam<MeshKind>
{
};

class FarthestPoints : public ::testing::TestWithParam<MeshKind>
{
};

/// A random mesh with some sources, each of points and curves.
struct SeveralSources
{
  SeveralSources(const MeshKind& kind, Random& random)
    : plain(kind.make(random.between(20, 400), random))
    , mesh(engineMesh(plain))
    , queries(randomPoints(plain, 30, random))
  {
    CurveMaker maker(plain, random);
    for (Index i = random.between(2, 6); i > 0; --i)
    {
      const std::vector<Polyline> added = maker.anySource();
      sources.push_back(engineCurves(mesh, added));
      polylines.insert(polylines.end(), added.begin(), added.end());
    }
  }

  /// The field of all sources, one after the other, with all windows.
  geodesic::DistanceField inTurn(FrontOptions options) const
  {
    std::size_t started = 1;
    options.laterSources = [&]
    {
      return started < sources.size() ? startingWindows(mesh, sources[started++], options.job)
                                      : geodesic::SourceWindows();
    };
    return geodesic::solve(mesh, sources.front(), options, geodesic::KeepWindows::All);
  }

  PlainMesh plain;
  TriangleMesh mesh;
  std::vector<MeshPoint> queries;
  std::vector<Polyline> polylines;
  std::vector<Curves> sources;
};

Curves atVertex(Id vertex)
{
  return { geodesic::pointCurve(SurfacePoint::atVertex(vertex)) };
}

/// What farthestPoints() has to find: all distances of each point are computed.
std::vector<geodesic::FarthestPoint> loopOfSolves(
  const TriangleMesh& mesh, Id start, std::size_t count)
{
  std::vector<double> known(mesh.numberOfVertices(), geodesic::Infinity);
  std::vector<geodesic::FarthestPoint> points;
  for (Id last = start;; last = points.back().vertex)
  {
    const std::vector<double> found = geodesic::solve(mesh, atVertex(last)).vertexDistances();
    std::transform(found.begin(), found.end(), known.begin(), known.begin(),
      [](double a, double b) { return std::min(a, b); });
    const double least = largestFinite(known) * (1.0 - geodesic::tolerance::Tie);
    const auto first = std::find_if(known.begin(), known.end(),
      [least](double distance) { return distance >= least && distance < geodesic::Infinity; });
    if (points.size() == count || !(*first > 0.0))
    {
      return points;
    }
    points.push_back({ static_cast<Id>(first - known.begin()), *first });
  }
}

void expectSame(const std::vector<geodesic::FarthestPoint>& points,
  const std::vector<geodesic::FarthestPoint>& expected, double accuracy)
{
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(points[i].vertex, expected[i].vertex) << i;
    EXPECT_NEAR(points[i].distance, expected[i].distance, accuracy) << i;
  }
}

}

TEST_P(LaterSources, GiveTheDistanceToTheNearestOfAllEverywhere)
{
  for (Random& random : EachSeed(meshesOfAKind(12), 53000))
  {
    const SeveralSources c(GetParam(), random);
    const BruteForceResult truth = bruteForceDistances(c.plain, toSources(c.polylines), c.queries);
    const EngineResult found = valuesOf(c.inTurn({}), c.queries);
    const double largest = std::max(largestFinite(truth.vertices), 1e-300);
    EXPECT_LE(worstError(found.vertices, truth.vertices, largest), accuracyOn(GetParam()));
    EXPECT_LE(worstError(found.queries, truth.queries, largest), accuracyOn(GetParam()));
  }
}

TEST_P(LaterSources, ChangeNoDistanceToWhichTheyAreNotNearer)
{
  for (Random& random : EachSeed(meshesOfAKind(12), 54000))
  {
    const SeveralSources c(GetParam(), random);
    std::vector<double> least(c.mesh.numberOfVertices(), geodesic::Infinity);
    for (const Curves& source : c.sources)
    {
      const std::vector<double> alone = geodesic::solve(c.mesh, source).vertexDistances();
      std::transform(alone.begin(), alone.end(), least.begin(), least.begin(),
        [](double a, double b) { return std::min(a, b); });
    }
    EXPECT_LE(
      worstError(c.inTurn({}).vertexDistances(), least, std::max(largestFinite(least), 1e-300)),
      accuracyOn(GetParam()));
  }
}

TEST_P(LaterSources, KeepWithinTheErrorOfAnApproximateField)
{
  for (Random& random : EachSeed(meshesOfAKind(12), 55000))
  {
    const SeveralSources c(GetParam(), random);
    FrontOptions options;
    options.relativeError = random.uniform(0.0, 0.1);
    const geodesic::DistanceField field = c.inTurn(options);
    EXPECT_LE(field.relativeErrorBound(), options.relativeError);
    expectCertified(field, c.queries, valuesOf(c.inTurn({}), c.queries), accuracyOn(GetParam()));
  }
}

TEST_P(LaterSources, GiveTheSameBitsInParallel)
{
  for (Random& random : EachSeed(meshesOfAKind(4), 56000))
  {
    const SeveralSources c(GetParam(), random);
    FrontOptions inParallel;
    inParallel.job = Job({}, onThreads);
    EXPECT_EQ(c.inTurn(inParallel).vertexDistances(), c.inTurn({}).vertexDistances());
  }
}

TEST_P(FarthestPoints, AreThoseOfALoopOfSolves)
{
  for (Random& random : EachSeed(meshesOfAKind(12), 57000))
  {
    const PlainMesh plain = GetParam().make(random.between(20, 400), random);
    const TriangleMesh mesh = engineMesh(plain);
    const Id start = static_cast<Id>(random.between(0, mesh.numberOfVertices() - 1));
    const std::size_t count = random.between(1, 60);
    const geodesic::FarthestPoints found = geodesic::farthestPoints(mesh, atVertex(start), count);
    const std::vector<double> first = geodesic::solve(mesh, atVertex(start)).vertexDistances();
    const double accuracy = accuracyOn(GetParam()) * largestFinite(first);
    expectSame(found.points, loopOfSolves(mesh, start, count), accuracy);
    const geodesic::FarthestPoints inParallel =
      geodesic::farthestPoints(mesh, atVertex(start), count, Job({}, onThreads));
    expectSame(inParallel.points, found.points, 0.0);
    EXPECT_EQ(inParallel.vertexDistances, found.vertexDistances);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, LaterSources, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
INSTANTIATE_TEST_SUITE_P(Kinds, FarthestPoints, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
