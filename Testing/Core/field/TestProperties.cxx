// SPDX-License-Identifier: BSD-3-Clause
// Properties of every distance field, whatever its values.
#include "EngineSupport.h"

#include "Errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

using namespace geodesictest;

namespace
{

/// A mesh of each character, by turns.
PlainMesh someMesh(std::uint64_t seed, Random& random)
{
  switch (seed % 8)
  {
    case 0:
      return bumpySheet(9, 11, 2, 0.5, random);
    case 1:
      return octasphere(5);
    case 2:
      return book(4, 6, 4, 0.4, random);
    case 3:
      return moebius(24, 4);
    case 4:
      return needleSheet(8, 8, 1e3, 0.3, random);
    case 5:
      return planarWithHoles(10, 10, 3, random);
    case 6:
      return joinedAtVertex(
        bumpySheet(6, 6, 0, 0.5, random), 20, bumpySheet(6, 6, 0, 0.5, random), 30);
    default:
      return box({ 1.0, 2.0, 1.5 }, { 4, 5, 6 });
  }
}

constexpr std::uint64_t Rounds = 40;

/// One of eight meshes is of needles, with an aspect of 1e3: a tenth of what accuracyOn() allows
/// for aspects of up to 1e4.
constexpr double PropertyAccuracy = 1e-11;

/// Of 80,000 pairs on 102 such cylinders none was off by more.
constexpr double NearlyFlatAccuracy = 1e-12;

/// The same as engineDistances(), from the brute-force solver.
EngineResult trueDistances(
  const PlainMesh& mesh, const std::vector<Polyline>& curves, const std::vector<MeshPoint>& queries)
{
  const BruteForceResult truth = bruteForceDistances(mesh, toSources(curves), queries);
  return { truth.vertices, truth.queries };
}

/// Runs a test on some meshes and random curves on them.
template <typename Test>
void onMeshesOfAllCharacters(std::uint64_t rounds, Test&& test)
{
  for (std::uint64_t seed = 0; seed < rounds; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const PlainMesh mesh = someMesh(seed, random);
    CurveMaker maker(mesh, random);
    test(mesh, maker, random);
  }
}

/// Runs a test on fields of meshes scaled to all sizes, whose distances are divided by the factor:
/// test(scaled, unscaled, true distances).
template <typename Test>
void onScaledMeshes(const std::vector<double>& factors, Test&& test)
{
  onMeshesOfAllCharacters(Rounds,
    [&](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const std::vector<Polyline> curves = maker.anySource();
      const std::vector<MeshPoint> queries = randomPoints(mesh, 40, random);
      const EngineResult here = engineDistances(mesh, curves, queries);
      const EngineResult truth = trueDistances(mesh, curves, queries);
      for (const double factor : factors)
      {
        SCOPED_TRACE(::testing::Message() << "factor " << factor);
        EngineResult there = engineDistances(scaled(mesh, factor), curves, queries);
        for (std::vector<double>* values : { &there.vertices, &there.queries })
        {
          std::transform(values->begin(), values->end(), values->begin(),
            [factor](double d) { return d / factor; });
        }
        test(there, here, truth);
      }
    });
}

/// Checks that two lists of curves have the same distance field, which is the true one of the
/// first.
void expectSameField(const PlainMesh& mesh, const std::vector<Polyline>& a,
  const std::vector<Polyline>& b, const std::vector<MeshPoint>& queries, const char* what)
{
  const EngineResult truth = trueDistances(mesh, a, queries);
  const double largest = largestFinite(truth.vertices);
  for (const std::vector<Polyline>& curves : { a, b })
  {
    const EngineResult computed = engineDistances(mesh, curves, queries);
    EXPECT_LE(worstError(computed.vertices, truth.vertices, largest), PropertyAccuracy)
      << what << ", vertices, sources:\n"
      << describe(curves);
    EXPECT_LE(worstError(computed.queries, truth.queries, largest), PropertyAccuracy)
      << what << ", surface points, sources:\n"
      << describe(curves);
  }
}

/// The values of the old vertices, where old vertex i has become vertexMap[i].
std::vector<double> atOldPlaces(
  const std::vector<double>& values, const std::vector<Index>& vertexMap)
{
  std::vector<double> result;
  for (Index v : vertexMap)
  {
    result.push_back(values[v]);
  }
  return result;
}

/// Applies change(face, weights) to every point of the curves.
template <typename Change>
std::vector<Polyline> changed(std::vector<Polyline> curves, const Change& change)
{
  for (Polyline& curve : curves)
  {
    for (MeshSegment& s : curve.segments)
    {
      change(s.face, s.from);
      change(s.face, s.to);
    }
  }
  return curves;
}

/// Vertex sources, which do not change when faces are split.
std::vector<Polyline> vertexSources(const PlainMesh& mesh, Random& random)
{
  std::vector<Polyline> curves;
  const Index count = random.between(1, 3);
  for (Index i = 0; i < count; ++i)
  {
    const MeshPoint p = randomVertexPoint(mesh, random);
    curves.push_back({ { { p.face, p.weights, p.weights } }, {} });
  }
  return curves;
}

/// The same vertices in another mesh, which numbers them alike.
std::vector<Polyline> sameVertices(
  const std::vector<Polyline>& curves, const PlainMesh& mesh, const PlainMesh& other)
{
  std::vector<Polyline> result;
  for (const Polyline& curve : curves)
  {
    const MeshSegment& s = curve.segments[0];
    Index k = 0;
    while (s.from[k] == 0.0)
    {
      ++k;
    }
    const MeshPoint p = vertexPoint(other, mesh.triangles[s.face][k]);
    result.push_back({ { { p.face, p.weights, p.weights } }, {} });
  }
  return result;
}

}

