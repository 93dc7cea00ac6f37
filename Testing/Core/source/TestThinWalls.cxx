// SPDX-License-Identifier: BSD-3-Clause
// A curve beside a thin wall stays on one side of it: points that noise has put beyond the middle
// of the wall follow the others.
#include "RanksSupport.h"
#include "Seeds.h"

#include "source/PolylineLocator.h"
#include "source/SideChoice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <mutex>

namespace
{

using namespace geodesic;
using geodesictest::engineMesh;
using geodesictest::PlainMesh;
using geodesictest::Random;

constexpr double Thickness = 0.2;

PlainMesh plate()
{
  return geodesictest::box({ 100.0, 100.0, Thickness }, { 20, 20, 1 });
}

/// A line 80 long on one side of the plate, with points up to an amplitude off it.
LocatedPolyline noisyLine(double z, double amplitude, Id points, Random& random)
{
  LocatedPolyline line;
  const double y = random.uniform(20.0, 80.0);
  for (Id i = 0; i < points; ++i)
  {
    const double x = 10.0 + 80.0 * i / (points - 1);
    line.points.push_back({ x, y, z + random.uniform(-amplitude, amplitude) });
  }
  line.name = PartName("the source").part("line", 0);
  return line;
}

LocatedPlaces locateOnOneSide(
  const MeshPartition& surface, const std::vector<LocatedPolyline>& lines)
{
  PolylineLocator locator(surface);
  LocatedPlaces located = locator.locate(lines, DBL_EPSILON);
  locator.keepOnOneSide(lines, DBL_EPSILON, located);
  return located;
}

SourceCurves put(const TriangleMesh& mesh, std::vector<LocatedPolyline> lines)
{
  locateOnOneSide(MeshPartition(mesh), lines).setFaces(ReplicatedPatch(mesh), lines);
  return putOntoSurface(mesh, lines, DBL_EPSILON, joinByShortestPaths(mesh));
}

/// The sides of a curve's points: 't'op, 'b'ottom, or 'r' for the rim between them.
std::string sidesOf(const TriangleMesh& mesh, const SourceCurve& curve)
{
  std::string sides;
  for (const SurfacePoint& p : curve.points)
  {
    const double z = position(mesh, p)[2];
    sides += z == Thickness ? 't' : z == 0.0 ? 'b' : 'r';
  }
  return sides;
}

TEST(ThinWalls, ANoisyLineStaysOnItsSide)
{
  const TriangleMesh mesh = engineMesh(plate());
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(40);
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    Random random(seed);
    const bool isOnTop = seed % 2 == 0;
    const LocatedPolyline line =
      noisyLine(isOnTop ? Thickness : 0.0, 0.6 * Thickness, seed % 3 == 0 ? 33 : 201, random);
    const SourceCurves result = put(mesh, { line });
    ASSERT_EQ(result.curves.size(), 1U);
    EXPECT_NEAR(lengthOf(mesh, result.curves[0]), 80.0, 1e-9) << seed;
    const std::string sides = sidesOf(mesh, result.curves[0]);
    EXPECT_EQ(sides, std::string(sides.size(), isOnTop ? 't' : 'b')) << seed;
    EXPECT_LE(result.snapDistance, 0.6 * Thickness + 1e-12);
  }
}

// In a gap between two walls as in a wall.
TEST(ThinWalls, ANoisyLineInAGapStaysOnItsSide)
{
  const PlainMesh lower = geodesictest::box({ 100.0, 100.0, 10.0 }, { 20, 20, 1 });
  PlainMesh upper = lower;
  for (geodesictest::Vec3& p : upper.points)
  {
    p[2] += 10.2;
  }
  const TriangleMesh mesh = engineMesh(geodesictest::merged(lower, upper));
  for (Random& random : geodesictest::EachSeed(10))
  {
    const SourceCurves result = put(mesh, { noisyLine(10.0, 0.12, 101, random) });
    ASSERT_EQ(result.curves.size(), 1U);
    EXPECT_NEAR(lengthOf(mesh, result.curves[0]), 80.0, 1e-9);
  }
}

