// SPDX-License-Identifier: BSD-3-Clause
// Seams of ranks, in one process, where random scenes seldom have them so; errors and aborts on one
// rank; and real meshes.
#include "RanksResults.h"
#include "refinement/RefinementSupport.h"
#include "truth/MeshFiles.h"

#include "contours/Isolines.h"
#include "contours/SolveForIsolines.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <mutex>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;

namespace
{

Polyline pointSource(const MeshPoint& point)
{
  return { { { point.face, point.weights, point.weights } }, {} };
}

/// The first edge of the first face.
std::vector<Polyline> firstEdge()
{
  return { { { { 0, { 1, 0, 0 }, { 0, 1, 0 } } }, {} } };
}

/// Each row of a grid belongs to another rank.
CutMesh inBands(const PlainMesh& mesh, int ranks)
{
  CutMesh cut = { mesh, ranks, {} };
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
  {
    cut.rankOfFace.push_back(
      static_cast<int>(face * static_cast<std::size_t>(ranks) / mesh.triangles.size()));
  }
  return cut;
}

double lengthOf(const FoundPath& path)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.places.size(); ++i)
  {
    length += spaceDistance(path.places[i - 1], path.places[i]);
  }
  return length;
}

}

TEST(SeamsOfRanks, VerticesWherePathsAreEquallyLongHaveOneArrivalOnAllRanks)
{
  // Half of the square's vertices are equally far from both corners.
  const PlainMesh mesh = regularGrid(8, 8);
  std::vector<Polyline> curves;
  for (const Index vertex : { 0U, 8U, 72U, 80U })
  {
    curves.push_back(pointSource(vertexPoint(mesh, vertex)));
  }
  Random random(1);
  forEachCut(mesh, someWaysToCut(), random,
    [&](const CutMesh& cut)
    {
      std::mutex mutex;
      std::map<geodesic::GlobalId, geodesic::RayOrigin> origins;
      onRanks(cut, curves, 0,
        [&](const RankOfRun& rank)
        {
          geodesic::FrontOptions options;
          options.keepArrivals = true;
          const DistanceField field = geodesic::solve(rank.part, rank.sources, options);
          const std::lock_guard<std::mutex> lock(mutex);
          for (Id vertex = 0; vertex < rank.part.numberOfOwnVertices(); ++vertex)
          {
            const geodesic::RayOrigin origin = field.arrivals()[vertex].origin;
            const auto at = origins.emplace(rank.part.globalId(vertex), origin).first;
            EXPECT_EQ(at->second, origin) << "vertex " << static_cast<Id>(at->first);
          }
        });
    });
}

TEST(SeamsOfRanks, FacesOnTheSameVerticesAreOneFaceOfTheLowerRank)
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

// The other rank has no other face at vertex 1 than that which the lower rank has, too.
TEST(SeamsOfRanks, ASourceIsAtAVertexOfAFaceThatTheOtherRankHasToo)
{
  Scene scene;
  scene.mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 2, 0 } };
  scene.mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 2 }, { 3, 2, 4 } };
  scene.curves = { pointSource(vertexPoint(scene.mesh, 1)) };
  const std::vector<double> found =
    fieldOnRanks({ scene.mesh, 2, { 0, 0, 1, 1 } }, scene).distances;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], spaceDistance(scene.mesh.points[i], scene.mesh.points[1]), 1e-15) << i;
  }
}

TEST(SeamsOfRanks, PathsOfTargetsOnTheSourceAreTwoEqualPoints)
{
  Scene scene;
  scene.mesh = regularGrid(4, 4);
  // At vertices inside and on the boundary, most of which several ranks have.
  for (Index face = 0; face < scene.mesh.triangles.size(); face += 3)
  {
    MeshPoint corner = { face, {} };
    corner.weights[face % 2] = 1.0;
    scene.curves = { pointSource(corner) };
    scene.queries = { corner };
    Random random(face);
    forEachCut(scene.mesh, { { 2, false }, { 3, true }, { 3, false } }, random,
      [&](const CutMesh& cut)
      {
        const FoundPath path = pathsOnRanks(cut, scene).front();
        ASSERT_EQ(path.places.size(), 2U) << "face " << face;
        EXPECT_EQ(path.places.front(), path.places.back());
        EXPECT_EQ(path.source, 0U);
      });
  }
}

