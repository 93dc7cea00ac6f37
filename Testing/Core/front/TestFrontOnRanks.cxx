// SPDX-License-Identifier: BSD-3-Clause
// The front over several ranks in one process: it finds the field of the whole surface for any cut.
#include "RanksSupport.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <mutex>
#include <set>

using namespace geodesictest;

namespace
{

// Few: paths, isolines and refinement on ranks are held against the truth, too.
constexpr std::uint64_t MeshesOfAKind = meshesOfAKind(2);

class FrontOnRanks : public ::testing::TestWithParam<MeshKind>
{
};

/// The front's distances on the surface in one piece.
std::vector<double> inOnePiece(const RandomCase& c, const geodesic::FrontOptions& options)
{
  const geodesic::TriangleMesh mesh = engineMesh(c.mesh);
  return solve(mesh, engineCurves(mesh, c.curves), options).vertexDistances();
}

/// A random surface without the faces of its barriers, which are single faces, or all around some
/// vertices.
RandomCase caseWithBarriers(const MeshKind& kind, std::uint64_t seed)
{
  Random random(seed);
  PlainMesh mesh = kind.make(random.between(30, 200), random);
  const double share = random.uniform(0.02, 0.5);
  std::vector<bool> isMarked(mesh.points.size(), false);
  const bool areAroundVertices = random.chance(0.5);
  for (std::size_t i = 0; i < isMarked.size(); ++i)
  {
    isMarked[i] = areAroundVertices && random.chance(0.3 * share);
  }
  std::vector<Triangle> open = { mesh.triangles.front() };
  for (std::size_t f = 1; f < mesh.triangles.size(); ++f)
  {
    const Triangle& t = mesh.triangles[f];
    const bool isBarrier =
      areAroundVertices ? isMarked[t[0]] || isMarked[t[1]] || isMarked[t[2]] : random.chance(share);
    if (!isBarrier)
    {
      open.push_back(t);
    }
  }
  mesh.triangles = std::move(open);
  RandomCase result;
  result.mesh = std::move(mesh);
  result.curves = CurveMaker(result.mesh, random).anySource();
  result.truth = bruteForceDistances(result.mesh, toSources(result.curves), {});
  return result;
}

std::size_t countDifferent(const std::vector<double>& a, const std::vector<double>& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    count += a[i] == b[i] ? 0 : 1;
  }
  return count;
}

}

TEST_P(FrontOnRanks, FindsTheFieldOfTheWholeSurfaceForAnyCut)
{
  double worst = 0.0;
  std::size_t different = 0;
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    const RandomCase c = randomCase(GetParam(), seed, 0);
    const std::vector<double> whole = inOnePiece(c, {});
    const double largest = largestFinite(c.truth.vertices);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    forEachCut(c.mesh, bothWaysToCut({ 1, 2, 4, 7 }), random,
      [&](const CutMesh& cut)
      {
        const RanksResult result = distancesOnRanks(cut, c.curves, {});
        EXPECT_LE(worstError(result.vertices, c.truth.vertices, largest), accuracyOn(GetParam()));
        const double error = worstError(result.vertices, whole, largest);
        EXPECT_LE(error, 1e-12);
        worst = std::max(worst, error);
        different += countDifferent(result.vertices, whole);
        compared += whole.size();
      });
  }
  std::cout << GetParam().name << ": worst difference from one piece " << worst << ", " << different
            << " of " << compared << " distances have other bits\n";
}

// Of faces of two ranks on the same vertices the lower rank's remains. The other rank has no other
// face at vertex 1.
TEST(FrontOnTwoRanks, ASourceIsAtAVertexOfAFaceThatTheOtherRankHasToo)
{
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 2, 0 } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 2 }, { 3, 2, 4 } };
  Random random(1);
  const Polyline source = CurveMaker(mesh, random).point(vertexPoint(mesh, 1));
  const std::vector<double> found =
    distancesOnRanks({ mesh, 2, { 0, 0, 1, 1 } }, { source }, {}).vertices;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], spaceDistance(mesh.points[i], mesh.points[1]), 1e-15) << i;
  }
}

TEST_P(FrontOnRanks, FindsTheFieldBesideBarriersForAnyCut)
{
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    const RandomCase c = caseWithBarriers(GetParam(), seed);
    const std::vector<double> whole = inOnePiece(c, {});
    const double largest = largestFinite(c.truth.vertices);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    forEachCut(c.mesh, bothWaysToCut({ 2, 7 }), random,
      [&](const CutMesh& cut)
      {
        const RanksResult result = distancesOnRanks(cut, c.curves, {});
        EXPECT_LE(worstError(result.vertices, c.truth.vertices, largest), accuracyOn(GetParam()));
        EXPECT_LE(worstError(result.vertices, whole, largest), 1e-12);
      });
  }
}

TEST_P(FrontOnRanks, DoesNotDependOnWhichRankComesFirst)
{
  const RandomCase c = randomCase(GetParam(), 100, 0);
  Random random(1);
  const CutMesh cut = cutAtRandom(c.mesh, 4, random);
  const RanksResult ordered = distancesOnRanks(cut, c.curves, {});
  for (const std::uint64_t disorder : { 1U, 2U, 3U })
  {
    const RanksResult other = distancesOnRanks(cut, c.curves, {}, disorder);
    EXPECT_EQ(ordered.vertices, other.vertices);
    EXPECT_EQ(ordered.windowsPropagated, other.windowsPropagated);
  }
}

