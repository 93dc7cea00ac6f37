// SPDX-License-Identifier: BSD-3-Clause
// The brute-force solver, which is the truth for the engine on meshes without an analytic distance,
// against analytic distances.
#include "truth/AnalyticCases.h"
#include "truth/BruteForce.h"
#include "truth/RandomCurves.h"
#include "truth/RandomMeshKinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace geodesictest;

namespace
{

constexpr int Rounds = 40;
/// Of the largest distance.
constexpr double Accuracy = 1e-11;

/// The largest error, relative to the largest distance.
double worstError(
  const std::vector<double>& computed, const std::vector<double>& truth, double largest)
{
  EXPECT_EQ(computed.size(), truth.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    // Written so that not-a-number is an error.
    const double error = std::abs(computed[i] - truth[i]) / largest;
    worst = error <= worst ? worst : error;
  }
  return worst;
}

class BruteForceOn : public ::testing::TestWithParam<AnalyticConfiguration>
{
};

}

TEST_P(BruteForceOn, DistancesAreThoseInClosedForm)
{
  for (int round = 0; round < Rounds; ++round)
  {
    Random random(static_cast<std::uint64_t>(round));
    const AnalyticCase c = GetParam().make(random);
    const BruteForceResult result = bruteForceDistances(c.mesh, c.sources, c.queries);
    const double largest = *std::max_element(c.vertexTruth.begin(), c.vertexTruth.end());
    EXPECT_LE(worstError(result.vertices, c.vertexTruth, largest), Accuracy)
      << "vertices, seed " << round;
    EXPECT_LE(worstError(result.queries, c.queryTruth, largest), Accuracy)
      << "surface points, seed " << round;
  }
}

INSTANTIATE_TEST_SUITE_P(Table, BruteForceOn, ::testing::ValuesIn(analyticConfigurations()),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST(BruteForce, IsTheSameWhenEveryVertexEmits)
{
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    Random random(seed);
    const PlainMesh meshes[] = { bumpySheet(10, 10, 2, 0.6, random), octasphere(6),
      book(4, 6, 4, 0.5, random), moebius(20, 5), needleSheet(8, 8, 1e4, 0.3, random) };
    const PlainMesh& mesh = meshes[seed % 5];
    Sources sources;
    sources.points.push_back(randomPoint(mesh, random));
    sources.segments = { { random.below(mesh.triangles.size()), randomWeights(random),
      randomWeights(random) } };
    BruteForceOptions everyVertex;
    everyVertex.everyVertexEmits = true;
    const BruteForceResult some = bruteForceDistances(mesh, sources);
    const BruteForceResult all = bruteForceDistances(mesh, sources, {}, everyVertex);
    const double largest = *std::max_element(all.vertices.begin(), all.vertices.end());
    EXPECT_LE(worstError(some.vertices, all.vertices, largest), 1e-13) << "seed " << seed;
  }
}

TEST(BruteForce, LeavesOtherComponentsUnreached)
{
  const PlainMesh grid = regularGrid(3, 3);
  const PlainMesh mesh = merged(grid, grid);
  Sources sources;
  sources.points.push_back(vertexPoint(mesh, 0));
  const BruteForceResult result =
    bruteForceDistances(mesh, sources, { { 0, { 0.2, 0.3, 0.5 } }, { 20, { 0.2, 0.3, 0.5 } } });
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    EXPECT_EQ(std::isfinite(result.vertices[v]), v < grid.points.size()) << "vertex " << v;
  }
  EXPECT_TRUE(std::isfinite(result.queries[0]));
  EXPECT_FALSE(std::isfinite(result.queries[1]));
}

TEST(BruteForce, IsExactUpToItsMaximumDistance)
{
  Random random(7);
  const PlainMesh mesh = bumpySheet(16, 16, 2, 0.5, random);
  Sources sources;
  sources.points.push_back(randomPoint(mesh, random));
  BruteForceOptions limited;
  limited.maximumDistance = 5.0;
  const BruteForceResult whole = bruteForceDistances(mesh, sources);
  const BruteForceResult part = bruteForceDistances(mesh, sources, {}, limited);
  EXPECT_LT(part.pencils, whole.pencils);
  std::size_t inside = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    if (whole.vertices[v] <= limited.maximumDistance)
    {
      ++inside;
      EXPECT_NEAR(part.vertices[v], whole.vertices[v], 1e-13) << "vertex " << v;
    }
  }
  EXPECT_GT(inside, 10u);
}

TEST(BruteForce, ConductsThroughFacesOfZeroArea)
{
  // Two squares whose common side runs through a face with its third corner on that side.
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 2, 1, 0 },
    { 1, 0.4, 0 } };
  mesh.triangles = { { 0, 1, 4 }, { 0, 4, 3 }, { 1, 4, 6 }, { 1, 2, 6 }, { 2, 5, 6 }, { 5, 4, 6 } };
  Sources sources;
  sources.points.push_back({ 1, { 0.2, 0.3, 0.5 } });
  const Vec3 source = position(mesh, sources.points[0]);
  const BruteForceResult result = bruteForceDistances(mesh, sources);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const Vec3& p = mesh.points[v];
    EXPECT_NEAR(result.vertices[v], std::hypot(p[0] - source[0], p[1] - source[1]), 1e-14)
      << "vertex " << v;
  }
}

