// SPDX-License-Identifier: BSD-3-Clause
// Where two windows have the same distance, and which of them is lower, compared with bisection in
// extended precision.
#include "window/WindowSupport.h"

#include "window/LowerWindow.h"

#include <gtest/gtest.h>

#include <string>

using namespace geodesictest;
using geodesic::Crossings;
using geodesic::crossings;
using geodesic::lowerOf;
using geodesic::LowerParts;

namespace
{

constexpr double Lo = 0.25;
constexpr double Hi = 1.5;

/// Two windows that cover [Lo, Hi]. The difference of their distances has at most one extremum,
/// where their rays have the same direction, and is monotone on both sides of it.
struct Pair
{
  Window a;
  Window b;

  Extended difference(Extended x) const
  {
    return exactDistance(this->a, x) - exactDistance(this->b, x);
  }

  /// The size of the numbers that make up the distances.
  double size() const
  {
    double size = std::abs(this->a.sigma) + std::abs(this->b.sigma);
    for (const double x : { Lo, Hi })
    {
      size += std::abs(this->a.distance(x) - this->a.sigma);
      size += std::abs(this->b.distance(x) - this->b.sigma);
    }
    return size;
  }

  Extended extremum() const
  {
    const bool linearA = this->a.isLinear();
    if (linearA && this->b.isLinear())
    {
      return Lo;
    }
    if (linearA || this->b.isLinear())
    {
      const Window& line = linearA ? this->a : this->b;
      const Window& circle = linearA ? this->b : this->a;
      const Extended m = line.sourceX;
      return circle.sourceX + m * circle.sourceDepth / std::sqrt((1.0L - m) * (1.0L + m));
    }
    const Extended s0 = this->a.sourceX;
    const Extended h0 = this->a.sourceDepth;
    return s0 + (this->b.sourceX - s0) * h0 / (h0 - this->b.sourceDepth);
  }

  /// The points of equal distance in (Lo, Hi), each between two places where the distances differ
  /// by more than `least` in opposite directions.
  std::vector<Extended> roots(Extended least) const
  {
    std::vector<Extended> breaks = { Lo, Hi };
    const Extended turn = this->extremum();
    if (turn > Lo && turn < Hi) // false for NaN
    {
      breaks.insert(breaks.begin() + 1, turn);
    }
    std::vector<Extended> result;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      Extended lo = breaks[i];
      Extended hi = breaks[i + 1];
      const Extended atLo = this->difference(lo);
      const Extended atHi = this->difference(hi);
      if (std::min(std::abs(atLo), std::abs(atHi)) <= least || (atLo > 0.0L) == (atHi > 0.0L))
      {
        continue;
      }
      for (int step = 0; step < 200; ++step)
      {
        const Extended middle = 0.5L * (lo + hi);
        ((this->difference(middle) > 0.0L) == (atLo > 0.0L) ? lo : hi) = middle;
      }
      result.push_back(lo);
    }
    return result;
  }
};

std::ostream& operator<<(std::ostream& os, const Pair& pair)
{
  return os << pair.a << "\n" << pair.b;
}

double depthOf(Random& random)
{
  return random.chance(0.1) ? 0.0 : std::pow(10.0, random.uniform(-3.0, 2.0));
}

Window circle(double sigma, Random& random)
{
  return circularWindow(Lo, Hi, random.uniform(-2.0, 4.0), depthOf(random), sigma);
}

Window line(Random& random)
{
  return linearWindow(Lo, Hi, random.uniform(-1.0, 1.0), random.uniform(0.0, 3.0));
}

/// Changes a window so that its distance at x equals the other one's.
Window through(Window w, const Window& other, double x)
{
  w.sigma += other.distance(x) - w.distance(x);
  return w;
}

