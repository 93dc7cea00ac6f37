// SPDX-License-Identifier: BSD-3-Clause
// The distance along segments of a face, its deviation from linear, and the table of section 6.2.
#include "EngineSupport.h"
#include "truth/RandomMeshKinds.h"

#include "Errors.h"
#include "field/FaceEnvelope.h"
#include "window/WindowList.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace geodesictest;
using geodesic::Deviation;
using geodesic::FaceEnvelope;
using geodesic::largestDeviation;
using geodesic::Window;

namespace
{

constexpr double Rounding = 1e-12;

Window randomWindow(double length, Random& random)
{
  Window w{};
  w.begin = random.uniform(0.0, 0.8) * length;
  w.end = w.begin + random.uniform(0.1, 1.0) * (length - w.begin);
  w.sigma = random.uniform(0.0, length);
  if (random.chance(0.4))
  {
    w.kind = Window::Kind::Linear;
    w.sourceX = random.uniform(-1.0, 1.0);
    w.sourceDepth = std::sqrt(1.0 - w.sourceX * w.sourceX);
    return w;
  }
  w.kind = Window::Kind::Circular;
  w.sourceX = random.uniform(-1.0, 2.0) * length;
  w.sourceDepth = random.chance(0.1) ? 0.0 : std::pow(10.0, random.uniform(-3.0, 2.0)) * length;
  return w;
}

/// Windows that cover [0, length] without a gap, but not continuously.
std::vector<Window> randomEnvelope(double length, Random& random)
{
  geodesic::WindowListBuilder builder;
  builder.reset(length);
  Window whole = randomWindow(length, random);
  whole.begin = 0.0;
  whole.end = length;
  builder.append(whole);
  for (Index i = random.below(6); i > 0; --i)
  {
    builder.append(randomWindow(length, random));
  }
  return builder.windows();
}

double at(const std::vector<Window>& envelope, double x)
{
  const auto window =
    std::find_if(envelope.begin(), envelope.end(), [x](const Window& w) { return x <= w.end; });
  return (window == envelope.end() ? envelope.back() : *window).distance(x);
}

/// Whether some window has this difference to the line at x: two meet at a break point.
bool occurs(const std::vector<Window>& envelope, double x, double line, double difference)
{
  const double slack = Rounding * envelope.back().end;
  return std::any_of(envelope.begin(), envelope.end(),
    [&](const Window& w)
    {
      return x >= w.begin - slack && x <= w.end + slack &&
        std::abs(w.distance(x) - line - difference) <= 4.0 * slack;
    });
}

}

TEST(SplitPosition, EachRowOfTheTableOfSection62)
{
  using geodesic::splitPosition;
  for (const double t : { 0.0, 0.05, 0.1249 })
  {
    EXPECT_EQ(splitPosition(t), 0.25) << t;
  }
  for (const double t : { 0.125, 0.18, 0.2499 })
  {
    EXPECT_EQ(splitPosition(t), 2.0 * t) << t;
  }
  for (const double t : { 0.25, 0.3, 0.5, 0.75 })
  {
    EXPECT_EQ(splitPosition(t), t) << t;
  }
  for (const double t : { 0.7501, 0.8, 0.8749 })
  {
    EXPECT_EQ(splitPosition(t), 2.0 * t - 1.0) << t;
  }
  for (const double t : { 0.875, 0.95, 1.0 })
  {
    EXPECT_EQ(splitPosition(t), 0.75) << t;
  }
}

TEST(Deviation, ClosedFormIsTheLargestOfDenseSamples)
{
  constexpr int samples = 2000;
  for (std::uint64_t seed = 0; seed < 3000; ++seed)
  {
    Random random(seed);
    const double length = std::pow(10.0, random.uniform(-9.0, 9.0));
    const std::vector<Window> envelope = randomEnvelope(length, random);
    const double atBegin = random.uniform(0.0, 2.0) * length;
    // slopes beyond one come from rounding and from approximate fields
    const double slope = random.uniform(-1.1, 1.1);
    const double atEnd = atBegin + slope * length;
    const Deviation d = largestDeviation(envelope, length, atBegin, atEnd);
    for (int i = 0; i <= samples; ++i)
    {
      const double x = length * i / samples;
      const double difference = at(envelope, x) - (atBegin + slope * x);
      ASSERT_LE(difference, d.above + Rounding * length) << "seed " << seed << ", x " << x;
      ASSERT_GE(difference, -d.below - Rounding * length) << "seed " << seed << ", x " << x;
    }
    if (d.above > 0.0)
    {
      const double x = d.aboveAt * length;
      EXPECT_TRUE(occurs(envelope, x, atBegin + slope * x, d.above)) << "seed " << seed;
    }
    if (d.below > 0.0)
    {
      const double x = d.belowAt * length;
      EXPECT_TRUE(occurs(envelope, x, atBegin + slope * x, -d.below)) << "seed " << seed;
    }
    EXPECT_EQ(d.largest(), std::max(d.above, d.below));
    EXPECT_EQ(d.at(), d.above >= d.below ? d.aboveAt : d.belowAt);
  }
}

