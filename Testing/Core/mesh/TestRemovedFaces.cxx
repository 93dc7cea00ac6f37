// SPDX-License-Identifier: BSD-3-Clause
// Faces without area are removed before there is a mesh: distances on what is left are those by
// brute force on the same surface cut without them. GEODESIC_TEST_SEEDS=FIRST,COUNT takes other
// seeds.
#include "EngineSupport.h"
#include "RanksSupport.h"
#include "Seeds.h"
#include "truth/CappedMeshes.h"

#include "mesh/FacesWithoutArea.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <string>

using namespace geodesictest;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// The distance from one point of a surface to each.
std::vector<double> distancesFrom(Index source, const CleanedMesh& cleaned)
{
  const TriangleMesh engine = engineMesh(cleaned.mesh);
  const std::vector<double> found = geodesic::solve(
    engine, { geodesic::pointCurve(SurfacePoint::atVertex(cleaned.vertexOf[source])) })
                                      .vertexDistances();
  std::vector<double> distances;
  for (const Index vertex : cleaned.vertexOf)
  {
    distances.push_back(found[vertex]);
  }
  return distances;
}

std::vector<double> trueDistancesFrom(Index source, const PlainMesh& mesh)
{
  Sources sources;
  sources.points = { vertexPoint(mesh, source) };
  return bruteForceDistances(mesh, sources).vertices;
}

} // anonymous namespace

// A path bends at vertex 5, the middle corner of face 2 5 3, and crosses that face.
TEST(RemovedFaces, APathBendsAtTheMiddleCornerOfACap)
{
  PlainMesh mesh;
  mesh.points = { { 0, 12, 0 }, { 0, 16, 0 }, { 4, 12, 2 }, { 4, 16, 2 }, { 8, 12, 2 },
    { 4, 14, 2 }, { 16.0 / 3.0, 14, 3 } };
  mesh.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 3, 5, 6 }, { 5, 4, 6 }, { 2, 5, 3 } };
  const CleanedMesh cleaned = withoutFlatFaces(mesh);
  EXPECT_EQ(facesWithoutArea(cleaned.mesh), 0U);
  const double truth = std::sqrt(20.0) + std::sqrt(24.0);
  EXPECT_NEAR(distancesFrom(4, cleaned)[1], truth, 1e-13);
  EXPECT_NEAR(distancesFrom(1, cleaned)[4], truth, 1e-13);
}

namespace
{

/// How far corners of caps are moved off their edges, as fractions of the size.
constexpr double Offsets[] = { 0.0, 1e-17, 1e-16, 1e-15, 1e-14, 5e-14, 1e-13, 2e-13, 5e-13, 1e-12 };

void compareCaps(Caps caps, std::uint64_t firstSeed)
{
  double worst = 0.0;
  const Seeds seeds = seedsOfTest(100);
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    Random random(seed + firstSeed);
    const PlainMesh plain = bumpySheet(random.between(1, 4), random.between(1, 4),
      random.chance(0.3) ? 1 : 0, random.uniform(0.0, 3.0), random);
    CappedMesh both = withCaps(plain, caps, random.uniform(0.3, 1.0), random);
    const double offset = Offsets[random.below(std::size(Offsets))];
    SCOPED_TRACE(
      "seed " + std::to_string(seed) + ", offset " + std::to_string(1e16 * offset) + "e-16");
    for (std::size_t i = plain.points.size(); i < both.mesh.points.size(); ++i)
    {
      for (double& x : both.mesh.points[i])
      {
        x += offset * random.uniform(-1.0, 1.0);
      }
    }
    both.conforming.points = both.mesh.points;
    const CleanedMesh cleaned = withoutFlatFaces(both.mesh);
    const Index source = random.below(both.mesh.points.size());
    const std::vector<double> truth = trueDistancesFrom(source, both.conforming);
    const double error =
      worstError(distancesFrom(source, cleaned), truth, std::max(1.0, largestFinite(truth)));
    EXPECT_LE(error, 1e-10);
    worst = std::max(worst, error);
  }
  std::cout << "worst relative error " << worst << "\n";
}

} // anonymous namespace

TEST(RemovedFaces, DistancesAcrossOneCapAnEdgeAreThoseWithoutIt)
{
  compareCaps(Caps::One, 700000);
}

TEST(RemovedFaces, DistancesAcrossSeveralCapsAnEdgeAreThoseWithoutThem)
{
  compareCaps(Caps::Several, 800000);
}

