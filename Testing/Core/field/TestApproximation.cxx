// SPDX-License-Identifier: BSD-3-Clause
// The approximate field compared with the brute-force solver: never above the exact distance, never
// below it by more than the certified bound, which is within the requested one.
#include "EngineSupport.h"
#include "truth/RandomMeshKinds.h"

#include "Errors.h"
#include "front/Front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::TriangleMesh;

namespace
{

constexpr double Epsilons[] = { 1e-4, 1e-3, 1e-2, 1e-1 };
constexpr std::uint64_t MeshesOfAKind = 12;
constexpr std::size_t NumberOfQueries = 60;

class Approximation : public ::testing::TestWithParam<MeshKind>
{
};

}

TEST_P(Approximation, ErrorIsWithinTheBoundAndTheBoundWithinWhatWasAskedFor)
{
  double measured = 0.0;
  double nearest = 0.0;
  for (std::uint64_t seed = 1000; seed < 1000 + MeshesOfAKind; ++seed)
  {
    const auto [mesh, curves, queries, truth] = randomCase(GetParam(), seed, NumberOfQueries);
    const TriangleMesh engine = engineMesh(mesh);
    for (const double epsilon : Epsilons)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", epsilon " + std::to_string(epsilon) + "\n" +
        describe(curves));
      const DistanceField field = solveKeepingAll(engine, engineCurves(engine, curves), epsilon);
      EXPECT_LE(field.relativeErrorBound(), epsilon);
      const double worst =
        expectCertified(field, queries, { truth.vertices, truth.queries }, accuracyOn(GetParam()));
      measured = std::max(measured, worst);
      if (field.relativeErrorBound() > 1e-9)
      {
        nearest = std::max(nearest, worst / field.relativeErrorBound());
      }
    }
  }
  std::cout << "largest relative error on " << GetParam().name << ": " << measured << ", "
            << nearest << " of what was certified\n";
  EXPECT_GT(nearest, 0.5) << "what is certified is far from what occurs";
}