TEST(Property, DistanceIsSymmetricBetweenTwoPoints)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const MeshPoint p = randomPoint(mesh, random);
      const MeshPoint q = randomPoint(mesh, random);
      const EngineResult fromP = engineDistances(mesh, { maker.point(p) }, { q });
      const EngineResult fromQ = engineDistances(mesh, { maker.point(q) }, { p });
      const double truth = trueDistances(mesh, { maker.point(p) }, { q }).queries[0];
      const double slack = PropertyAccuracy * largestFinite(fromP.vertices);
      EXPECT_NEAR(fromP.queries[0], truth, slack);
      EXPECT_NEAR(fromQ.queries[0], truth, slack);
    });
}

// On a cylinder that noise has made nearly flat everywhere, a path of many vertices meets others
// whose lengths differ by a tie, but not by a rounding. The vertices emit along the shortest.
TEST(Property, DistanceIsSymmetricOnANearlyFlatSurface)
{
  constexpr double noise = 3e-5;
  Random random(115);
  PlainMesh mesh = openCylinder(90, 90, 6.0);
  addNoise(mesh, noise, random);
  std::vector<Index> ends = { 562, 3811, 5127 };
  for (int i = 0; i < 9; ++i)
  {
    ends.push_back(random.below(mesh.points.size()));
  }
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  std::vector<std::vector<double>> distances;
  for (const Index end : ends)
  {
    const Sources source{ { vertexPoint(mesh, end) }, {} };
    const geodesic::DistanceField field = geodesic::solve(engine, engineCurves(engine, source));
    std::vector<double>& row = distances.emplace_back();
    std::transform(ends.begin(), ends.end(), std::back_inserter(row),
      [&field](Index other) { return field.vertexDistances()[other]; });
  }
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const double there = distances[i][j];
      EXPECT_NEAR(distances[j][i], there, NearlyFlatAccuracy * there)
        << ends[i] << " to " << ends[j];
    }
  }
}

TEST(Property, DistanceGrowsNoFasterThanThePointMoves)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      std::vector<MeshPoint> queries;
      for (int i = 0; i < 300; ++i)
      {
        // Two points of one face; some of them close to each other.
        const MeshPoint p = randomPoint(mesh, random);
        MeshPoint q = { p.face, randomWeights(random) };
        const double part = random.chance(0.5) ? 1.0 : std::pow(10.0, -random.uniform(1.0, 6.0));
        for (Index k = 0; k < 3; ++k)
        {
          q.weights[k] = p.weights[k] + part * (q.weights[k] - p.weights[k]);
        }
        queries.push_back(p);
        queries.push_back(q);
      }
      const EngineResult result = engineDistances(mesh, maker.anySource(), queries);
      const double slack = PropertyAccuracy * largestFinite(result.vertices);
      for (std::size_t i = 0; i < queries.size(); i += 2)
      {
        const double step =
          spaceDistance(position(mesh, queries[i]), position(mesh, queries[i + 1]));
        EXPECT_LE(std::abs(result.queries[i] - result.queries[i + 1]), step + slack)
          << "pair " << i;
      }
    });
}