/// The same source moved by a fraction of its distance.
Window moved(Window w, double by, Random& random)
{
  w.sourceX += by * random.uniform(-1.0, 1.0) * (1.0 + w.sourceDepth);
  if (w.isLinear())
  {
    w.sourceX = std::clamp(w.sourceX, -1.0, 1.0);
    w.sourceDepth = std::sqrt((1.0 - w.sourceX) * (1.0 + w.sourceX));
  }
  else
  {
    w.sourceDepth = std::abs(w.sourceDepth + by * random.uniform(-1.0, 1.0));
  }
  return w;
}

/// How pairs are made. Most kinds have a crossing inside, as few random pairs do.
struct PairKind
{
  const char* name;
  Pair (*make)(Random& random);
  /// The numbers of crossings that occur.
  std::vector<std::size_t> counts;
};

std::ostream& operator<<(std::ostream& os, const PairKind& kind)
{
  return os << kind.name;
}

double inside(Random& random)
{
  return random.uniform(Lo, Hi);
}

Pair equalSigma(Random& random)
{
  const double sigma = random.chance(0.5) ? 0.0 : random.uniform(0.0, 2.0);
  return { circle(sigma, random), circle(sigma, random) };
}

Pair twoSigmas(Random& random)
{
  const Window a = circle(random.uniform(0.0, 2.0), random);
  const Window b = circle(random.uniform(0.0, 2.0), random);
  return { a, random.chance(0.7) ? through(b, a, inside(random)) : b };
}

Pair circleAndLine(Random& random)
{
  const Window a = circle(random.chance(0.5) ? 0.0 : random.uniform(0.0, 2.0), random);
  const Window b = random.chance(0.7) ? through(line(random), a, inside(random)) : line(random);
  return random.chance(0.5) ? Pair{ a, b } : Pair{ b, a };
}

Pair twoLines(Random& random)
{
  const Window a = line(random);
  return { a, random.chance(0.7) ? through(line(random), a, inside(random)) : line(random) };
}

Pair nearSources(Random& random)
{
  Window a = random.chance(0.7) ? circle(random.uniform(0.0, 2.0), random) : line(random);
  a.sourceDepth = a.isLinear() ? a.sourceDepth : std::max(a.sourceDepth, 1e-3);
  const Window b = moved(a, std::pow(10.0, random.uniform(-12.0, -2.0)), random);
  return { a, random.chance(0.5) ? through(b, a, inside(random)) : b };
}

Pair farSources(Random& random)
{
  const auto far = [&random](double distance)
  {
    const double angle = random.uniform(0.1, 3.0);
    return circularWindow(
      Lo, Hi, distance * std::cos(angle), distance * std::sin(angle), random.uniform(0.0, 1.0));
  };
  const Window a = far(std::pow(10.0, random.uniform(1.0, 4.0)));
  return { a, through(far(std::pow(10.0, random.uniform(1.0, 4.0))), a, inside(random)) };
}

/// As neighbours in a list, and windows at a saddle vertex.
Pair equalAtOneEnd(Random& random)
{
  const Window a = circle(random.uniform(0.0, 2.0), random);
  const Window b = random.chance(0.7) ? circle(random.uniform(0.0, 2.0), random) : line(random);
  const Pair pair = { a, through(b, a, random.chance(0.5) ? Lo : Hi) };
  return random.chance(0.5) ? pair : Pair{ pair.b, pair.a };
}

/// The way from one source passes the other, or nearly so: beyond it the two nearly coincide.
Pair oneBehindTheOther(Random& random)
{
  const auto small = [&random] { return std::pow(10.0, random.uniform(-9.0, -1.0)); };
  Window a = circle(random.uniform(0.0, 2.0), random);
  a.sourceDepth = random.chance(0.5) ? 0.0 : small();
  Window b = a;
  const double step = random.uniform(-2.0, 2.0);
  b.sourceX += step;
  b.sourceDepth = std::abs(b.sourceDepth + step * small());
  b = through(b, a, random.chance(0.5) ? a.sourceX : inside(random));
  return random.chance(0.5) ? Pair{ a, b } : Pair{ b, a };
}