namespace
{

/// \param add (mesh, random) -> the mesh with faces without area, cleaned: its first points are the
///        mesh's, whose distances do not change.
template <typename Add>
void expectNoChange(std::uint64_t firstSeed, const Add& add)
{
  double worst = 0.0;
  const Seeds seeds = seedsOfTest(100);
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + firstSeed);
    const PlainMesh plain =
      bumpySheet(random.between(1, 4), random.between(1, 4), 0, random.uniform(0.0, 3.0), random);
    const CleanedMesh cleaned = add(plain, random);
    const Index source = random.below(plain.points.size());
    const std::vector<double> truth = trueDistancesFrom(source, plain);
    std::vector<double> found = distancesFrom(source, cleaned);
    for (const double distance : found)
    {
      EXPECT_TRUE(std::isfinite(distance));
    }
    found.resize(plain.points.size());
    const double error = worstError(found, truth, largestFinite(truth));
    EXPECT_LE(error, 1e-10);
    worst = std::max(worst, error);
  }
  std::cout << "worst relative error " << worst << "\n";
}

} // anonymous namespace

TEST(RemovedFaces, PocketsChangeNoDistance)
{
  expectNoChange(900000,
    [](const PlainMesh& plain, Random& random)
    { return withoutFlatFaces(withPockets(plain, random.between(1, 6), random)); });
}

namespace
{

/// Opens vertices: each becomes two at one place, with needles between that join their faces again.
/// Truth is the mesh before.
PlainMesh withNeedles(const PlainMesh& mesh, double fraction, Random& random)
{
  PlainMesh result = mesh;
  const std::size_t count = mesh.triangles.size();
  for (Index v = 0; v < mesh.points.size(); ++v)
  {
    if (!random.chance(fraction))
    {
      continue;
    }
    const auto other = static_cast<Index>(result.points.size());
    result.points.push_back(result.points[v]);
    // One face takes the new vertex; at both of its edges there a needle joins it to the others.
    for (std::size_t f = 0; f < count; ++f)
    {
      Triangle& t = result.triangles[f];
      const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin());
      if (k < 3)
      {
        t[k] = other;
        const Triangle before = t;
        result.triangles.push_back({ v, before[(k + 1) % 3], other });
        result.triangles.push_back({ v, other, before[(k + 2) % 3] });
        break;
      }
    }
  }
  return result;
}

} // anonymous namespace

TEST(RemovedFaces, NeedlesChangeNoDistance)
{
  expectNoChange(950000,
    [](const PlainMesh& plain, Random& random)
    {
      const CleanedMesh cleaned =
        withoutFlatFaces(withNeedles(plain, random.uniform(0.1, 1.0), random));
      EXPECT_EQ(facesWithoutArea(cleaned.mesh), 0U);
      return cleaned;
    });
}

// Two squares side by side that share no point of their common side from (1, 0) to (1, 1), but for
// a needle that joins their points at (1, 0) above a third square below: the slit above stays open.
TEST(RemovedFaces, ANeedleClosesNoSlitBesideIt)
{
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 2, 0, 0 },
    { 2, 1, 0 }, { 1, 1, 0 }, { 1, -1, 0 } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 }, { 1, 8, 4 }, { 0, 8, 1 },
    { 8, 5, 4 } };
  // The tops of the slit are one vertex, so that its sides would become one edge.
  for (Triangle& t : mesh.triangles)
  {
    std::replace(t.begin(), t.end(), Index(7), Index(2));
  }
  const CleanedMesh cleaned = withoutFlatFaces(mesh);
  EXPECT_EQ(cleaned.vertexOf[4], cleaned.vertexOf[1]);
  const TriangleMesh engine = engineMesh(cleaned.mesh);
  // From the middle of one side to the middle of the other: around an end, not across.
  const std::vector<double> distances = distancesFrom(0, cleaned);
  EXPECT_NEAR(distances[5], 2.0, 1e-15);
  EXPECT_NEAR(distances[6], 1.0 + std::sqrt(2.0), 1e-15); // by (1, 0), or by (1, 1)
  for (geodesic::Id halfedge = 0; halfedge < engine.numberOfHalfedges(); ++halfedge)
  {
    const auto isAtSlit = [&](geodesic::Id vertex)
    { return engine.point(vertex)[0] == 1.0 && engine.point(vertex)[1] >= 0.0; };
    if (isAtSlit(engine.origin(halfedge)) && isAtSlit(engine.destination(halfedge)))
    {
      EXPECT_TRUE(engine.isBoundary(halfedge));
    }
  }
}