INSTANTIATE_TEST_SUITE_P(Kinds, Approximation, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

namespace
{

PlainMesh bumpySphere()
{
  Random random(5);
  PlainMesh mesh = octasphere(24);
  for (Vec3& p : mesh.points)
  {
    const double factor = 1.0 + 0.05 * random.uniform();
    p = { factor * p[0], factor * p[1], factor * p[2] };
  }
  return mesh;
}

const std::vector<geodesic::SourceCurve> fromFirstVertex = {
  { { geodesic::SurfacePoint::atVertex(0) }, {}, { 0 } }
};

}

TEST(Approximate, WindowsFallWithEveryStepOfEpsilon)
{
  const TriangleMesh mesh = engineMesh(bumpySphere());
  std::uint64_t last = geodesic::solve(mesh, fromFirstVertex).windowsPropagated();
  for (const double epsilon : Epsilons)
  {
    const DistanceField field = solveKeepingAll(mesh, fromFirstVertex, epsilon);
    EXPECT_LT(field.windowsPropagated(), last) << epsilon;
    EXPECT_GT(field.relativeErrorBound(), 0.0);
    last = field.windowsPropagated();
  }
}

TEST(Approximate, EpsilonZeroIsTheExactField)
{
  const TriangleMesh mesh = engineMesh(bumpySphere());
  const DistanceField exact = geodesic::solve(mesh, fromFirstVertex);
  const DistanceField zero = solveKeepingAll(mesh, fromFirstVertex, 0.0);
  EXPECT_EQ(exact.vertexDistances(), zero.vertexDistances());
  EXPECT_EQ(zero.relativeErrorBound(), 0.0);
}

TEST(Approximate, HugeEpsilonStillReachesAllWithinItsBound)
{
  const TriangleMesh mesh = engineMesh(bumpySphere());
  const DistanceField exact = geodesic::solve(mesh, fromFirstVertex);
  const DistanceField huge = solveKeepingAll(mesh, fromFirstVertex, 1e6);
  for (std::size_t v = 0; v < exact.vertexDistances().size(); ++v)
  {
    const double d = exact.vertexDistances()[v];
    EXPECT_LE(huge.vertexDistances()[v], d * (1.0 + OrdinaryAccuracy));
    EXPECT_LE(
      d, huge.vertexDistances()[v] * (1.0 + huge.relativeErrorBound()) * (1.0 + OrdinaryAccuracy));
  }
}

TEST(Approximate, NegativeInfiniteOrNanEpsilonIsRefused)
{
  const TriangleMesh mesh = engineMesh(bumpySphere());
  for (const double epsilon :
    { -1e-3, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_THROW(solveKeepingAll(mesh, fromFirstVertex, epsilon), geodesic::Error);
  }
}

namespace
{

/// Two symmetric surfaces that meet in one vertex (number 4). Below it two sources, whose windows
/// are merged on an edge; above it two corners of a hole, where the same happens again, so that the
/// second error comes on top of the first. The last vertex is the one where both come together.
PlainMesh twoMergesInARow(Random& random)
{
  const double w = random.uniform(0.05, 0.7);
  const double t = random.uniform(1.02, 1.5);
  const double part = random.uniform(0.3, 0.9);
  const Vec3 beside = { part * w + 0.05 * t, part + (1.0 - part) * t + 0.05 * w, 0.0 };
  PlainMesh mesh;
  mesh.points = { { 0.0, -11.0, 0.0 }, { -w, 1.0, 0.0 }, { w, 1.0, 0.0 }, beside, { 0.0, t, 0.0 } };
  // A tiny face, so that the vertex beside is in no batch with the one where the surfaces meet: its
  // windows come along the edge to that vertex before the front does.
  mesh.points.push_back({ beside[0] + 0.01, beside[1], 0.0 });
  mesh.points.push_back({ beside[0] + 0.01, beside[1] + 0.01, 0.0 });
  mesh.triangles = { { 0, 2, 1 }, { 3, 5, 6 }, { 1, 2, 4 }, { 2, 3, 4 } };
  if (random.chance(0.5))
  {
    mesh.triangles.back() = { 3, 2, 4 };
  }

  const double scale = random.uniform(0.1, 1.5);
  const double c = random.uniform(0.2, 2.0);
  const double above = random.uniform(0.02, 0.5);
  const double w2 = c * (1.0 - random.uniform() / (1.0 + above));
  for (const Vec2& p : { Vec2{ -c, 1.0 }, Vec2{ c, 1.0 }, Vec2{ -w2, 2.0 }, Vec2{ w2, 2.0 },
         Vec2{ 0.0, 2.0 + above } })
  {
    mesh.points.push_back({ scale * p[0], t + scale * p[1], 0.0 });
  }
  const Triangle upper[] = { { 4, 9, 7 }, { 4, 8, 10 }, { 7, 8, 10 }, { 7, 10, 9 }, { 9, 10, 11 } };
  mesh.triangles.insert(mesh.triangles.end(), std::begin(upper), std::end(upper));
  return mesh;
}

/// In face 0, at the height of 0.
Sources twoSources(Random& random)
{
  const double u = random.uniform(0.7, 0.9);
  const double y = 11.0 / 12.0;
  const double side = 0.5 * u;
  return { { { 0, { 1.0 - y, 0.5 * y + side, 0.5 * y - side } },
             { 0, { 1.0 - y, 0.5 * y - side, 0.5 * y + side } } },
    {} };
}

}

// The error of merges before a vertex counts behind it, too, even where the vertex got its distance
// along an edge on which a merged window ends.
TEST(Approximate, ErrorsBeforeAndBehindAVertexAddUp)
{
  double measured = 0.0;
  for (Random& random : EachSeed(6000))
  {
    const PlainMesh mesh = twoMergesInARow(random);
    const Sources sources = twoSources(random);
    const TriangleMesh engine = engineMesh(mesh);
    const EngineResult truth = { bruteForceDistances(mesh, sources).vertices, {} };
    for (const double epsilon : { 0.1, 0.3 })
    {
      const DistanceField field = solveKeepingAll(engine, engineCurves(engine, sources), epsilon);
      const double worst = expectCertified(field, {}, truth);
      measured = std::max(measured, worst / std::max(field.relativeErrorBound(), 1e-6));
    }
  }
  EXPECT_GT(measured, 0.9) << "no case comes near its bound";
}