/// The rays of the line are nearly parallel to the halfedge.
Pair circleBesideALine(Random& random)
{
  Window a = circle(random.uniform(0.0, 2.0), random);
  a.sourceDepth = random.chance(0.5) ? 0.0 : std::pow(10.0, random.uniform(-9.0, -1.0));
  const double off = std::pow(10.0, random.uniform(-16.0, -1.0));
  Window b = line(random);
  b.sourceX = random.chance(0.5) ? 1.0 - off : off - 1.0;
  b.sourceDepth = std::sqrt((1.0 - b.sourceX) * (1.0 + b.sourceX));
  b = through(b, a, random.chance(0.5) ? a.sourceX : inside(random));
  return random.chance(0.5) ? Pair{ a, b } : Pair{ b, a };
}

const std::vector<PairKind>& pairKinds()
{
  static const std::vector<PairKind> kinds = { { "EqualSigma", equalSigma, { 0, 1 } },
    { "TwoSigmas", twoSigmas, { 0, 1, 2 } }, { "CircleAndLine", circleAndLine, { 0, 1, 2 } },
    { "TwoLines", twoLines, { 0, 1 } }, { "NearSources", nearSources, { 0, 1, 2 } },
    { "FarSources", farSources, { 1, 2 } }, { "EqualAtOneEnd", equalAtOneEnd, { 0, 1 } },
    { "OneBehindTheOther", oneBehindTheOther, { 0, 1, 2 } },
    { "CircleBesideALine", circleBesideALine, { 0, 1 } } };
  return kinds;
}

class WindowPairs : public ::testing::TestWithParam<PairKind>
{
};

/// Distances that differ by no more than this fraction of their size are not told apart: rounding
/// of the squares and of their sums.
constexpr double Resolution = 1e-13;

/// How much the distances may differ at a found crossing, relative to their size: a few roundings
/// each of the source's place, of sigma and of the root.
constexpr double CrossingAccuracy = 4.0 * Epsilon;

}

TEST_P(WindowPairs, EveryCrossingIsFound)
{
  Random random(1);
  std::array<int, 3> seen{};
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i)
  {
    const Pair pair = GetParam().make(random);
    const double least = Resolution * pair.size();
    const std::vector<Extended> roots = pair.roots(least);
    const Crossings found = crossings(pair.a, pair.b, Lo, Hi);
    ++seen[roots.size()];
    ASSERT_GE(static_cast<std::size_t>(found.count), roots.size()) << pair;
    ASSERT_TRUE(found.count < 2 || found.at[0] <= found.at[1]) << pair;
    for (const Extended root : roots)
    {
      // The distances near the reported crossing differ by no more than rounding.
      double nearest = geodesic::Infinity;
      for (int k = 0; k < found.count; ++k)
      {
        const double x = found.at[static_cast<std::size_t>(k)];
        ASSERT_GT(x, Lo);
        ASSERT_LT(x, Hi);
        nearest = std::abs(x - root) < std::abs(nearest - root) ? x : nearest;
      }
      const double off = static_cast<double>(std::abs(pair.difference(nearest)));
      worst = std::max(worst, off / pair.size());
      ASSERT_LE(off, CrossingAccuracy * pair.size())
        << pair << "\nat " << static_cast<double>(root);
    }
  }
  RecordProperty("worst_difference_at_a_crossing", std::to_string(worst / Epsilon) + " roundings");
  for (const std::size_t count : GetParam().counts)
  {
    EXPECT_GT(seen[count], 10) << "pairs with " << count << " crossings";
  }
}

