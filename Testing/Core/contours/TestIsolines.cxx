// SPDX-License-Identifier: BSD-3-Clause
// Isolines against the brute-force solver on random meshes of all kinds, with sources of all kinds.
#include "contours/IsolineSupport.h"
#include "truth/RandomMeshKinds.h"

#include "Errors.h"
#include "Tolerance.h"
#include "contours/SolveForIsolines.h"
#include "field/FaceDistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>

using namespace geodesictest;
using geodesic::Isoline;
using geodesic::Isolines;
using geodesic::TriangleMesh;

namespace
{

constexpr std::uint64_t Meshes = meshesOfAKind(12);
constexpr std::uint64_t SmallMeshes = meshesOfAKind(12);
constexpr double ChordFraction = 1e-4;
// Of the triangles in which lines are counted, see LevelTruth.
constexpr int LeastCuts = 6;
constexpr int MostCuts = 13;
constexpr std::size_t UsualTriangles = 10000;
constexpr std::size_t MostTriangles = 200000;

class RandomIsolines : public ::testing::TestWithParam<MeshKind>
{
};

/// A random mesh with sources, and ascending values: some anywhere, some at a vertex's distance.
struct Drawn
{
  PlainMesh plain;
  std::vector<Polyline> curves;
  TriangleMesh mesh;
  double largest;
  std::vector<double> values;

  Drawn(const MeshKind& kind, Index faces, Random& random)
    : plain(kind.make(faces, random))
    , curves(CurveMaker(plain, random).anySource())
    , mesh(engineMesh(plain))
    , largest(0.0)
  {
    const geodesic::DistanceField field =
      geodesic::solve(this->mesh, engineCurves(this->mesh, this->curves));
    const std::vector<double>& distances = field.vertexDistances();
    this->largest = largestFinite(distances);
    this->values = randomValues(distances, this->largest, { 0.001, 0.1, 0.4, 0.8 }, random);
  }

  Isolines draw() const
  {
    const geodesic::DistanceField field =
      solveForIsolines(this->mesh, engineCurves(this->mesh, this->curves), this->values);
    EXPECT_FALSE(field.hasAllWindows()) << "only those that were missing are kept in addition";
    geodesic::IsolineOptions options;
    options.values = this->values;
    options.chordTolerance = ChordFraction * this->largest;
    return geodesic::drawIsolines(field, options);
  }
};

/// Places on the chords of a line, without their ends.
void addPlacesOnChords(const TriangleMesh& mesh, const Isolines& isolines, const Isoline& line,
  std::vector<MeshPoint>& places)
{
  for (std::size_t i = 0; i < line.faces.size(); ++i)
  {
    const auto a = geodesic::barycentric(mesh, isolines.points[line.points[i]], line.faces[i]);
    const auto b = geodesic::barycentric(mesh, isolines.points[line.points[i + 1]], line.faces[i]);
    for (const double t : { 0.2, 0.5, 0.8 })
    {
      MeshPoint place{ mesh.inputFace(line.faces[i]), {} };
      for (std::size_t k = 0; k < 3; ++k)
      {
        place.weights[k] = (1.0 - t) * a[k] + t * b[k];
      }
      places.push_back(place);
    }
  }
}

}

TEST_P(RandomIsolines, PointsAreAtTheValueAndChordsNearIt)
{
  double worstPoint = 0.0;
  double worstChord = 0.0;
  for (Random& random : EachSeed(Meshes, 77000))
  {
    const Drawn drawn(GetParam(), random.between(30, 300), random);
    if (!(drawn.largest > 0.0))
    {
      continue; // the source goes through all vertices
    }
    const Isolines isolines = drawn.draw();
    expectChordsInFaces(drawn.mesh, isolines);
    std::vector<MeshPoint> places;
    std::vector<double> expected;
    for (const Isoline& line : isolines.lines)
    {
      for (const geodesic::Id point : line.points)
      {
        places.push_back(testPoint(drawn.mesh, isolines.points[point]));
      }
      expected.resize(places.size(), drawn.values[line.value]);
    }
    const std::size_t points = places.size();
    for (const Isoline& line : isolines.lines)
    {
      addPlacesOnChords(drawn.mesh, isolines, line, places);
      expected.resize(places.size(), drawn.values[line.value]);
    }
    const std::vector<double> truth =
      bruteForceDistances(drawn.plain, toSources(drawn.curves), places).queries;
    double atPoints = 0.0;
    double atChords = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const double error = std::abs(truth[i] - expected[i]) / drawn.largest;
      (i < points ? atPoints : atChords) = std::max(i < points ? atPoints : atChords, error);
    }
    EXPECT_LE(atPoints, std::max(1e-12, accuracyOn(GetParam()))) << GetParam().name << "\n"
                                                                 << describe(drawn.curves);
    EXPECT_LE(atChords, ChordFraction * (1.0 + 1e-6)) << GetParam().name << "\n"
                                                      << describe(drawn.curves);
    worstPoint = std::max(worstPoint, atPoints);
    worstChord = std::max(worstChord, atChords);
  }
  std::cout << GetParam().name << ": points " << worstPoint << ", chords " << worstChord
            << " of the largest distance\n";
}

