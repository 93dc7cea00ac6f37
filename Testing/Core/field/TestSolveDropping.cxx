// SPDX-License-Identifier: BSD-3-Clause
// Solving again where windows were dropped that turn out to be needed.
#include "EngineSupport.h"
#include "RanksSupport.h"
#include "truth/RandomCurves.h"

#include "field/SolveDropping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;
using geodesic::MeshPartition;
using geodesic::PinnedFaces;

namespace
{

/// Keeps no windows, and misses those of one face unless it is pinned.
class MissOne : public geodesic::DroppingRetention
{
public:
  MissOne(Id face, const PinnedFaces& pinned)
  {
    if (face != geodesic::NoId && !pinned[face])
    {
      this->missing_ = { face };
    }
  }

  void pass(std::size_t, const geodesic::PassedList& list, Id, geodesic::WindowPool& pool) override
  {
    pool.free(list.windows);
  }
};

Polyline pointSource(const PlainMesh& mesh)
{
  Random random(1);
  return CurveMaker(mesh, random).point(vertexPoint(mesh, 7));
}

/// A sheet with a point as source.
struct Sheet
{
  PlainMesh plain = regularGrid(5, 4);
  geodesic::TriangleMesh mesh = engineMesh(plain);
  std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, { pointSource(plain) });
  std::vector<double> distances = geodesic::solve(mesh, curves).vertexDistances();
};

}

TEST(SolveDropping, SolvesAgainWithTheMissingFacePinned)
{
  const Sheet sheet;
  const MeshPartition surface(sheet.mesh);
  PinnedFaces pinned(sheet.mesh.numberOfFaces(), 0);
  pinned[2] = 1;
  std::size_t solves = 0;
  const DistanceField field = geodesic::solveDropping(surface,
    geodesic::makeSourceWindows(sheet.mesh, sheet.curves, {}), {}, pinned,
    [&](const PinnedFaces& now)
    {
      EXPECT_EQ(now[5], solves);
      ++solves;
      return MissOne(5, now);
    });
  EXPECT_EQ(solves, 2U);
  EXPECT_FALSE(field.hasWindows());
  EXPECT_EQ(field.vertexDistances(), sheet.distances);
  for (Id face = 0; face < sheet.mesh.numberOfFaces(); ++face)
  {
    EXPECT_EQ(pinned[face], face == 2 || face == 5 ? 1 : 0);
  }
}

TEST(SolveDropping, KeepsAllWindowsWhereEachSolveMissesSome)
{
  const Sheet sheet;
  PinnedFaces pinned(sheet.mesh.numberOfFaces(), 0);
  Id solves = 0;
  const DistanceField field = geodesic::solveDropping(MeshPartition(sheet.mesh),
    geodesic::makeSourceWindows(sheet.mesh, sheet.curves, {}), {}, pinned,
    [&](const PinnedFaces& now) { return MissOne(solves++, now); });
  EXPECT_EQ(solves, Id{ geodesic::MostDroppingSolves });
  EXPECT_TRUE(field.hasAllWindows());
  EXPECT_EQ(field.vertexDistances(), sheet.distances);
}

TEST(SolveDropping, AllRanksSolveAgainWhereOneMissesWindows)
{
  const Sheet sheet;
  Random random(1);
  std::mutex mutex;
  onRanks(cutInSpace(sheet.plain, 3, random), { pointSource(sheet.plain) }, 0,
    [&](const RankOfRun& rank)
    {
      const bool misses = rank.exchange.rank() == 1;
      PinnedFaces pinned(rank.part.mesh().numberOfFaces(), 0);
      std::size_t solves = 0;
      geodesic::solveDropping(rank.part, rank.sources, {}, pinned,
        [&](const PinnedFaces& now)
        {
          ++solves;
          return MissOne(misses ? rank.part.firstOwnFace() : geodesic::NoId, now);
        });
      const std::lock_guard<std::mutex> lock(mutex);
      EXPECT_EQ(solves, 2U);
      EXPECT_EQ(std::count(pinned.begin(), pinned.end(), 1), misses ? 1 : 0);
    });
}
