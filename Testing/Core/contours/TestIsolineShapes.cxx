// SPDX-License-Identifier: BSD-3-Clause
// Isolines whose shape is known in closed form, and properties of all isolines.
#include "OnThreads.h"
#include "contours/IsolineSupport.h"
#include "truth/AnalyticDistances.h"
#include "truth/RandomMeshKinds.h"

#include "Errors.h"
#include "contours/IsolineSides.h"
#include "contours/SolveForIsolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

using namespace geodesictest;
using geodesic::Id;
using geodesic::Isoline;
using geodesic::Isolines;
using geodesic::Job;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// One face with corners (0, 0), (4, 0), (0, 3): its inradius is 1.
PlainMesh oneFace()
{
  return { { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 } }, { { 0, 1, 2 } } };
}

MeshPoint inOneFace(double x, double y)
{
  return { 0, { 1.0 - x / 4.0 - y / 3.0, x / 4.0, y / 3.0 } };
}

/// With sides of length 0.6, against the clock.
Polyline squareInOneFace()
{
  const std::array<MeshPoint, 4> corners = { inOneFace(0.8, 0.8), inOneFace(1.4, 0.8),
    inOneFace(1.4, 1.4), inOneFace(0.8, 1.4) };
  Polyline square;
  for (std::size_t i = 0; i < 4; ++i)
  {
    square.segments.push_back({ 0, corners[i].weights, corners[(i + 1) % 4].weights });
  }
  return square;
}

/// How much shorter than arcs of this length their chords may be.
double shortening(double length, double radius, double chordTolerance)
{
  return length * chordTolerance / (3.0 * radius) * 1.01 + 1e-12 * length;
}

void expectArcs(double length, double arcs, double straight, double radius, double chordTolerance)
{
  EXPECT_LE(length, (arcs + straight) * (1.0 + 1e-12));
  EXPECT_GE(length, arcs + straight - shortening(arcs, radius, chordTolerance));
}

double totalLength(const TriangleMesh& mesh, const Isolines& isolines, std::size_t value)
{
  double length = 0.0;
  for (std::size_t i = 0; i < isolines.lines.size(); ++i)
  {
    length += isolines.lines[i].value == value ? lengthOf(mesh, isolines, i) : 0.0;
  }
  return length;
}

/// The coordinates of a line, for comparing bit by bit.
std::vector<std::tuple<int, Id, double, double>> placesOf(const Isolines& isolines)
{
  std::vector<std::tuple<int, Id, double, double>> places;
  for (const Isoline& line : isolines.lines)
  {
    for (const Id point : line.points)
    {
      const SurfacePoint& p = isolines.points[point];
      places.emplace_back(static_cast<int>(p.kind), p.id, p.u, p.v);
    }
  }
  return places;
}

}

TEST(Isolines, RoundAPointOfAPlaneAreCircles)
{
  Random random(1);
  const PlainMesh plain = randomPlanar(12, 12, random);
  const TriangleMesh mesh = engineMesh(plain);
  const double tolerance = 1e-5;
  Sources source; // beside the vertex in the middle
  source.points = { { TriangleMesh::faceOf(*mesh.cornersAt(6 * 13 + 6).begin()),
    { 0.3, 0.3, 0.4 } } };
  // The least one lies inside a face.
  const std::vector<double> values = { 0.01, 0.1, 1.0, 2.5, 4.0 };
  const Isolines isolines = isolinesOf(mesh, engineCurves(mesh, source), values, tolerance);
  ASSERT_EQ(isolines.lines.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_EQ(isolines.lines[i].value, i);
    EXPECT_TRUE(isolines.lines[i].isClosed());
    expectArcs(lengthOf(mesh, isolines, i), 2.0 * Pi * values[i], 0.0, values[i], tolerance);
  }
}

// Within a large tolerance lines go straight from edge to edge; a fine one needs more points.
TEST(Isolines, HaveOnlyThePointsThatTheToleranceNeeds)
{
  Random random(3);
  const PlainMesh plain = bumpySheet(8, 8, 0, 0.4, random);
  const geodesic::TriangleMesh mesh = engineMesh(plain);
  CurveMaker maker(plain, random);
  const std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, { maker.walk(4) });
  const std::vector<double> values = { 1.3, 2.1, 3.7 };
  std::size_t coarse = 0;
  for (const double tolerance : { 100.0, 1e-2, 1e-4 })
  {
    const geodesic::Isolines isolines = isolinesOf(mesh, curves, values, tolerance);
    ASSERT_FALSE(isolines.lines.empty());
    for (const geodesic::SurfacePoint& point : isolines.points)
    {
      EXPECT_TRUE(tolerance < 1.0 || point.kind != geodesic::SurfacePoint::Kind::Face);
    }
    EXPECT_GT(isolines.points.size(), coarse);
    coarse = isolines.points.size();
  }
}