// They are drawn without the regular corners where that is possible. Among thin needles rounding
// may lose a window, for which a corner stands: then the ends of lines do not meet, and it is
// added.
TEST_P(RandomIsolines, NeedNoCornersAtWhichNoPathBends)
{
  if (std::string(GetParam().name) == "ThinNeedles")
  {
    GTEST_SKIP() << "rounding may lose a window";
  }
  for (Random& random : EachSeed(Meshes, 77000))
  {
    const Drawn drawn(GetParam(), random.between(30, 300), random);
    const geodesic::DistanceField field =
      solveKeepingAll(drawn.mesh, engineCurves(drawn.mesh, drawn.curves));
    for (const MeshPoint& place : randomPoints(drawn.plain, 300, random))
    {
      const geodesic::FaceDistance face(field, static_cast<geodesic::Id>(place.face));
      const geodesic::Vec2 p = face.inPlane(place.weights);
      double least = geodesic::Infinity;
      for (std::size_t i = 0; i < face.candidates().size(); ++i)
      {
        const double distance = face.candidates()[i].distance(p);
        least = face.isRegularCorner(i) ? least : std::min(least, distance);
      }
      const double most = face.distance(p) + accuracyOn(GetParam()) * drawn.largest;
      EXPECT_TRUE(least <= most || face.distance(p) == geodesic::Infinity)
        << "face " << place.face << ": " << least << ", " << most;
    }
  }
}

// Circles around (3, 3) and (5, 3) in a rectangle of 8 x 6.
TEST(LevelTruth, CountsTheLinesRoundTwoPointsOfAPlane)
{
  const PlainMesh plain = regularGrid(8, 6);
  Sources sources;
  for (Index vertex = 0; vertex < plain.points.size(); ++vertex)
  {
    const Vec3& p = plain.points[vertex];
    if (p[1] == 3.0 && (p[0] == 3.0 || p[0] == 5.0))
    {
      sources.points.push_back(vertexPoint(plain, vertex));
    }
  }
  const auto count = [&](double value)
  {
    LevelTruth truth(plain, sources, value);
    for (int cuts = 0; cuts < LeastCuts + 2; ++cuts)
    {
      truth.refine();
    }
    return truth.count();
  };
  EXPECT_TRUE(count(0.99) == (LineCount{ 0, 2 }));
  EXPECT_FALSE(count(1.0)) << "they touch each other";
  EXPECT_TRUE(count(1.01) == (LineCount{ 0, 1 }));
  EXPECT_TRUE(count(3.05) == (LineCount{ 6, 0 })) << "at four corners, and between the circles";
  EXPECT_TRUE(count(6.0) == (LineCount{ 0, 0 }));
}

TEST_P(RandomIsolines, AreAsManyAndAsClosedAsTheSublevelSetsHaveBoundaries)
{
  std::size_t compared = 0;
  for (Random& random : EachSeed(SmallMeshes, 78000))
  {
    const Drawn drawn(GetParam(), random.between(8, 60), random);
    if (!(drawn.largest > 0.0))
    {
      continue; // the source goes through all vertices
    }
    const Isolines isolines = drawn.draw();
    const Sources sources = toSources(drawn.curves);
    for (std::size_t value = 0; value < drawn.values.size(); ++value)
    {
      const LineCount count = countLines(isolines, value);
      LevelTruth truth(drawn.plain, sources, drawn.values[value] * (1.0 - 1e-12));
      std::optional<LineCount> expected;
      std::size_t most = UsualTriangles;
      for (int cuts = 1; cuts <= MostCuts && !(expected == count) && truth.size() < most; ++cuts)
      {
        truth.refine();
        expected = cuts < LeastCuts ? std::nullopt : truth.count();
        // Finer triangles may show lines that these ones do not.
        most = expected ? MostTriangles : most;
      }
      compared += expected ? 1 : 0;
      EXPECT_TRUE(!expected || *expected == count)
        << GetParam().name << ", value " << drawn.values[value] << " of " << drawn.largest << ": "
        << count.open << " open and " << count.closed << " closed lines instead of "
        << expected->open << " and " << expected->closed << "\n"
        << describe(drawn.curves);
    }
  }
  EXPECT_GE(compared, 3 * SmallMeshes);
  std::cout << GetParam().name << ": " << compared << " values compared\n";
}