// Faces on a line of their own: one hangs at a vertex, one is the bridge to another part.
TEST(RemovedFaces, HangingFacesAndBridgesConductAlongTheirLines)
{
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 3, 0, 0 }, { 2, 0, 0 }, { 4, 0, 0 },
    { 3, 1, 0 }, { 0, 3, 0 }, { 0, 2, 0 } };
  mesh.triangles = { { 0, 1, 2 }, { 1, 4, 3 }, { 3, 5, 6 }, { 2, 7, 8 } };
  const CleanedMesh cleaned = withoutFlatFaces(mesh);
  const std::vector<double> truth = { 0, 1, 1, 3, 2, 4, 1.0 + std::sqrt(5.0), 3, 2 };
  const std::vector<double> found = distancesFrom(0, cleaned);
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    EXPECT_NEAR(found[i], i == 6 ? 3.0 + 1.0 : truth[i], 1e-14) << i;
  }
}

// All corners on one line, and no face with area: every point is reached along the line.
TEST(RemovedFaces, ASurfaceOfSegmentsConductsAlongItsLine)
{
  Random random(3);
  for (int n = 0; n < 200; ++n)
  {
    PlainMesh line = { { { 0, 0, 0 }, { 1, 2, 3 } }, {} };
    std::vector<double> at = { 0.0, 1.0 };
    const Index count = random.between(3, 12);
    for (Index i = 2; i < count; ++i)
    {
      at.push_back(random.uniform(0.01, 0.99));
      line.points.push_back({ at.back(), 2 * at.back(), 3 * at.back() });
      line.triangles.push_back(random.chance(0.5) ? Triangle{ 0, 1, i } : Triangle{ i, 0, 1 });
    }
    const Index source = random.below(count);
    const std::vector<double> found = distancesFrom(source, withoutFlatFaces(line));
    for (Index i = 0; i < count; ++i)
    {
      EXPECT_NEAR(found[i], std::abs(at[i] - at[source]) * std::sqrt(14.0), 1e-10) << n;
    }
  }
}

namespace
{

/// The places of the corners of each face, in an order that does not depend on ranks.
using FaceSet = std::multiset<std::array<Vec3, 3>>;

void addFaces(
  const geodesic::CutTriangles& cut, const std::vector<geodesic::Vec3>& points, FaceSet& faces)
{
  for (std::size_t i = 0; i < cut.parts.size(); ++i)
  {
    if (cut.areFaces[i])
    {
      std::array<Vec3, 3> places = { points[cut.parts[i][0]], points[cut.parts[i][1]],
        points[cut.parts[i][2]] };
      std::sort(places.begin(), places.end());
      faces.insert(places);
    }
  }
}

FaceSet facesOnRanks(const CutMesh& cut)
{
  FaceSet faces;
  std::mutex mutex;
  MemoryRanks(cut.numberOfRanks)
    .run(
      [&](geodesic::Exchange& exchange)
      {
        std::vector<geodesic::Vec3> points;
        std::vector<std::uint64_t> keys;
        std::vector<geodesic::Triangle> triangles;
        std::map<Index, geodesic::Id> numbers;
        for (std::size_t f = 0; f < cut.mesh.triangles.size(); ++f)
        {
          if (cut.rankOfFace[f] == exchange.rank())
          {
            geodesic::Triangle& t = triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k)
            {
              const Index v = cut.mesh.triangles[f][k];
              const auto [found, isNew] =
                numbers.emplace(v, static_cast<geodesic::Id>(points.size()));
              if (isNew)
              {
                points.push_back(cut.mesh.points[v]);
                keys.push_back(v);
              }
              t[k] = found->second;
            }
          }
        }
        const geodesic::CutTriangles result = geodesic::removeFacesWithoutArea(
          points, keys, cut.mesh.points.size(), triangles, {}, exchange);
        const std::lock_guard<std::mutex> lock(mutex);
        addFaces(result, points, faces);
      });
  return faces;
}

} // anonymous namespace

TEST(RemovedFaces, RanksHaveTheFacesOfOneProcess)
{
  const Seeds seeds = seedsOfTest(60);
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + 970000);
    const PlainMesh plain =
      bumpySheet(random.between(1, 4), random.between(1, 4), 0, random.uniform(0.0, 3.0), random);
    const PlainMesh mesh = random.chance(0.5) ? withCaps(plain, Caps::Several, 0.7, random).mesh
      : random.chance(0.5)                    ? withPockets(plain, random.between(1, 6), random)
                                              : withNeedles(plain, 0.5, random);
    std::vector<geodesic::Vec3> points(mesh.points.begin(), mesh.points.end());
    std::vector<std::uint64_t> keys;
    FaceSet truth;
    const geodesic::CutTriangles whole = geodesic::removeFacesWithoutArea(
      points, keys, points.size(), mesh.triangles, {}, geodesic::OneRank::instance());
    ASSERT_FALSE(whole.isEmpty());
    addFaces(whole, points, truth);
    for (const int ranks : { 2, 3, 5 })
    {
      EXPECT_TRUE(facesOnRanks(cutAtRandom(mesh, ranks, random)) == truth) << ranks << " ranks";
    }
  }
}
