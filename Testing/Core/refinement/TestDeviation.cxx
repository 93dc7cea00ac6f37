// SPDX-License-Identifier: BSD-3-Clause
// The deviation of a distance from linear, and the table of section 6.2.
#include "EngineSupport.h"
#include "window/WindowSupport.h"

#include "refinement/Deviation.h"
#include "refinement/EdgeSplitter.h"
#include "window/WindowList.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace geodesictest;
using geodesic::Deviation;
using geodesic::Id;
using geodesic::largestDeviation;

namespace
{

constexpr double Rounding = 1e-12;

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

/// Whether some window has this difference to the line at x; at a break point there are two.
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

/// The place where a window is least over a line of this slope, by bisection.
double lowestAgainstLine(const Window& w, double slope)
{
  long double lo = w.begin;
  long double hi = w.end;
  for (int i = 0; i < 100; ++i)
  {
    const long double x = 0.5L * (lo + hi);
    const long double dx = x - w.sourceX;
    const long double rises = w.isLinear()
      ? w.sourceX
      : dx / std::sqrt(dx * dx + static_cast<long double>(w.sourceDepth) * w.sourceDepth);
    (rises < slope ? lo : hi) = x;
  }
  return static_cast<double>(lo);
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

// A window's difference to a line is convex: it is least where its slope is zero, which bisection
// finds without a formula.
TEST(Deviation, ExtremaAreThoseThatBisectionFinds)
{
  for (Random& random : EachSeed(3000, 10000))
  {
    const double length = std::pow(10.0, random.uniform(-9.0, 9.0));
    const std::vector<Window> envelope = randomEnvelope(length, random);
    const double atBegin = random.uniform(0.0, 2.0) * length;
    const double slope = random.uniform(-1.1, 1.1);
    const Deviation d = largestDeviation(envelope, 0.0, length, atBegin, atBegin + slope * length);
    long double above = 0.0L;
    long double below = 0.0L;
    for (const Window& w : envelope)
    {
      for (const double x : { w.begin, w.end, lowestAgainstLine(w, slope) })
      {
        const Extended e = exactDistance(w, x) - (atBegin + static_cast<Extended>(slope) * x);
        above = std::max(above, e);
        below = std::max(below, -e);
      }
    }
    EXPECT_NEAR(d.above / length, static_cast<double>(above / length), Rounding);
    EXPECT_NEAR(d.below / length, static_cast<double>(below / length), Rounding);
    const double x = d.at * length;
    EXPECT_EQ(d.largest(), std::max(d.above, d.below));
    EXPECT_TRUE(occurs(envelope, x, atBegin + slope * x, d.above >= d.below ? d.above : -d.below));
  }
}

TEST(Deviation, ExtremumOfACircularWindowIsWhereTheCorrectedFormulaPutsIt)
{
  // distance sqrt(x^2 + 1) on [-1, 3] shifted to begin at 0, against its chord
  const Window w = { 0.0, 4.0, 1.0, 1.0, 0.0, 0.0, Window::Kind::Circular, 0 };
  const Deviation d = largestDeviation({ w }, 0.0, 4.0, std::sqrt(2.0), std::sqrt(10.0));
  const double a = (std::sqrt(10.0) - std::sqrt(2.0)) / 4.0;
  const double q = 1.0 + a / std::sqrt(1.0 - a * a);
  EXPECT_NEAR(d.at, q / 4.0, 1e-15);
  EXPECT_NEAR(d.below, std::sqrt(2.0) + a * q - std::hypot(q - 1.0, 1.0), 1e-15);
  EXPECT_NEAR(d.above, 0.0, 1e-15);
}

namespace
{

/// How many pieces of sqrt(x^2 + h^2) between two places keep a tolerance. With x = h sinh(u), the
/// deviation between u and v is h (cosh((v - u) / 2) - 1) / cosh((u + v) / 2).
std::size_t fewestPieces(double h, double begin, double end, double tolerance)
{
  const double last = std::asinh(end / h);
  double u = std::asinh(begin / h);
  for (std::size_t pieces = 1;; ++pieces)
  {
    const auto fits = [&](double v)
    { return h * (std::cosh(0.5 * (v - u)) - 1.0) / std::cosh(0.5 * (u + v)) <= tolerance; };
    if (fits(last))
    {
      return pieces;
    }
    double low = u;
    double high = last;
    for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (low + high);
      (fits(middle) ? low : high) = middle;
    }
    u = low;
  }
}

}

// In a face whose corner is the source, the distance along the edge opposite is a hyperbola.
TEST(EdgeSplitter, CutsAHyperbolaIntoTheFewestPieces)
{
  for (Random& random : EachSeed(300))
  {
    const double length = random.uniform(0.1, 10.0);
    const double h = std::pow(10.0, random.uniform(-2.0, 1.0)) * length;
    const double source = random.uniform(-1.0, 2.0) * length;
    const double tolerance = std::pow(10.0, random.uniform(-5.0, -2.0)) * length;
    const geodesic::TriangleMesh mesh =
      engineMesh({ { { source, h, 0 }, { 0, 0, 0 }, { length, 0, 0 } }, { { 0, 1, 2 } } });
    const auto field =
      solveKeepingAll(mesh, { geodesic::pointCurve(geodesic::SurfacePoint::atVertex(0)) });
    geodesic::RefinedFaces faces(field);
    const Id edge = faces.edges.ensure(1);
    geodesic::EdgeSplitter splitter(faces, tolerance);
    const geodesic::EdgeCuts cuts = splitter.fewestCuts(edge);
    for (const geodesic::EdgeSplit& split : cuts.splits)
    {
      EXPECT_EQ(split.edge, edge);
      faces.edges.split(split);
      const double x = faces.edges.points().back().at * length;
      const bool isForward = mesh.origin(faces.edges[edge].halfedge) == 1;
      EXPECT_NEAR(
        split.distance, std::hypot((isForward ? x : length - x) - source, h), 1e-12 * (h + length));
    }
    const std::size_t pieces = cuts.splits.size() + 1;
    EXPECT_GE(pieces, fewestPieces(h, -source, length - source, tolerance));
    EXPECT_LE(pieces, fewestPieces(h, -source, length - source, 0.9 * tolerance));
    const std::vector<Deviation> measured = geodesic::EdgeSplitter(faces, tolerance).measure(edge);
    ASSERT_EQ(measured.size(), pieces);
    for (std::size_t i = 0; i < pieces; ++i)
    {
      EXPECT_LE(measured[i].largest(), 1.01 * tolerance);
      if (pieces > 1)
      {
        EXPECT_NEAR(cuts.pieces[i].largest(), measured[i].largest(), 1e-12 * (h + length));
      }
    }
  }
}