TEST_P(FrontOnRanks, KeepsTheCertifiedBound)
{
  geodesic::FrontOptions options;
  options.relativeError = 0.01;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(2); ++seed)
  {
    const RandomCase c = randomCase(GetParam(), seed, 0);
    const double rounding = accuracyOn(GetParam()) * largestFinite(c.truth.vertices);
    Random random(seed);
    for (const int ranks : { 2, 7 })
    {
      const RanksResult result =
        distancesOnRanks(cutInSpace(c.mesh, ranks, random), c.curves, options);
      EXPECT_LE(result.relativeErrorBound, options.relativeError);
      for (std::size_t i = 0; i < result.vertices.size(); ++i)
      {
        const double truth = c.truth.vertices[i];
        ASSERT_EQ(std::isfinite(result.vertices[i]), std::isfinite(truth)) << "vertex " << i;
        if (std::isfinite(truth))
        {
          ASSERT_LE(result.vertices[i], truth + rounding) << "vertex " << i;
          ASSERT_GE(result.vertices[i], truth * (1.0 - result.relativeErrorBound) - rounding)
            << "vertex " << i;
        }
      }
    }
  }
}

TEST_P(FrontOnRanks, StopsAtALimitWhereOneProcessDoes)
{
  for (std::uint64_t seed = 0; seed < meshesOfAKind(2); ++seed)
  {
    const RandomCase c = randomCase(GetParam(), seed, 0);
    const double largest = largestFinite(c.truth.vertices);
    geodesic::FrontOptions options;
    options.maximumDistance = 0.3 * largest;
    const std::vector<double> whole = inOnePiece(c, options);
    Random random(seed);
    for (const int ranks : { 2, 4 })
    {
      const RanksResult result =
        distancesOnRanks(cutInSpace(c.mesh, ranks, random), c.curves, options);
      EXPECT_LE(worstError(result.vertices, whole, largest), 1e-12) << "seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FrontOnRanks, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });

TEST(Ranks, RememberTheSameArrivalAtSharedVerticesWherePathsAreEquallyLong)
{
  // Half of the square's vertices are equally far from both corners.
  const PlainMesh mesh = regularGrid(8, 8);
  std::vector<Polyline> curves;
  for (const Index vertex : { Index(0), Index(8), Index(72), Index(80) })
  {
    Polyline& at = curves.emplace_back();
    for (Index face = 0; face < mesh.triangles.size(); ++face)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (mesh.triangles[face][k] == vertex)
        {
          MeshPoint corner = { face, {} };
          corner.weights[k] = 1.0;
          at = { { { face, corner.weights, corner.weights } }, {} };
        }
      }
    }
  }
  Random random(1);
  forEachCut(mesh, bothWaysToCut({ 2, 3, 4 }), random,
    [&](const CutMesh& cut)
    {
      std::mutex mutex;
      std::map<Index, geodesic::RayOrigin> origins;
      onRanks(cut, curves, 0,
        [&](const RankOfRun& rank)
        {
          geodesic::FrontOptions options;
          options.keepArrivals = true;
          const geodesic::DistanceField field = geodesic::solve(rank.part, rank.sources, options);
          const std::lock_guard<std::mutex> lock(mutex);
          for (geodesic::Id vertex = 0; vertex < rank.part.numberOfOwnVertices(); ++vertex)
          {
            const geodesic::RayOrigin origin = field.arrivals()[vertex].origin;
            const auto at = origins.emplace(rank.part.globalId(vertex), origin).first;
            EXPECT_EQ(at->second, origin) << "vertex " << at->first;
          }
        });
    });
}

TEST(Ranks, AllFailWithTheMessageOfTheRankThatFails)
{
  MemoryRanks ranks(3);
  const auto thrown = ranks.tryRun(
    [](geodesic::Exchange& exchange)
    {
      exchange.leastOf(1.0);
      if (exchange.rank() == 1)
      {
        throw geodesic::MeshError("a point is missing");
      }
      exchange.leastOf(2.0);
    });
  for (const std::exception_ptr& e : thrown)
  {
    ASSERT_TRUE(e);
    try
    {
      std::rethrow_exception(e);
    }
    catch (const geodesic::Error& error)
    {
      EXPECT_STREQ(error.what(), "a point is missing");
    }
  }
}

TEST(Ranks, AnAbortOnOneStopsAll)
{
  RandomCase c = randomCase(meshKinds().front(), 1, 0);
  Random random(1);
  const CutMesh cut = cutInSpace(c.mesh, 3, random);
  EXPECT_THROW(onRanks(cut, c.curves, 0,
                 [](const RankOfRun& rank)
                 {
                   geodesic::FrontOptions options;
                   options.job = geodesic::Job([&](double) { return rank.exchange.rank() != 2; });
                   geodesic::KeepNone none;
                   propagate(rank.part, rank.sources, options, none);
                 }),
    geodesic::Aborted);
}

TEST(Ranks, FacesOnTheSameVerticesAreOneFaceOfTheLowerRank)
{
  // Both ranks have the triangle 0 1 2; rank 1 also has its neighbour.
  MemoryRanks ranks(2);
  ranks.run(
    [](geodesic::Exchange& exchange)
    {
      const bool isFirst = exchange.rank() == 0;
      std::vector<geodesic::Vec3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
      std::vector<geodesic::Triangle> triangles = { { 0, 1, 2 } };
      std::vector<std::uint64_t> keys = { 7, 8, 9 };
      if (!isFirst)
      {
        points.push_back({ 1, 1, 0 });
        triangles = { { 2, 0, 1 }, { 1, 3, 2 } };
        keys.push_back(10);
      }
      const geodesic::MeshPartition part(points, triangles, keys, exchange);
      EXPECT_EQ(part.mesh().numberOfFaces(), 2U);
      EXPECT_EQ(part.numberOfGlobalFaces(), 2U);
      EXPECT_EQ(part.numberOfGlobalVertices(), 4U);
      EXPECT_EQ(part.isOwn(0), isFirst);
      EXPECT_EQ(part.isOwn(1), !isFirst);
    });
}