TEST(Property, DistanceIsZeroOnTheSource)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker& maker, Random&)
    {
      const Polyline curve = maker.any();
      std::vector<MeshPoint> queries;
      for (const MeshSegment& s : curve.segments)
      {
        MeshPoint middle = { s.face, {} };
        for (Index k = 0; k < 3; ++k)
        {
          middle.weights[k] = 0.5 * (s.from[k] + s.to[k]);
        }
        queries.push_back(middle);
        queries.push_back({ s.face, s.to });
      }
      const EngineResult result = engineDistances(mesh, { curve }, queries);
      EXPECT_LE(largestFinite(result.queries), 1e-12 * largestFinite(result.vertices));
    });
}

TEST(Property, NumberingDoesNotMatter)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const std::vector<Polyline> curves = maker.anySource();
      const Renumbered other = renumbered(mesh, random);
      const auto moveWeights = [&other](Index face, Barycentric& w)
      {
        Barycentric result{};
        for (Index k = 0; k < 3; ++k)
        {
          result[(k + other.cornerShift[face]) % 3] = w[k];
        }
        w = result;
      };
      std::vector<Polyline> otherCurves = changed(curves, moveWeights);
      for (Polyline& curve : otherCurves)
      {
        for (MeshSegment& s : curve.segments)
        {
          s.face = other.faceMap[s.face];
        }
      }
      std::vector<MeshPoint> queries = randomPoints(mesh, 40, random);
      const EngineResult here = trueDistances(mesh, curves, queries);
      for (MeshPoint& p : queries)
      {
        moveWeights(p.face, p.weights);
        p.face = other.faceMap[p.face];
      }
      const EngineResult there = engineDistances(other.mesh, otherCurves, queries);
      const double largest = largestFinite(here.vertices);
      EXPECT_LE(worstError(atOldPlaces(there.vertices, other.vertexMap), here.vertices, largest),
        PropertyAccuracy);
      EXPECT_LE(worstError(there.queries, here.queries, largest), PropertyAccuracy);
    });
}

TEST(Property, OrientationOfFacesDoesNotMatter)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const std::vector<Polyline> curves = maker.anySource();
      std::vector<bool> flipped;
      const PlainMesh other = withFlippedFaces(mesh, random, &flipped);
      const auto moveWeights = [&flipped](Index face, Barycentric& w)
      {
        if (flipped[face])
        {
          std::swap(w[1], w[2]);
        }
      };
      std::vector<MeshPoint> queries = randomPoints(mesh, 40, random);
      const EngineResult here = trueDistances(mesh, curves, queries);
      for (MeshPoint& p : queries)
      {
        moveWeights(p.face, p.weights);
      }
      const EngineResult there = engineDistances(other, changed(curves, moveWeights), queries);
      const double largest = largestFinite(here.vertices);
      EXPECT_LE(worstError(there.vertices, here.vertices, largest), PropertyAccuracy);
      EXPECT_LE(worstError(there.queries, here.queries, largest), PropertyAccuracy);
    });
}

TEST(Property, SplittingFacesAndEdgesDoesNotMatter)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker&, Random& random)
    {
      const std::vector<Polyline> curves = vertexSources(mesh, random);
      const EngineResult here = trueDistances(mesh, curves, {});
      const PlainMesh splits[] = { withSplitFaces(mesh, 0.5, random),
        withSplitEdges(mesh, 0.4, random), subdivided(mesh),
        withSplitEdges(withSplitFaces(mesh, 0.3, random), 0.3, random) };
      for (const PlainMesh& split : splits)
      {
        EngineResult there = engineDistances(split, sameVertices(curves, mesh, split));
        there.vertices.resize(mesh.points.size());
        EXPECT_LE(worstError(there.vertices, here.vertices, largestFinite(here.vertices)),
          PropertyAccuracy);
      }
    });
}