// A bent wall, and segments much longer than it is thick: a hollow ball, whose inner side no path
// joins to the outer one.
TEST(ThinWalls, ANoisyCircleStaysOnItsSideOfAShell)
{
  const PlainMesh outer = geodesictest::octasphere(24);
  const double thickness = 0.05;
  PlainMesh inner = outer;
  for (geodesictest::Vec3& p : inner.points)
  {
    p = (1.0 - thickness) * p;
  }
  const TriangleMesh mesh = engineMesh(geodesictest::merged(outer, inner));
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    Random random(seed);
    const bool isOutside = seed % 2 == 0;
    LocatedPolyline circle;
    circle.closed = true;
    const int count = seed % 3 == 0 ? 12 : 200; // segments of half a radius, or shorter ones
    for (int i = 0; i < count; ++i)
    {
      const double angle = 6.283185307 * i / count;
      const double r = (isOutside ? 0.999 : 0.949) + 0.6 * thickness * random.uniform(-1.0, 1.0);
      circle.points.push_back(
        { r * std::cos(angle), 0.8 * r * std::sin(angle), 0.6 * r * std::sin(angle) });
    }
    const SourceCurves result = put(mesh, { circle });
    ASSERT_EQ(result.curves.size(), 1U);
    for (const SurfacePoint& p : result.curves[0].points)
    {
      EXPECT_EQ(norm(position(mesh, p)) > 1.0 - 0.5 * thickness, isOutside) << seed;
    }
  }
}

/// Over the top, around the rim at x = 100, and back along the bottom.
LocatedPolyline aroundTheRim(double amplitude, bool hasRim, Random& random)
{
  LocatedPolyline line;
  const auto add = [&](double x, double z) {
    line.points.push_back({ x, 33.0, z + random.uniform(-amplitude, amplitude) });
  };
  for (int i = 0; i <= 60; ++i)
  {
    add(69.5 + 0.5 * i, Thickness);
  }
  if (hasRim)
  {
    line.points.push_back({ 100.0, 33.0, 0.5 * Thickness });
  }
  for (int i = 60; i >= 0; --i)
  {
    add(69.5 + 0.5 * i, 0.0);
  }
  return line;
}

TEST(ThinWalls, ACurveAroundTheRimStaysOnBothSides)
{
  const TriangleMesh mesh = engineMesh(plate());
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    for (const bool hasRim : { false, true })
    {
      Random random(seed);
      const SourceCurves result = put(mesh, { aroundTheRim(0.6 * Thickness, hasRim, random) });
      const SourceCurve& curve = result.curves.at(0);
      // Without a point on the rim, noise moves the change by a point or two.
      EXPECT_NEAR(lengthOf(mesh, curve), 2.0 * 30.5 + Thickness, hasRim ? 1e-9 : 2.1) << seed;
      std::string sides = sidesOf(mesh, curve);
      sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
      EXPECT_TRUE(sides == "tb" || sides == "trb") << sides;
    }
  }
}

namespace
{

/// The places of a line stay on the closest faces.
void expectPlacesStay(const TriangleMesh& mesh, const LocatedPolyline& line)
{
  const std::vector<LocatedPolyline> lines = { line };
  PolylineLocator locator{ MeshPartition(mesh) };
  const LocatedPlaces before = locator.locate(lines, DBL_EPSILON);
  LocatedPlaces after = before;
  locator.keepOnOneSide(lines, DBL_EPSILON, after);
  for (std::size_t i = 0; i < before.faces.size(); ++i)
  {
    ASSERT_EQ(after.faces[i].size(), before.faces[i].size());
    EXPECT_EQ(after.faces[i].front().face.id, before.faces[i].front().face.id);
  }
}

} // anonymous namespace

// The bottom is as near as a rounding here: there is no choice.
TEST(ThinWalls, PointsOnTheSurfaceStay)
{
  const TriangleMesh mesh = engineMesh(plate());
  Random random(1);
  LocatedPolyline line = noisyLine(Thickness, 0.0, 41, random);
  line.points[10][2] = 0.0;
  line.points[20] = { 50.0, 50.0, 0.0 }; // a vertex
  line.points[30][2] = DBL_EPSILON;
  expectPlacesStay(mesh, line);
}

/// A place that two curves share, or that a curve returns to, has one side for all.
TEST(ThinWalls, APlaceOfSeveralPointsHasOneSide)
{
  const TriangleMesh mesh = engineMesh(plate());
  for (Random& random : geodesictest::EachSeed(10))
  {
    std::vector<LocatedPolyline> lines = { noisyLine(Thickness, 0.12, 81, random), {} };
    lines[0].points[40][2] = 0.09; // closer to the bottom
    lines[1] = lines[0];
    for (Vec3& p : lines[1].points)
    {
      p = { p[1], p[0], p[2] };
    }
    lines[1].points[40] = lines[0].points[40];
    // A triangle that returns to its first point.
    lines.push_back({});
    lines.back().points = { { 50.3, 50.2, 0.09 }, { 60.0, 50.0, 0.21 }, { 55.0, 60.0, 0.21 },
      { 50.3, 50.2, 0.09 } };
    lines.push_back({});
    lines.back().points = { { 20.3, 50.2, 0.09 }, { 30.0, 50.0, 0.21 }, { 25.0, 60.0, 0.21 } };
    lines.back().closed = true;
    for (const SourceCurve& curve : put(mesh, lines).curves)
    {
      const std::string sides = sidesOf(mesh, curve);
      EXPECT_EQ(sides, std::string(sides.size(), 't'));
    }
  }
}

