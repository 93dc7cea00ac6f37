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

/// One of eight meshes is of needles, with an aspect of 1e3: a tenth of what accuracyOn() allows
/// for aspects of up to 1e4.
constexpr double PropertyAccuracy = 1e-11;

/// Of 80,000 pairs on 102 such cylinders none was off by more.
constexpr double NearlyFlatAccuracy = 1e-12;

/// Runs a test on some meshes and random curves on them.
template <typename Test>
void onMeshesOfAllCharacters(const Test& test)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const PlainMesh mesh = someMesh(seed, random);
    CurveMaker maker(mesh, random);
    test(mesh, maker, random);
  }
}

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

// Scaling by powers of two changes no digit, so any absolute tolerance would show.
TEST(Property, DistanceScalesWithTheSurfaceToTheLastDigit)
{
  onMeshesOfAllCharacters(
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const std::vector<Polyline> curves = maker.anySource();
      const std::vector<MeshPoint> queries = randomPoints(mesh, 40, random);
      const EngineResult here = engineDistances(mesh, curves, queries);
      for (const double factor : { 0x1p-60, 0x1p60 })
      {
        EngineResult there = engineDistances(scaled(mesh, factor), curves, queries);
        for (std::vector<double>* values : { &there.vertices, &there.queries })
        {
          std::transform(values->begin(), values->end(), values->begin(),
            [factor](double d) { return d / factor; });
        }
        EXPECT_EQ(there.vertices, here.vertices) << "factor " << factor;
        EXPECT_EQ(there.queries, here.queries) << "factor " << factor;
      }
    });
}

// Curves that lie on each other, in either direction and in parts.
TEST(Property, OverlappingCurvesEqualTheirUnion)
{
  onMeshesOfAllCharacters(
    [](const PlainMesh& mesh, CurveMaker& maker, Random& random)
    {
      const std::vector<MeshPoint> queries = randomPoints(mesh, 40, random);
      const Polyline curve = maker.walk(random.between(1, 5));
      const BruteForceResult truth = bruteForceDistances(mesh, toSources({ curve }), queries);
      std::vector<Polyline> parts;
      for (const MeshSegment& whole : curve.segments)
      {
        parts.push_back({ { whole }, {} });
        MeshSegment part = whole;
        for (Index k = 0; k < 3; ++k)
        {
          part.from[k] = 0.75 * whole.from[k] + 0.25 * whole.to[k];
          part.to[k] = 0.25 * whole.from[k] + 0.75 * whole.to[k];
        }
        parts.push_back({ { part }, {} });
      }
      for (const std::vector<Polyline>& curves :
        { { curve, curve }, { reversed(curve) }, { curve, reversed(curve) }, parts })
      {
        const EngineResult computed = engineDistances(mesh, curves, queries);
        const double largest = largestFinite(truth.vertices);
        EXPECT_LE(worstError(computed.vertices, truth.vertices, largest), PropertyAccuracy)
          << describe(curves);
        EXPECT_LE(worstError(computed.queries, truth.queries, largest), PropertyAccuracy)
          << describe(curves);
      }
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