TEST(Property, DistanceScalesWithTheSurface)
{
  onScaledMeshes({ 1e-9, 1e9 },
    [](const EngineResult& there, const EngineResult&, const EngineResult& truth)
    {
      const double largest = largestFinite(truth.vertices);
      EXPECT_LE(worstError(there.vertices, truth.vertices, largest), PropertyAccuracy);
      EXPECT_LE(worstError(there.queries, truth.queries, largest), PropertyAccuracy);
    });
}

// Scaling by powers of two changes no digit, so any absolute tolerance would show.
TEST(Property, DistanceScalesWithTheSurfaceToTheLastDigit)
{
  onScaledMeshes({ std::ldexp(1.0, -60), std::ldexp(1.0, 60) },
    [](const EngineResult& there, const EngineResult& here, const EngineResult&)
    {
      EXPECT_EQ(there.vertices, here.vertices);
      EXPECT_EQ(there.queries, here.queries);
    });
}

TEST(Property, ACurveIsTheLimitOfItsDensePoints)
{
  onMeshesOfAllCharacters(Rounds / 2,
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const Polyline curve = maker.walk(3);
      const std::vector<MeshPoint> queries = randomPoints(mesh, 30, random);
      EngineResult exact = trueDistances(mesh, { curve }, queries);
      exact.vertices.insert(exact.vertices.end(), exact.queries.begin(), exact.queries.end());
      const double slack = PropertyAccuracy * largestFinite(exact.vertices);
      std::vector<double> coarser(exact.vertices.size(), geodesic::Infinity);
      for (int pieces : { 2, 8, 32, 128 })
      {
        std::vector<Polyline> points;
        double spacing = 0.0;
        for (const MeshSegment& s : curve.segments)
        {
          const double length =
            spaceDistance(position(mesh, { s.face, s.from }), position(mesh, { s.face, s.to }));
          spacing = std::max(spacing, length / pieces);
          for (int i = 0; i <= pieces; ++i)
          {
            Barycentric w{};
            const double t = static_cast<double>(i) / pieces;
            for (Index k = 0; k < 3; ++k)
            {
              w[k] = i == pieces ? s.to[k] : s.from[k] + t * (s.to[k] - s.from[k]);
            }
            points.push_back({ { { s.face, w, w } }, {} });
          }
        }
        EngineResult sampled = engineDistances(mesh, points, queries);
        sampled.vertices.insert(
          sampled.vertices.end(), sampled.queries.begin(), sampled.queries.end());
        for (std::size_t i = 0; i < exact.vertices.size(); ++i)
        {
          const double d = sampled.vertices[i];
          EXPECT_GE(d, exact.vertices[i] - slack) << "value " << i;
          EXPECT_LE(d, exact.vertices[i] + 0.5 * spacing + slack)
            << "value " << i << ", " << pieces << " pieces";
          EXPECT_LE(d, coarser[i] + slack) << "value " << i;
        }
        coarser = sampled.vertices;
      }
    });
}

TEST(Property, OverlappingCurvesEqualTheirUnion)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const std::vector<MeshPoint> queries = randomPoints(mesh, 40, random);
      const Polyline curve = maker.walk(random.between(1, 5));
      Polyline thereAndBack = curve;
      const Polyline back = reversed(curve);
      thereAndBack.segments.insert(
        thereAndBack.segments.end(), back.segments.begin(), back.segments.end());
      expectSameField(mesh, { curve }, { curve, curve }, queries, "twice the same");
      expectSameField(mesh, { curve }, { back }, queries, "backwards");
      expectSameField(mesh, { curve }, { thereAndBack }, queries, "there and back");
      std::vector<Polyline> pieces;
      for (const MeshSegment& s : curve.segments)
      {
        pieces.push_back({ { s }, {} });
      }
      expectSameField(mesh, { curve }, pieces, queries, "segment by segment");
      // A segment and a longer one on top of it.
      const MeshSegment& whole = curve.segments[0];
      MeshSegment part = whole;
      for (Index k = 0; k < 3; ++k)
      {
        part.from[k] = 0.75 * whole.from[k] + 0.25 * whole.to[k];
        part.to[k] = 0.25 * whole.from[k] + 0.75 * whole.to[k];
      }
      expectSameField(mesh, { { { whole }, {} } }, { { { whole }, {} }, { { part }, {} } }, queries,
        "a part twice");
    });
}