// Points are not more exact than that.
TEST(Isolines, WithATinyToleranceHaveChordsAtARoundingOfTheArc)
{
  const PlainMesh mesh = regularGrid(2, 2);
  const TriangleMesh engine = engineMesh(mesh);
  Sources source;
  source.points = { { 0, { 0.4, 0.3, 0.3 } } };
  const Isolines isolines = isolinesOf(engine, engineCurves(engine, source), { 0.02 }, 1e-300);
  ASSERT_EQ(isolines.lines.size(), 1U);
  EXPECT_TRUE(isolines.lines[0].isClosed());
  EXPECT_GT(isolines.points.size(), 1000000U);
  EXPECT_LT(isolines.points.size(), 4000000U);
}

TEST(Isolines, SmallerThanTheToleranceHaveThreeCornersAtLeast)
{
  const PlainMesh plain = oneFace();
  const TriangleMesh mesh = engineMesh(plain);
  const geodesic::SourceCurve source = geodesic::pointCurve(enginePoint(mesh, inOneFace(1.0, 1.0)));
  const Isolines isolines = isolinesOf(mesh, { source }, { 0.5 }, 2.0);
  ASSERT_EQ(isolines.lines.size(), 1U);
  EXPECT_TRUE(isolines.lines[0].isClosed());
  EXPECT_GE(isolines.lines[0].points.size(), 4U);
}

TEST(Isolines, AtTheExactDistancesOfVerticesPassThemOnOneSide)
{
  const TriangleMesh mesh = engineMesh(regularGrid(8, 6));
  // Every line runs along a column of mesh edges; the last column is the largest distance.
  const std::vector<double> values = { 1, 2, 3, 4, 5, 6, 7, 8 };
  const Isolines isolines = isolinesOf(mesh, { sideOf(mesh, 0) }, values, 1e-4);
  ASSERT_EQ(isolines.lines.size(), values.size());
  expectChordsInFaces(mesh, isolines);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_FALSE(isolines.lines[i].isClosed());
    EXPECT_NEAR(lengthOf(mesh, isolines, i), 6.0, 1e-11);
    for (const Id point : isolines.lines[i].points)
    {
      EXPECT_NEAR(geodesic::position(mesh, isolines.points[point])[0], values[i], 8e-12);
    }
  }
}

// A value further off than rounding has its points on the edges beside the vertex.
TEST(Isolines, CloseToAVertexDoNotPassThroughIt)
{
  const PlainMesh plain = regularGrid(8, 8);
  const TriangleMesh mesh = engineMesh(plain);
  Sources source;
  source.points = { vertexPoint(plain, 40) };
  for (const double off : { -2e-11, 2e-11 })
  {
    const Isolines isolines = isolinesOf(mesh, engineCurves(mesh, source),
      { 2.0 * (1.0 + off), std::hypot(2.0, 3.0) * (1.0 + off) }, 1e-3);
    ASSERT_FALSE(isolines.lines.empty());
    for (const SurfacePoint& point : isolines.points)
    {
      EXPECT_NE(point.kind, SurfacePoint::Kind::Vertex) << "vertex " << point.id;
    }
  }
}

TEST(Isolines, EndInSharedPointsWhereSeveralPagesMeet)
{
  Random random(3);
  const Index pages = 4;
  const PlainMesh plain = book(pages, 6, 5, 0.0, random);
  const TriangleMesh mesh = engineMesh(plain);
  ASSERT_GT(mesh.numberOfNonManifoldEdges(), 0U);
  // On one page, at an edge in the middle of the spine, whose vertices are the first ones.
  Sources sources;
  sources.points = { { TriangleMesh::faceOf(mesh.halfedgeBetween(3, 4)), { 0.3, 0.3, 0.4 } } };
  const Isolines isolines = isolinesOf(mesh, engineCurves(mesh, sources), { 1.5 }, 1e-4);
  EXPECT_TRUE(countLines(isolines, 0) == (LineCount{ pages, 0 }));
  std::set<Id> ends;
  for (const Isoline& line : isolines.lines)
  {
    ends.insert({ line.points.front(), line.points.back() });
  }
  EXPECT_EQ(ends.size(), 2U);
}