// At each edge of three faces the ranks around it are asked anew, whatever those at the last one
// said.
TEST(SeamsOfRanks, PathsAcrossTwoRowsOfEdgesOfThreeFacesAreFollowedToTheSource)
{
  // A sheet with a fin at x = 2 and at x = 4. Each of the five parts goes to a rank of its own
  // choice.
  Scene scene;
  std::vector<std::size_t> partOf;
  const auto addCell = [&](const std::array<Index, 4>& corners, std::size_t part)
  {
    scene.mesh.triangles.push_back({ corners[0], corners[1], corners[2] });
    scene.mesh.triangles.push_back({ corners[0], corners[2], corners[3] });
    partOf.insert(partOf.end(), 2, part);
  };
  for (Index y = 0; y < 4; ++y)
  {
    for (Index x = 0; x < 7; ++x)
    {
      scene.mesh.points.push_back({ 1.0 * x, 1.0 * y, 0.0 });
    }
    scene.mesh.points.push_back({ 2.0, 1.0 * y, 1.0 });
    scene.mesh.points.push_back({ 4.0, 1.0 * y, 1.0 });
  }
  constexpr Index row = 9;
  for (Index y = 0; y < 3; ++y)
  {
    for (Index x = 0; x < 6; ++x)
    {
      const Index corner = row * y + x;
      addCell({ corner, corner + 1, corner + row + 1, corner + row }, x / 2);
    }
    for (const Index fin : { 0U, 1U })
    {
      const Index foot = row * y + 2 + 2 * fin;
      const Index top = row * y + 7 + fin;
      addCell({ foot, foot + row, top + row, top }, 3 + fin);
    }
  }
  const MeshPoint source = { 16, { 0.5, 0.2, 0.3 } }; // in the row of cells in the middle
  scene.curves = { pointSource(source) };
  scene.queries = { { 10, { 0.2, 0.5, 0.3 } }, { 26, { 0.3, 0.4, 0.3 } },
    { 43, { 0.1, 0.3, 0.6 } } };
  for (Random& random : EachSeed(15))
  {
    std::array<int, 5> rankOfPart;
    std::generate(
      rankOfPart.begin(), rankOfPart.end(), [&]() { return static_cast<int>(random.below(3)); });
    CutMesh cut{ scene.mesh, 3, {} };
    for (const std::size_t part : partOf)
    {
      cut.rankOfFace.push_back(rankOfPart[part]);
    }
    const std::vector<FoundPath> paths = pathsOnRanks(cut, scene);
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      EXPECT_FALSE(paths[i].wasLost) << "target " << i;
      EXPECT_NEAR(lengthOf(paths[i]),
        spaceDistance(position(scene.mesh, source), position(scene.mesh, scene.queries[i])), 1e-12);
    }
  }
}