TEST(TestMeshes, OfTheBumpyKindHaveManySaddles)
{
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    Random random(seed);
    const PlainMesh sheet = bumpySheet(20, 20, 3, 0.5, random);
    EXPECT_GE(3 * countSaddles(sheet), sheet.points.size()) << "seed " << seed;
  }
}

TEST(BruteForce, IsZeroAtAPointSourceWithinRoundingOfAnEdge)
{
  // The source belongs to one face; the query is the same place on the edge of the other one.
  Random random(1);
  for (int round = 0; round < 1000; ++round)
  {
    PlainMesh mesh;
    mesh.points = { { 0, 0, 0 }, { random.uniform(0.5, 2.0), random.uniform(), 0 },
      { random.uniform(-0.5, 0.5), 1, random.uniform() }, { 0.5, -1, random.uniform() } };
    mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
    const double t = random.uniform(0.01, 0.99);
    const double off = std::pow(10.0, random.uniform(-20.0, -16.0));
    Sources sources;
    sources.points.push_back({ 0, { 1.0 - t - off, t, off } });
    const BruteForceResult result =
      bruteForceDistances(mesh, sources, { { 1, { t, 1.0 - t, 0.0 } } });
    EXPECT_LE(result.queries[0], 1e-14) << "round " << round;
  }
}

namespace
{

/// The places of other faces that a point within rounding of an edge cannot be told from.
std::vector<MeshPoint> acrossTheEdge(const PlainMesh& mesh, const MeshPoint& point)
{
  std::vector<MeshPoint> places;
  const Triangle& here = mesh.triangles[point.face];
  for (Index k = 0; k < 3; ++k)
  {
    if (point.weights[k] > 1e-15)
    {
      continue;
    }
    const Index a = (k + 1) % 3;
    const Index b = (k + 2) % 3;
    for (Index face = 0; face < mesh.triangles.size(); ++face)
    {
      const Triangle& there = mesh.triangles[face];
      const auto atA = std::find(there.begin(), there.end(), here[a]);
      const auto atB = std::find(there.begin(), there.end(), here[b]);
      if (atA != there.end() && atB != there.end())
      {
        MeshPoint place = { face, { 0.0, 0.0, 0.0 } };
        place.weights[static_cast<std::size_t>(atA - there.begin())] = point.weights[a];
        place.weights[static_cast<std::size_t>(atB - there.begin())] = point.weights[b];
        places.push_back(place);
      }
    }
  }
  return places;
}

}

TEST(BruteForce, IsZeroAtPointSourcesOfRandomPlanarMeshes)
{
  const auto planar = std::find_if(meshKinds().begin(), meshKinds().end(),
    [](const MeshKind& kind) { return std::string(kind.name) == "RandomPlanar"; });
  ASSERT_NE(planar, meshKinds().end());
  std::size_t compared = 0;
  for (std::uint64_t seed = 7000; seed < 7100; ++seed)
  {
    Random random(seed);
    const PlainMesh mesh = planar->make(random.between(50, 250), random);
    Sources sources;
    sources.points.push_back(randomPoint(mesh, random));
    const std::vector<MeshPoint> queries = acrossTheEdge(mesh, sources.points[0]);
    for (double distance : bruteForceDistances(mesh, sources, queries).queries)
    {
      EXPECT_LE(distance, 1e-14) << "seed " << seed;
      ++compared;
    }
  }
  EXPECT_GT(compared, 0u);
}

// The other leg of a right angle leans over the segment by rounding, in one of several faces.
TEST(BruteForce, NoDistanceIsNegativeWhereASegmentEndsAtARightAngle)
{
  for (std::uint64_t seed = 0; seed < 2000; ++seed)
  {
    Random random(seed);
    const PlainMesh mesh =
      box({ random.uniform(0.5, 5.0), random.uniform(0.5, 5.0), random.uniform(0.5, 5.0) },
        { 1, 2, 3 });
    const Index face = random.below(mesh.triangles.size());
    const Index k = random.below(3);
    Barycentric from = { 0.0, 0.0, 0.0 };
    from[k] = random.uniform(0.1, 1.0);
    from[(k + 1) % 3] = 1.0 - from[k];
    Barycentric to = { 0.0, 0.0, 0.0 };
    to[(k + 1) % 3] = 1.0;
    std::vector<MeshPoint> queries;
    for (Index other = 0; other < mesh.triangles.size(); ++other)
    {
      queries.push_back({ other, { 0.5, 0.5, 0.0 } });
      queries.push_back({ other, { 0.0, 0.5, 0.5 } });
      queries.push_back({ other, { 0.5, 0.0, 0.5 } });
    }
    Sources sources;
    sources.segments = { { face, from, to }, { face, to, from } };
    const BruteForceResult result = bruteForceDistances(mesh, sources, queries);
    EXPECT_GE(*std::min_element(result.queries.begin(), result.queries.end()), -1e-14) << seed;
    EXPECT_GE(*std::min_element(result.vertices.begin(), result.vertices.end()), 0.0) << seed;
  }
}