TEST(Property, ACutIsNoVertexOfThePolyline)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const Polyline cut = maker.straight(6);
      Polyline bent = cut;
      bent.isCutAfter.clear();
      expectSameField(mesh, { cut }, { bent }, randomPoints(mesh, 60, random), "cut");
    });
}

TEST(Property, UnionOfSourcesIsTheSmallestOfTheirDistances)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const std::vector<MeshPoint> queries = randomPoints(mesh, 40, random);
      const std::vector<Polyline> curves = { maker.any(), maker.any(), maker.any() };
      const EngineResult together = engineDistances(mesh, curves, queries);
      EngineResult smallest = trueDistances(mesh, { curves[0] }, queries);
      for (std::size_t c = 1; c < curves.size(); ++c)
      {
        const EngineResult one = trueDistances(mesh, { curves[c] }, queries);
        for (std::size_t i = 0; i < smallest.vertices.size(); ++i)
        {
          smallest.vertices[i] = std::min(smallest.vertices[i], one.vertices[i]);
        }
        for (std::size_t i = 0; i < queries.size(); ++i)
        {
          smallest.queries[i] = std::min(smallest.queries[i], one.queries[i]);
        }
      }
      const double largest = largestFinite(together.vertices);
      EXPECT_LE(worstError(together.vertices, smallest.vertices, largest), PropertyAccuracy)
        << "sources:\n"
        << describe(curves);
      EXPECT_LE(worstError(together.queries, smallest.queries, largest), PropertyAccuracy)
        << "sources:\n"
        << describe(curves);
    });
}

TEST(Property, TheBoundaryAsSourceIsAllItsEdges)
{
  onMeshesOfAllCharacters(Rounds,
    [](const PlainMesh& mesh, CurveMaker&, Random& random)
    {
      const geodesic::TriangleMesh engine = engineMesh(mesh);
      const std::vector<geodesic::SourceCurve> boundary = geodesic::boundaryCurves(engine);
      const Sources edges = boundarySources(engine);
      ASSERT_EQ(boundary.empty(), edges.segments.empty());
      if (boundary.empty())
      {
        return;
      }
      const std::vector<MeshPoint> queries = randomPoints(mesh, 60, random);
      const EngineResult result = engineDistances(mesh, boundary, engine, queries);
      const BruteForceResult truth = bruteForceDistances(mesh, edges, queries);
      const double largest = std::max(largestFinite(truth.vertices), largestFinite(truth.queries));
      EXPECT_LE(worstError(result.vertices, truth.vertices, largest), PropertyAccuracy);
      EXPECT_LE(worstError(result.queries, truth.queries, largest), PropertyAccuracy);
    });
}

TEST(Property, TheSourceMustNotBeEmpty)
{
  const geodesic::TriangleMesh mesh = engineMesh(regularGrid(2, 2));
  EXPECT_THROW(geodesic::solve(mesh, std::vector<geodesic::SourceCurve>()), geodesic::SourceError);
}

TEST(Property, TheCallerCanStopTheSolveAndSeesHowFarItIs)
{
  const geodesic::TriangleMesh mesh = engineMesh(regularGrid(250, 250));
  const geodesic::SourceCurve corner = geodesic::pointCurve(geodesic::SurfacePoint::atVertex(0));
  geodesic::FrontOptions options;
  double last = 0.0;
  int calls = 0;
  options.job = geodesic::Job(
    [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, last + 0.05) << "a vertex counts when the front has reached it";
      EXPECT_LE(fraction, 1.0);
      last = fraction;
      ++calls;
      return true;
    });
  geodesic::solve(mesh, { corner }, options);
  EXPECT_GT(calls, 2);
  calls = 0;
  options.job = geodesic::Job([&](double) { return ++calls < 2; });
  EXPECT_THROW(geodesic::solve(mesh, { corner }, options), geodesic::Aborted);
  EXPECT_EQ(calls, 2);
}
