// SPDX-License-Identifier: BSD-3-Clause
// The front on several threads has the bits of the front on one, which other tests compare with the
// truth.
#include "EngineSupport.h"
#include "OnThreads.h"
#include "truth/RandomMeshKinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;
using geodesic::Job;
using geodesic::KeepWindows;
using geodesic::TriangleMesh;

namespace
{

/// Counts the calls with more than one task.
class Threads
{
public:
  geodesic::ParallelFor parallelFor()
  {
    return [this](std::size_t count, const std::function<void(std::size_t)>& task,
             const std::function<void()>&)
    {
      ++this->shared_;
      onThreads(count, task);
    };
  }
  std::size_t shared() const { return this->shared_; }

private:
  std::size_t shared_ = 0;
};

class ParallelFront : public ::testing::TestWithParam<MeshKind>
{
};

}

// On meshes of several districts; also with windows kept, and within a limit.
TEST_P(ParallelFront, GivesTheBitsOfOneThread)
{
  Threads threads;
  for (Random& random : EachSeed(meshesOfAKind(3), 82000))
  {
    const PlainMesh mesh = GetParam().make(4000, random);
    CurveMaker maker(mesh, random);
    const TriangleMesh engine = engineMesh(mesh);
    const std::vector<geodesic::SourceCurve> curves = engineCurves(engine, maker.anySource());
    const std::vector<MeshPoint> queries = randomPoints(mesh, 200, random);
    for (const double relativeError : { 0.0, 0.01 })
    {
      geodesic::FrontOptions options;
      options.relativeError = relativeError;
      options.keepArrivals = true;
      const DistanceField alone = geodesic::solve(engine, curves, options, KeepWindows::All);
      options.job = Job({}, threads.parallelFor());
      const DistanceField shared = geodesic::solve(engine, curves, options, KeepWindows::All);
      EXPECT_EQ(alone.vertexDistances(), shared.vertexDistances());
      EXPECT_EQ(alone.vertexDistances(), geodesic::solve(engine, curves, options).vertexDistances())
        << "without windows";
      EXPECT_EQ(alone.relativeErrorBound(), shared.relativeErrorBound());
      EXPECT_EQ(alone.windowsPropagated(), shared.windowsPropagated());
      EXPECT_EQ(valuesOf(alone, queries).queries, valuesOf(shared, queries).queries);
      for (Id vertex = 0; vertex < engine.numberOfVertices(); ++vertex)
      {
        ASSERT_EQ(alone.arrivals()[vertex].halfedge, shared.arrivals()[vertex].halfedge);
        ASSERT_EQ(alone.arrivals()[vertex].x, shared.arrivals()[vertex].x);
      }
      options.maximumDistance = 0.3 * largestFinite(alone.vertexDistances());
      const DistanceField sharedLimited = geodesic::solve(engine, curves, options);
      options.job = {};
      const DistanceField limited = geodesic::solve(engine, curves, options);
      EXPECT_EQ(limited.vertexDistances(), sharedLimited.vertexDistances());
    }
  }
  EXPECT_GT(threads.shared(), 100U) << "hardly a batch was shared";
}

INSTANTIATE_TEST_SUITE_P(Kinds, ParallelFront, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

// Sources on a grid, the last ones first: many vertices are equally far from sources of two blocks,
// and arrive at the one that comes first.
TEST(ParallelFrontOfManySources, HasTheArrivalsOfOneThreadWhereSourcesAreEquallyFar)
{
  const Index n = 48;
  const PlainMesh mesh = regularGrid(n, n);
  const TriangleMesh engine = engineMesh(mesh);
  std::vector<Polyline> sources;
  for (Index i = n / 2 + 1; i-- > 0;)
  {
    for (Index j = n / 2 + 1; j-- > 0;)
    {
      const MeshPoint p = vertexPoint(mesh, 2 * (i * (n + 1) + j));
      sources.push_back({ { { p.face, p.weights, p.weights } }, {} });
    }
  }
  const std::vector<geodesic::SourceCurve> curves = engineCurves(engine, sources);
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  const DistanceField alone = geodesic::solve(engine, curves, options);
  Threads threads;
  options.job = Job({}, threads.parallelFor());
  const DistanceField shared = geodesic::solve(engine, curves, options);
  EXPECT_GT(threads.shared(), 0U);
  for (Id vertex = 0; vertex < engine.numberOfVertices(); ++vertex)
  {
    EXPECT_EQ(alone.arrivals()[vertex].halfedge, shared.arrivals()[vertex].halfedge)
      << "vertex " << vertex;
    EXPECT_EQ(alone.arrivals()[vertex].x, shared.arrivals()[vertex].x) << "vertex " << vertex;
  }
}

// Steep spikes: many batches of few windows.
TEST(ParallelFrontWherePaying, ANarrowFrontWakesNobody)
{
  Random random(84000);
  const TriangleMesh engine = engineMesh(bumpySheet(24, 24, 1, 10.0, random));
  const std::vector<geodesic::SourceCurve> curves = { geodesic::pointCurve(
    geodesic::SurfacePoint::atVertex(0)) };
  for (const double relativeError : { 0.0, 0.01 })
  {
    geodesic::FrontOptions options;
    options.relativeError = relativeError;
    Threads always;
    options.job = Job({}, always.parallelFor());
    const DistanceField shared = geodesic::solve(engine, curves, options, KeepWindows::All);
    EXPECT_GT(always.shared(), 100U);
    Threads where;
    options.job = Job({}, where.parallelFor(), Job::Sharing::WherePaying);
    const DistanceField alone = geodesic::solve(engine, curves, options, KeepWindows::All);
    EXPECT_EQ(where.shared(), 0U);
    EXPECT_EQ(alone.vertexDistances(), shared.vertexDistances());
  }
}

// The front is wide in the squares, narrow in the strips between them. Where it becomes wide, a
// trial splits it; the time decides where that is, and where it is joined again.
TEST(ParallelFrontWherePaying, HasTheBitsOfOneThreadWhereverItIsSplitAndJoined)
{
  Random random(83000);
  PlainMesh mesh = bumpySheet(400, 60, 3, 0.3, random);
  const auto isCutAway = [&mesh](const auto& triangle)
  {
    const auto& p = mesh.points[triangle[0]];
    return std::fmod(p[0], 100.0) > 80.0 && p[1] > 2.0;
  };
  mesh.triangles.erase(
    std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), isCutAway), mesh.triangles.end());
  const TriangleMesh engine = engineMesh(mesh);
  const std::vector<geodesic::SourceCurve> curves = { geodesic::pointCurve(
    geodesic::SurfacePoint::atVertex(engine.triangle(0)[0])) };
  const std::vector<MeshPoint> queries = randomPoints(mesh, 1000, random);
  for (const double relativeError : { 0.0, 0.01 })
  {
    geodesic::FrontOptions options;
    options.relativeError = relativeError;
    const DistanceField alone = geodesic::solve(engine, curves, options, KeepWindows::All);
    Threads threads;
    options.job = Job({}, threads.parallelFor(), Job::Sharing::WherePaying);
    const DistanceField shared = geodesic::solve(engine, curves, options, KeepWindows::All);
    EXPECT_GT(threads.shared(), 0U);
    EXPECT_EQ(alone.vertexDistances(), shared.vertexDistances());
    EXPECT_EQ(alone.windowsPropagated(), shared.windowsPropagated());
    EXPECT_EQ(alone.relativeErrorBound(), shared.relativeErrorBound());
    EXPECT_EQ(valuesOf(alone, queries).queries, valuesOf(shared, queries).queries);
  }
}