TEST(Deviation, ExtremumOfACircularWindowIsWhereTheCorrectedFormulaPutsIt)
{
  // distance sqrt(x^2 + 1) on [-1, 3] shifted to begin at 0, against its chord
  const Window w = { 0.0, 4.0, 1.0, 1.0, 0.0, 0.0, Window::Kind::Circular, 0 };
  const Deviation d = largestDeviation({ w }, 4.0, std::sqrt(2.0), std::sqrt(10.0));
  const double a = (std::sqrt(10.0) - std::sqrt(2.0)) / 4.0;
  const double q = 1.0 + a / std::sqrt(1.0 - a * a);
  EXPECT_NEAR(d.belowAt, q / 4.0, 1e-15);
  EXPECT_NEAR(d.below, std::sqrt(2.0) + a * q - std::hypot(q - 1.0, 1.0), 1e-15);
  EXPECT_NEAR(d.above, 0.0, 1e-15);
}

namespace
{

class FaceEnvelopes : public ::testing::TestWithParam<MeshKind>
{
};

/// Ends of a segment in a face: anywhere, or along one of its edges, whole or in part.
std::array<Barycentric, 2> randomSegment(Random& random)
{
  std::array<Barycentric, 2> ends = { randomWeights(random), randomWeights(random) };
  if (random.chance(0.4))
  {
    const Index k = random.below(3);
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double u = random.chance(0.5) ? static_cast<double>(i) : random.uniform();
      ends[i] = { 0.0, 0.0, 0.0 };
      ends[i][k] = 1.0 - u;
      ends[i][(k + 1) % 3] = u;
    }
  }
  return ends;
}

}

TEST_P(FaceEnvelopes, AreTheDistanceAlongAnySegmentOfAnyFace)
{
  constexpr std::uint64_t meshes = 12;
  constexpr int segments = 120;
  constexpr int samples = 40;
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < meshes; ++seed)
  {
    Random random(seed + 500);
    const PlainMesh mesh = GetParam().make(random.between(50, 300), random);
    CurveMaker maker(mesh, random);
    const std::vector<Polyline> curves = maker.anySource();
    const geodesic::TriangleMesh engine = engineMesh(mesh);
    const geodesic::DistanceField field = solveKeepingAll(engine, engineCurves(engine, curves));
    const double largest = largestFinite(field.vertexDistances());
    FaceEnvelope envelope(field);
    for (int i = 0; i < segments; ++i)
    {
      const Index face = i < 10 ? curves[0].segments[0].face : random.below(engine.numberOfFaces());
      const geodesic::Triangle& corners = engine.triangle(face);
      if (std::isinf(field.vertexDistances()[corners[0]]))
      {
        continue;
      }
      const auto [a, b] = randomSegment(random);
      envelope.enter(face);
      const geodesic::Vec2 p = envelope.inPlane(a);
      const geodesic::Vec2 q = envelope.inPlane(b);
      const double length = norm(q - p);
      const std::vector<Window>& windows = envelope.along(p, q);
      if (!(length > 0.0))
      {
        EXPECT_TRUE(windows.empty());
        continue;
      }
      ASSERT_FALSE(windows.empty());
      EXPECT_EQ(windows.front().begin, 0.0);
      EXPECT_EQ(windows.back().end, length);
      for (std::size_t w = 1; w < windows.size(); ++w)
      {
        EXPECT_EQ(windows[w - 1].end, windows[w].begin);
        EXPECT_LT(windows[w].begin, windows[w].end);
      }
      for (int s = 0; s <= samples; ++s)
      {
        const double t = static_cast<double>(s) / samples;
        Barycentric c;
        for (std::size_t k = 0; k < 3; ++k)
        {
          c[k] = (1.0 - t) * a[k] + t * b[k];
        }
        const double truth = field.distance(geodesic::fromBarycentric(engine, face, c));
        const double value = at(windows, t * length);
        const double error = std::abs(value - truth) / largest;
        ASSERT_LE(error, EngineAccuracy) << "seed " << seed << ", face " << face << ", t " << t
                                         << ": " << value << " for " << truth << "\n"
                                         << describe(curves);
        ASSERT_LE(std::abs(envelope.distance(p + t * (q - p)) - truth), EngineAccuracy * largest);
        worst = std::max(worst, error);
      }
    }
  }
  std::cout << "worst relative error on " << GetParam().name << ": " << worst << "\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, FaceEnvelopes, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST(FaceEnvelope, IsRefusedWithoutWindows)
{
  const PlainMesh mesh = regularGrid(2, 2);
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  const Sources corner{ { vertexPoint(mesh, 0) }, {} };
  const geodesic::DistanceField field = geodesic::solve(engine, engineCurves(engine, corner));
  EXPECT_THROW(FaceEnvelope{ field }, geodesic::Error);
}
