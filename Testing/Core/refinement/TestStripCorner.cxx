// SPDX-License-Identifier: BSD-3-Clause
// Points on both sides of a sharp corner: a strip between them keeps its angles.
#include "truth/TestMeshes.h"

#include "refinement/StripCorner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using geodesic::StripCorner;
using namespace geodesictest;

namespace
{

/// A place at a way along one of the sides.
struct Place
{
  double x;
  double y;
};

double angleAt(Place p, Place q, Place r)
{
  const double cross = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  const double dot = (q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y);
  return std::atan2(std::abs(cross), dot);
}

/// The smallest angle of the strip whose triangles are connected in the order of the ways.
double smallestAngle(double angle, const std::vector<double>& own, const std::vector<double>& other)
{
  const auto onOwn = [](double way) { return Place{ way, 0.0 }; };
  const auto onOther = [&](double way) {
    return Place{ way * std::cos(angle), way * std::sin(angle) };
  };
  Place a = onOwn(own[0]);
  Place b = onOther(other[0]);
  double least = 4.0;
  const auto add = [&](Place c) {
    least = std::min({ least, angleAt(a, b, c), angleAt(b, c, a), angleAt(c, a, b) });
  };
  add({ 0.0, 0.0 });
  std::size_t i = 1;
  std::size_t j = 1;
  while (i < own.size() && j < other.size())
  {
    const bool isOwn = own[i] <= other[j];
    const Place next = isOwn ? onOwn(own[i++]) : onOther(other[j++]);
    add(next);
    (isOwn ? a : b) = next;
  }
  return least;
}

/// Points on the other side, apart by the growth up to its square.
std::vector<double> otherSide(double growth, Random& random)
{
  std::vector<double> ways = { 1.0 };
  for (int i = 0; i < 10; ++i)
  {
    ways.push_back(ways.back() * random.uniform(growth, growth * growth));
  }
  return ways;
}

constexpr double Angle = 1e-4;

/// A corner whose other side has points already.
struct HalfCutCorner
{
  double growth;
  std::vector<double> other;
  StripCorner corner = { this->growth, this->other };
};

/// \param cut (const HalfCutCorner&, Random&, std::vector<double>& own) -> void: puts points onto
///        the own side, ascending.
template <typename Cut>
void expectAnglesKept(const Cut& cut)
{
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double growth = random.uniform(2.0, 5.0);
    const HalfCutCorner half{ growth, otherSide(growth, random) };
    std::vector<double> own;
    cut(half, random, own);
    if (testing::Test::HasFatalFailure())
    {
      return;
    }
    EXPECT_GE(smallestAngle(Angle, own, half.other), 0.99 * Angle / (growth - 1.0));
    EXPECT_LE(own.size(), 2 * half.other.size());
  }
}

}

TEST(StripCorner, PiecesAwayFromItKeepTheAngle)
{
  expectAnglesKept(
    [](const HalfCutCorner& half, Random& random, std::vector<double>& own)
    {
      const double end = half.other.back();
      own = { half.corner.away(0.0, random.uniform(0.7, 1.3)) };
      while (own.back() < end)
      {
        own.push_back(half.corner.away(own.back(), 1e3 * end));
        ASSERT_GT(own.back(), own[own.size() - 2]);
      }
    });
}

TEST(StripCorner, PiecesTowardsItKeepTheAngle)
{
  expectAnglesKept(
    [](const HalfCutCorner& half, Random& random, std::vector<double>& own)
    {
      own = { half.other.back() * random.uniform(1.0, half.growth) };
      while (own.back() > half.growth)
      {
        own.push_back(half.corner.towards(own.back(), 1e-3));
        ASSERT_LT(own.back(), own[own.size() - 2]);
      }
      EXPECT_EQ(half.corner.towards(own.back(), 0.0), 0.0)
        << "the piece at the corner may be as long";
      std::reverse(own.begin(), own.end());
    });
}

TEST(StripCorner, SidesThatTakeTurnsGrowByTheSquare)
{
  const double growth = 3.0;
  std::vector<double> first = { 1.0 };
  for (int i = 0; i < 6; ++i)
  {
    first.push_back(StripCorner(growth * growth, {}).away(first.back(), 1e9));
    EXPECT_DOUBLE_EQ(first.back(), 9.0 * first[first.size() - 2]);
  }
  const StripCorner corner(growth, first);
  std::vector<double> second = { 3.0 };
  for (int i = 0; i < 5; ++i)
  {
    second.push_back(corner.away(second.back(), 1e9));
    EXPECT_DOUBLE_EQ(second.back(), 9.0 * second[second.size() - 2]);
  }
  EXPECT_NEAR(smallestAngle(Angle, first, second), Angle / (growth - 1.0), 1e-6 * Angle);
}