// Noise larger than the wall's thickness is not recognised, but told.
TEST(ThinWalls, ADetourIsTold)
{
  const TriangleMesh mesh = engineMesh(plate());
  LocatedPolyline line;
  line.points = { { 40.0, 50.5, 0.2 }, { 45.0, 50.5, 0.2 }, { 45.0, 50.5, 0.2 },
    { 50.0, 50.5, 0.0 }, { 55.0, 50.5, 0.0 }, { 60.0, 50.5, 0.2 } };
  SourceCurves result = put(mesh, { LocatedPolyline(line), line });
  ASSERT_EQ(result.detours.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(result.detours[i].polyline, i / 2);
    EXPECT_EQ(result.detours[i].segment, i % 2 == 0 ? 2U : 4U);
  }
  // From (45, 50.5) to (50, 50.5) around the nearest edge, x = 0, y = 100 or x = 100, and back.
  const double way = std::min(
    { 45.0 + 50.0 + Thickness, std::hypot(2.0 * 49.5 + Thickness, 5.0), 55.0 + 50.0 + Thickness });
  // From (55, 50.5) to (60, 50.5).
  const double wayBack = 45.0 + 40.0 + Thickness;
  EXPECT_NEAR(result.largestDetour, std::max(way, wayBack) / std::hypot(5.0, Thickness), 1e-9);
  // A way around the edge that is not much longer.
  line.points = { { 98.0, 50.5, 0.2 }, { 100.0, 50.5, 0.1 }, { 98.0, 50.5, 0.0 } };
  EXPECT_TRUE(put(mesh, { line }).detours.empty());
  // Far points of a curve on a ball: at most half around.
  const TriangleMesh ball = engineMesh(geodesictest::octasphere(8));
  line.points = { { 1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  result = put(ball, { line });
  EXPECT_TRUE(result.detours.empty());
  EXPECT_EQ(result.largestDetour, 0.0);
}

// The thickness of a ball is no thin wall: a line through it changes sides where it passes the
// centre.
TEST(ThinWalls, ALineThroughABallChangesSidesAtItsCentre)
{
  const TriangleMesh mesh = engineMesh(geodesictest::octasphere(8));
  LocatedPolyline line;
  for (int i = 0; i <= 20; ++i)
  {
    line.points.push_back({ 0.01, 0.02, -0.93 + 0.1 * i });
  }
  expectPlacesStay(mesh, line);
}

TEST(ThinWalls, TheSidesDoNotDependOnHowTheSurfaceIsCut)
{
  const PlainMesh whole = plate();
  const TriangleMesh mesh = engineMesh(whole);
  Random random(5);
  std::vector<LocatedPolyline> lines;
  for (int i = 0; i < 3; ++i)
  {
    lines.push_back(noisyLine(Thickness, 0.12, 81, random));
    lines.push_back(noisyLine(0.0, 0.14, 41, random));
  }
  lines.push_back(aroundTheRim(0.12, true, random));
  const LocatedPlaces truth = locateOnOneSide(MeshPartition(mesh), lines);
  geodesictest::forEachCut(whole, geodesictest::someWaysToCut(), random,
    [&](const geodesictest::CutMesh& cut)
    {
      geodesictest::onRanks(cut, {}, 0,
        [&](const geodesictest::RankOfRun& rank)
        {
          const LocatedPlaces here = locateOnOneSide(rank.part, lines);
          std::size_t different = here.faces.size() == truth.faces.size() ? 0 : 1;
          for (std::size_t i = 0; i < truth.faces.size() && different == 0; ++i)
          {
            std::vector<Id> a;
            std::vector<Id> b;
            for (const ClosestFace& face : truth.faces[i])
            {
              a.push_back(face.face.id);
            }
            for (const ClosestFace& face : here.faces[i])
            {
              b.push_back(static_cast<Id>(geodesictest::wholeFaceOf(rank, face.face)));
            }
            std::sort(b.begin(), b.end());
            different += a == b ? 0 : 1;
          }
          static std::mutex mutex;
          const std::lock_guard<std::mutex> lock(mutex);
          EXPECT_EQ(different, 0U);
        });
    });
}

}