// Triangles in a row that share only vertices: no window goes from one to the next. The known
// distances are short by rounding, by more than the margin of the bounds near the target, where the
// triangles are small.
TEST(SeamsOfRanks, PathsInStripsRunAlongEdgesWhereNoWindowGoes)
{
  constexpr Index Length = 12;
  const auto place = [](Index i) { return i < 10 ? static_cast<double>(i) : 9.0 + 1e-4 * (i - 9); };
  Scene scene;
  PlainMesh& mesh = scene.mesh;
  for (Index i = 0; i <= Length; ++i)
  {
    mesh.points.push_back({ place(i), 0.0, 0.0 });
  }
  for (Index i = 0; i < Length; ++i)
  {
    const double size = place(i + 1) - place(i);
    mesh.points.push_back({ place(i) + 0.5 * size, size, 0.0 });
    mesh.triangles.push_back({ i, i + 1, Length + 1 + i });
  }
  scene.curves = { pointSource(vertexPoint(mesh, 0)) };
  std::vector<double> distances;
  for (const double along : { 0.5, 1.0 })
  {
    scene.queries.push_back({ Length - 1, { 1.0 - along, along, 0.0 } });
    distances.push_back(position(mesh, scene.queries.back())[0] * (1.0 - 1e-12));
  }
  Random random(1);
  for (const int ranks : { 1, 3 })
  {
    const std::vector<FoundPath> paths =
      pathsInStrips(cutAtRandom(mesh, ranks, random), scene, distances);
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      SCOPED_TRACE(std::to_string(ranks) + " ranks, target " + std::to_string(i));
      const std::vector<geodesic::Vec3>& points = paths[i].places;
      ASSERT_EQ(points.size(), Length + 1U);
      EXPECT_LE(spaceDistance(points[0], position(mesh, scene.queries[i])), 1e-14);
      for (Index k = 1; k <= Length; ++k)
      {
        EXPECT_EQ(points[k], mesh.points[Length - k]);
      }
    }
  }
}