TEST_P(WindowPairs, TheLowerWindowIsLowerOnItsWholePart)
{
  Random random(2);
  for (int i = 0; i < 5000; ++i)
  {
    const Pair pair = GetParam().make(random);
    const LowerParts parts = lowerOf(pair.a, pair.b, Lo, Hi);
    ASSERT_TRUE(parts.cuts < 2 || parts.cut[0] <= parts.cut[1]) << pair;
    constexpr int samples = 50;
    for (int k = 0; k <= samples; ++k)
    {
      const double x = Lo + (Hi - Lo) * k / samples;
      int before = 0;
      while (before < parts.cuts && parts.cut[static_cast<std::size_t>(before)] < x)
      {
        ++before;
      }
      const bool isA = parts.firstIsA == (before % 2 == 0);
      const double excess = static_cast<double>(isA ? pair.difference(x) : -pair.difference(x));
      ASSERT_LE(excess, 1e-12 * pair.size()) << pair << "\nat " << x;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, WindowPairs, ::testing::ValuesIn(pairKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST(WindowCrossings, CrossingsOutsideTheIntervalAreLeftOut)
{
  const Window a = circularWindow(0.0, 1.0, 0.0, 1.0);
  const Window b = circularWindow(0.0, 1.0, 1.0, 1.0);
  EXPECT_EQ(crossings(a, b, 0.0, 0.4).count, 0);
  EXPECT_EQ(crossings(a, b, 0.6, 1.0).count, 0);
  const Crossings found = crossings(a, b, 0.0, 1.0);
  ASSERT_GE(found.count, 1);
  for (int i = 0; i < found.count; ++i)
  {
    EXPECT_NEAR(found.at[static_cast<std::size_t>(i)], 0.5, 1e-15);
  }
}

TEST(WindowCrossings, EqualWindowsHaveNoCrossingAndTheFirstOneIsTheLower)
{
  for (const Window& w : { circularWindow(0.0, 1.0, 0.3, 0.5, 0.1),
         linearWindow(0.0, 1.0, 0.4, 2.0), circularWindow(0.0, 1.0, -3.0, 0.0) })
  {
    EXPECT_EQ(crossings(w, w, 0.0, 1.0).count, 0) << w;
    const LowerParts parts = lowerOf(w, w, 0.0, 1.0);
    EXPECT_TRUE(parts.firstIsA) << w;
    EXPECT_EQ(parts.cuts, 0) << w;
  }
}

TEST(LowerWindow, ATieOnOnePartDoesNotHideWhichIsLowerOnTheRest)
{
  // The source of one window lies on the way from the other's, along the halfedge: beyond that
  // point the two tie, before it they do not.
  const double sigma = 1.0;
  for (const double x : { 0.3, 0.4, 0.5 })
  {
    const Window from = circularWindow(0.0, 1.0, -0.25, 0.0, sigma);
    const Window on = circularWindow(0.0, 1.0, x, 0.0, from.distance(x));
    for (const bool swap : { false, true })
    {
      const Window& a = swap ? on : from;
      const Window& b = swap ? from : on;
      const LowerParts parts = lowerOf(a, b, 0.0, 1.0);
      const bool first = parts.firstIsA;
      EXPECT_EQ(first, !swap) << "at the begin the straight one is lower";
      EXPECT_TRUE(parts.cuts == 0 || parts.cut[0] >= x - 1e-12);
    }
  }
}

TEST(LowerWindow, WindowsThatTieUpToRoundingAreNotCut)
{
  Random random(3);
  for (int i = 0; i < 1000; ++i)
  {
    const Window a = circularWindow(0.0, 1.0, random.uniform(-1.0, 2.0), random.uniform(0.1, 5.0),
      random.chance(0.5) ? 0.0 : random.uniform(0.0, 1.0));
    Window b = a;
    b.sourceX *= 1.0 + Epsilon;
    b.sourceDepth *= 1.0 - Epsilon;
    b.sigma *= random.chance(0.5) ? 1.0 : 1.0 + Epsilon;
    const LowerParts parts = lowerOf(a, b, 0.0, 1.0);
    EXPECT_EQ(parts.cuts, 0) << a << "\n" << b;
  }
}