// Where the pencils of two windows meet, rounding may leave a gap between them, in which the level
// curves continue behind the ridge. These are such cases.
TEST(IsolinesAtRidges, HaveTheirPointsAtTheValue)
{
  for (const auto& [name, seed] : { std::make_pair("Box", 1408U), std::make_pair("Box", 2284U),
         std::make_pair("Tetrahedron", 1067U) })
  {
    const std::vector<MeshKind> kinds = meshKinds();
    const auto kind = std::find_if(kinds.begin(), kinds.end(),
      [wanted = std::string(name)](const MeshKind& k) { return k.name == wanted; });
    ASSERT_NE(kind, kinds.end());
    Random random(seed);
    const PlainMesh plain = kind->make(random.between(8, 40), random);
    const std::vector<Polyline> curves = CurveMaker(plain, random).anySource();
    const TriangleMesh mesh = engineMesh(plain);
    const std::vector<double> distances =
      geodesic::solve(mesh, engineCurves(mesh, curves)).vertexDistances();
    const double largest = largestFinite(distances);
    std::vector<double> values;
    for (int i = 1; i < 12; ++i)
    {
      values.push_back(largest * (i + random.uniform(0.0, 0.9)) / 12.0);
    }
    for (const double d : distances)
    {
      if (d > 0.0 && d < largest && random.chance(0.2))
      {
        values.push_back(d);
      }
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    const Isolines isolines =
      isolinesOf(mesh, engineCurves(mesh, curves), values, ChordFraction * largest);
    std::vector<MeshPoint> places;
    std::vector<double> expected;
    for (const Isoline& line : isolines.lines)
    {
      for (const geodesic::Id point : line.points)
      {
        places.push_back(testPoint(mesh, isolines.points[point]));
      }
      expected.resize(places.size(), values[line.value]);
    }
    const std::vector<double> truth = bruteForceDistances(plain, toSources(curves), places).queries;
    EXPECT_LE(worstError(expected, truth, largest), 1e-12) << name << ", seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, RandomIsolines, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

// Along edges of needles, pieces of the distance may differ by more where they meet.
TEST(IsolinesAmongNeedles, HavePointsOnEdgesAtTheValueUpToSomeTies)
{
  std::size_t onEdges = 0;
  for (const MeshKind& kind : meshKinds())
  {
    for (std::uint64_t seed = 0; seed < 30 && std::string(kind.name) == "ThinNeedles"; ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(seed);
      const PlainMesh plain = kind.make(random.between(100, 600), random);
      const geodesic::TriangleMesh mesh = engineMesh(plain);
      const geodesic::DistanceField field =
        solveKeepingAll(mesh, engineCurves(mesh, CurveMaker(plain, random).anySource()));
      const double largest = largestFinite(field.vertexDistances());
      geodesic::IsolineOptions options;
      options.chordTolerance = 0.01 * largest;
      for (int i = 1; i < 20; ++i)
      {
        options.values.push_back(0.05 * i * largest);
      }
      const Isolines isolines = geodesic::drawIsolines(field, options);
      for (const Isoline& line : isolines.lines)
      {
        const double value = options.values[line.value];
        for (const geodesic::Id id : line.points)
        {
          const geodesic::SurfacePoint& p = isolines.points[id];
          if (p.kind == geodesic::SurfacePoint::Kind::Edge)
          {
            ++onEdges;
            EXPECT_NEAR(field.distance(p), value,
              20.0 * geodesic::tolerance::IsolineValue * (value + mesh.length(p.id)));
          }
        }
      }
    }
  }
  EXPECT_GT(onEdges, 0U);
}