TEST(Isolines, BeyondTheLargestDistanceAndOnOtherComponentsAreNone)
{
  Random random(6);
  const PlainMesh plain = merged(regularGrid(4, 4), octasphere(3));
  const TriangleMesh mesh = engineMesh(plain);
  Sources source;
  source.points = { { 0, { 0.2, 0.3, 0.5 } } };
  const std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, source);
  const geodesic::DistanceField field = geodesic::solve(mesh, curves);
  const double largest = largestFinite(field.vertexDistances());
  const Isolines isolines =
    isolinesOf(mesh, curves, { 0.9 * largest, 1.001 * largest, 100.0 * largest }, 1e-3);
  EXPECT_FALSE(isolines.lines.empty());
  for (const Isoline& line : isolines.lines)
  {
    EXPECT_EQ(line.value, 0U);
  }
}

TEST(Isolines, RefuseWrongValuesAndToleranceAndFieldsWithoutWindows)
{
  const TriangleMesh mesh = engineMesh(octasphere(12));
  const geodesic::SourceCurve point = geodesic::pointCurve(SurfacePoint::atVertex(0));
  const geodesic::DistanceField field =
    geodesic::solve(mesh, { point }, {}, geodesic::KeepWindows::All);
  const auto draw = [&](const std::vector<double>& values, double tolerance)
  {
    geodesic::IsolineOptions options;
    options.values = values;
    options.chordTolerance = tolerance;
    return geodesic::drawIsolines(field, options);
  };
  EXPECT_NO_THROW(draw({ 0.1, 0.2 }, 1e-3));
  EXPECT_THROW(draw({}, 1e-3), geodesic::Error);
  EXPECT_THROW(draw({ 0.0, 1.0 }, 1e-3), geodesic::Error);
  EXPECT_THROW(draw({ -1.0 }, 1e-3), geodesic::Error);
  EXPECT_THROW(draw({ 0.2, 0.1 }, 1e-3), geodesic::Error);
  EXPECT_THROW(draw({ 0.2, 0.2 }, 1e-3), geodesic::Error);
  EXPECT_THROW(draw({ std::nan("") }, 1e-3), geodesic::Error);
  EXPECT_THROW(draw({ geodesic::Infinity }, 1e-3), geodesic::Error);
  EXPECT_THROW(draw({ 0.1 }, 0.0), geodesic::Error);
  geodesic::IsolineOptions options;
  options.values = { 0.1 };
  options.chordTolerance = 1e-3;
  EXPECT_THROW(geodesic::drawIsolines(geodesic::solve(mesh, { point }), options), geodesic::Error);
  // Windows kept for another value are not the ones that this value needs.
  EXPECT_THROW(
    geodesic::drawIsolines(solveForIsolines(mesh, { point }, { 0.9 }), options), geodesic::Error);
}

class IsolinesOfKinds : public ::testing::TestWithParam<MeshKind>
{
};