TEST(SeamsOfRanks, IsolinesHaveNoDirectionWhereFacesOfOppositeOrientationMeet)
{
  for (const bool isTurned : { false, true })
  {
    // Around a corner of a square; each rank has one half of the square.
    PlainMesh mesh = regularGrid(4, 4);
    CutMesh cut{ mesh, 2, {} };
    for (Triangle& triangle : mesh.triangles)
    {
      const bool isLeft =
        mesh.points[triangle[0]][0] + mesh.points[triangle[1]][0] + mesh.points[triangle[2]][0] <
        6.0;
      cut.rankOfFace.push_back(isLeft ? 0 : 1);
      if (isTurned && !isLeft)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    geodesic::IsolineOptions options;
    options.values = { 3.1 };
    options.chordTolerance = 1e-3;
    onRanks(cut, { pointSource(vertexPoint(mesh, 0)) }, 0,
      [&](const RankOfRun& rank)
      {
        const geodesic::Isolines isolines =
          drawIsolines(solveForIsolines(rank.part, rank.sources, options.values), options);
        EXPECT_EQ(isolines.lines.size(), 1U);
        EXPECT_EQ(isolines.linesWithoutDirection, isTurned ? 1U : 0U);
      });
  }
}

// Faces on seams keep their windows, others do not.
TEST(SeamsOfRanks, RefinementKeepsFewWindowsWhereTheDistanceIsLinear)
{
  const PlainMesh grid = regularGrid(20, 20);
  onRanks(inBands(grid, 2), firstEdge(), 0,
    [&](const RankOfRun& rank)
    {
      const DistanceField field = solveForRefinement(rank.part, rank.sources, 1.0);
      int kept = 0;
      for (Id face = 0; face < rank.part.mesh().numberOfFaces(); ++face)
      {
        kept += field.knowsInside(face) ? 1 : 0;
        EXPECT_TRUE(!field.knowsInside(face) || rank.part.isOwn(face));
      }
      const int atSeam = 20;
      EXPECT_GE(kept, atSeam);
      EXPECT_LE(kept, 3 * atSeam);
    });
}

// Rank 1 owns nothing and still takes part in every step.
TEST(SeamsOfRanks, RefinementEndsWhereARankHasNoFaces)
{
  Scene scene;
  scene.mesh = regularGrid(4, 4);
  scene.curves = { pointSource(vertexPoint(scene.mesh, 0)) };
  scene.tolerance = 0.01;
  CutMesh cut = inBands(scene.mesh, 2);
  std::replace(cut.rankOfFace.begin(), cut.rankOfFace.end(), 1, 2);
  cut.numberOfRanks = 3;
  const Joined joined = refineOnRanks(cut, scene);
  EXPECT_LE(joined.refined.errorBound, scene.tolerance);
  EXPECT_GT(joined.refined.triangles.size(), scene.mesh.triangles.size());
  expectFitTogether(engineMesh(scene.mesh), joined);
}

TEST(FailuresOnRanks, AllFailWithTheMessageOfTheRankThatFails)
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

TEST(FailuresOnRanks, AnAbortOfOneFrontStopsAll)
{
  const PlainMesh grid = regularGrid(10, 10);
  EXPECT_THROW(onRanks(inBands(grid, 3), firstEdge(), 0,
                 [](const RankOfRun& rank)
                 {
                   geodesic::FrontOptions options;
                   options.job = geodesic::Job([&](double) { return rank.exchange.rank() != 2; });
                   geodesic::KeepNone none;
                   propagate(rank.part, rank.sources, options, none);
                 }),
    geodesic::Aborted);
}

// One rank stops in the middle of refinement, before any output.
TEST(FailuresOnRanks, AnAbortOfOneRefinementStopsAll)
{
  const PlainMesh grid = regularGrid(10, 10);
  double last = 0.0;
  EXPECT_THROW(onRanks(inBands(grid, 3), { pointSource(vertexPoint(grid, 0)) }, 0,
                 [&](const RankOfRun& rank)
                 {
                   const DistanceField field = solveForRefinement(rank.part, rank.sources, 1e-5);
                   geodesic::RefinementOptions options;
                   options.tolerance = 1e-5;
                   options.job = geodesic::Job(
                     [&](double done)
                     {
                       const bool isStopped = rank.exchange.rank() == 2 && done > 0.35;
                       if (isStopped)
                       {
                         last = done; // by one rank only: they run at the same time
                       }
                       return !isStopped;
                     });
                   refine(field, options);
                 }),
    geodesic::Aborted);
  EXPECT_GT(last, 0.35);
  EXPECT_LT(last, 0.9);
}

namespace
{

class RealMeshesOnRanks : public ::testing::TestWithParam<const char*>
{
};

}

TEST_P(RealMeshesOnRanks, RefinedPartsFitTogetherWithAsManyTrianglesAsInOnePiece)
{
  if (meshFolder().empty())
  {
    GTEST_SKIP() << noMeshFolder(GetParam());
  }
  Scene scene;
  scene.mesh = readMesh(GetParam());
  ASSERT_FALSE(scene.mesh.triangles.empty());
  const geodesic::TriangleMesh whole = engineMesh(scene.mesh);
  scene.curves = firstEdge();
  const auto curves = engineCurves(whole, scene.curves);
  scene.tolerance = 2e-4 * largestFinite(geodesic::solve(whole, curves).vertexDistances());
  const geodesic::RefinedMesh inOnePiece =
    refineTo(solveForRefinement(whole, curves, scene.tolerance), scene.tolerance);
  Random random(1);
  for (const int ranks : { 2, 5 })
  {
    SCOPED_TRACE(ranks);
    const Joined joined = refineOnRanks(cutInSpace(scene.mesh, ranks, random), scene);
    EXPECT_LE(joined.refined.errorBound, scene.tolerance);
    expectFitTogether(whole, joined);
    const double ratio = static_cast<double>(joined.refined.triangles.size()) /
      static_cast<double>(inOnePiece.triangles.size());
    EXPECT_NEAR(ratio, 1.0, 0.02);
    std::cout << testName(GetParam()) << ": " << joined.refined.triangles.size() << " triangles of "
              << scene.mesh.triangles.size() << " faces, " << ratio
              << " times those of one piece\n";
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, RealMeshesOnRanks, ::testing::Values("spot.obj", "fandisk.obj"),
  [](const auto& file) { return testName(file.param); });