TEST_P(IsolinesOfKinds, GrowToTheLeftHaveOnePointAnEdgeAndNeedOnlyTheWindowsKept)
{
  for (Random& random : EachSeed(6, 79000))
  {
    const PlainMesh plain = GetParam().make(random.between(30, 200), random);
    const TriangleMesh mesh = engineMesh(plain);
    const std::vector<geodesic::SourceCurve> curves =
      engineCurves(mesh, CurveMaker(plain, random).anySource());
    const geodesic::DistanceField field = solveKeepingAll(mesh, curves);
    const double largest = largestFinite(field.vertexDistances());
    const std::vector<double> values = { random.uniform(0.01, 0.3) * largest,
      random.uniform(0.3, 0.6) * largest, random.uniform(0.6, 0.99) * largest };
    geodesic::IsolineOptions options;
    options.values = values;
    options.chordTolerance = 1e-7 * largest;
    const Isolines isolines = isolinesOf(mesh, curves, values, options.chordTolerance);
    const Isolines ofAll = geodesic::drawIsolines(field, options);
    options.job = Job({}, onThreads);
    EXPECT_TRUE(placesOf(geodesic::drawIsolines(field, options)) == placesOf(ofAll));
    for (std::size_t value = 0; value < values.size(); ++value)
    {
      EXPECT_TRUE(countLines(isolines, value) == countLines(ofAll, value));
      EXPECT_NEAR(totalLength(mesh, isolines, value), totalLength(mesh, ofAll, value),
        1e-6 * totalLength(mesh, ofAll, value))
        << GetParam().name;
    }
    if (isolines.linesWithoutDirection == 0)
    {
      expectGrowthToTheLeft(field, isolines);
    }
    std::set<std::tuple<std::size_t, Id, double>> onEdges;
    std::set<Id> counted;
    for (const Isoline& line : isolines.lines)
    {
      for (const Id point : line.points)
      {
        const SurfacePoint& p = isolines.points[point];
        if (p.kind == SurfacePoint::Kind::Edge && counted.insert(point).second)
        {
          EXPECT_TRUE(onEdges.emplace(line.value, mesh.edgeOf(p.id), p.u).second)
            << "two points at one place of an edge";
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, IsolinesOfKinds, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST(IsolinesWithoutDirection, AreCountedWhereFacesAreTurned)
{
  Random random(12);
  const PlainMesh sheet = regularGrid(6, 6);
  const TriangleMesh turned = engineMesh(withFlippedFaces(sheet, random));
  const geodesic::SourceCurve point = geodesic::pointCurve(SurfacePoint::atVertex(0));
  EXPECT_EQ(isolinesOf(turned, { point }, { 2.7 }, 1e-3).linesWithoutDirection, 1U);
  EXPECT_EQ(isolinesOf(engineMesh(sheet), { point }, { 2.7 }, 1e-3).linesWithoutDirection, 0U);
}

namespace
{

/// The lines on the left-hand and right-hand side, as values 0 and 1.
Isolines linesOfSides(const TriangleMesh& mesh, const std::vector<geodesic::SourceCurve>& curves,
  double value, double chordTolerance)
{
  geodesic::FrontOptions front;
  front.keepArrivals = true;
  geodesic::IsolineOptions options;
  options.values = { value };
  options.chordTolerance = chordTolerance;
  const geodesic::DistanceField field = solveForIsolines(mesh, curves, options.values, front);
  geodesic::NearestSource nearest(field, geodesic::ReplicatedPatch(field.mesh()), curves);
  return geodesic::linesOnSides(field, nearest,
    [](const geodesic::Foot& foot) { return foot.isRight; }, geodesic::drawIsolines(field, options),
    { { 0, 1 } });
}

}

// Beside a straight open curve each side has half of the stadium, which ends on the curve's line.
TEST(IsolineSides, OfAnOpenCurveEndWhereTheSignJumpsBehindItsEnds)
{
  const TriangleMesh mesh = engineMesh(oneFace());
  Polyline curve;
  curve.segments = { { 0, inOneFace(1.0, 0.8).weights, inOneFace(1.5, 0.8).weights } };
  const double v = 0.3;
  const Isolines lines =
    linesOfSides(mesh, engineCurves(mesh, std::vector<Polyline>{ curve }), v, 1e-6);
  ASSERT_EQ(lines.lines.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_EQ(lines.lines[i].value, i);
    EXPECT_FALSE(lines.lines[i].isClosed());
    expectArcs(lengthOf(mesh, lines, i), Pi * v, 0.5, v, 1e-6);
    const Vec3 first = geodesic::position(mesh, lines.points[lines.lines[i].points.front()]);
    const Vec3 last = geodesic::position(mesh, lines.points[lines.lines[i].points.back()]);
    // Lines run in the direction of the curve on both sides.
    EXPECT_NEAR(first[0], 1.0 - v, 1e-11);
    EXPECT_NEAR(last[0], 1.5 + v, 1e-11);
    EXPECT_NEAR(first[1], 0.8, 1e-11);
    EXPECT_NEAR(last[1], 0.8, 1e-11);
    for (std::size_t k = 1; k + 1 < lines.lines[i].points.size(); ++k)
    {
      const double y = geodesic::position(mesh, lines.points[lines.lines[i].points[k]])[1];
      EXPECT_TRUE(i == 0 ? y > 0.8 : y < 0.8);
    }
  }
}

// A gap of .02 is between the ends of two curves. Over it the left side of the one is beside the
// right side of the other. So wide a tolerance cuts the corner there, between arcs that lie over
// their chord.
TEST(IsolineSides, ChangeOnTheLineAlsoWhereAChordHasCutTheCorner)
{
  const TriangleMesh mesh = engineMesh(oneFace());
  using Segment = std::array<Vec2, 2>;
  const std::array<Segment, 2> segments = { Segment{ Vec2{ 0.6, 0.8 }, Vec2{ 1.2, 0.8 } },
    Segment{ Vec2{ 1.8, 0.8 }, Vec2{ 1.22, 0.8 } } };
  std::vector<Polyline> curves;
  for (const auto& [a, b] : segments)
  {
    curves.emplace_back().segments = { { 0, inOneFace(a[0], a[1]).weights,
      inOneFace(b[0], b[1]).weights } };
  }
  const double v = 0.2;
  const Isolines lines = linesOfSides(mesh, engineCurves(mesh, curves), v, 0.05);
  std::size_t changes = 0; // in the middle of the gap
  for (const Isoline& line : lines.lines)
  {
    for (const Id point : { line.points.front(), line.points.back() })
    {
      const Vec3 place = geodesic::position(mesh, lines.points[point]);
      const Vec2 p = { place[0], place[1] };
      EXPECT_NEAR(std::min(distanceToSegment(p, segments[0][0], segments[0][1]),
                    distanceToSegment(p, segments[1][0], segments[1][1])),
        v, 1e-12);
      changes += std::abs(p[0] - 1.21) < 1e-11 ? 1 : 0;
    }
  }
  EXPECT_EQ(changes, 4U); // over and under the gap, a line ends and another begins
}

TEST(IsolineSides, OfAClosedCurveAreInsideAndOutside)
{
  const TriangleMesh mesh = engineMesh(oneFace());
  const Polyline square = squareInOneFace();
  for (const bool isTurned : { false, true })
  {
    const Isolines lines = linesOfSides(mesh,
      engineCurves(mesh, std::vector<Polyline>{ isTurned ? reversed(square) : square }), 0.2, 1e-7);
    ASSERT_EQ(lines.lines.size(), 2U);
    EXPECT_TRUE(lines.lines[0].isClosed() && lines.lines[1].isClosed());
    EXPECT_EQ(lines.lines[0].value, 0U);
    EXPECT_EQ(lines.lines[1].value, 1U);
    const std::size_t inside = isTurned ? 1 : 0; // with the curve against the clock its left
    EXPECT_NEAR(lengthOf(mesh, lines, inside), 4.0 * (0.6 - 0.4), 1e-11);
    expectArcs(lengthOf(mesh, lines, 1 - inside), 2.0 * Pi * 0.2, 2.4, 0.2, 1e-7);
  }
}

// Both sides together are the unsigned lines, and each point has the side of its part.
TEST_P(IsolinesOfKinds, OnTheSidesOfCurvesAreTheUnsignedOnesCut)
{
  for (Random& random : EachSeed(6, 79500))
  {
    const PlainMesh plain = GetParam().make(random.between(30, 200), random);
    const TriangleMesh mesh = engineMesh(plain);
    CurveMaker maker(plain, random);
    const std::vector<Polyline> polylines = { maker.straight(5), maker.closed() };
    const std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, polylines);
    const double largest = largestFinite(geodesic::solve(mesh, curves).vertexDistances());
    const double value = random.uniform(0.05, 0.8) * largest;
    const Isolines unsignedLines = isolinesOf(mesh, curves, { value }, 1e-4 * largest);
    const Isolines lines = linesOfSides(mesh, curves, value, 1e-4 * largest);
    const double length = totalLength(mesh, unsignedLines, 0);
    EXPECT_NEAR(totalLength(mesh, lines, 0) + totalLength(mesh, lines, 1), length, 1e-3 * length)
      << GetParam().name;
    expectChordsInFaces(mesh, lines);
    std::vector<MeshPoint> places;
    for (const Isoline& line : lines.lines)
    {
      for (const Id point : line.points)
      {
        places.push_back(testPoint(mesh, lines.points[point]));
      }
    }
    const std::vector<double> truth =
      bruteForceDistances(plain, toSources(polylines), places).queries;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      EXPECT_NEAR(truth[i], value, std::max(1e-11, accuracyOn(GetParam())) * largest)
        << GetParam().name;
    }
  }
}
