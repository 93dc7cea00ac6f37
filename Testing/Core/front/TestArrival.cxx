// SPDX-License-Identifier: BSD-3-Clause
// When a path that comes along a ray and goes on along a way counts as bent.
#include "EngineSupport.h"

#include "front/Arrival.h"

#include <gtest/gtest.h>

#include <cmath>

using geodesic::bends;
using geodesic::Vec2;

namespace
{

/// The rounding of a place in a face, as a fraction of its longest edge.
constexpr double Rounding = 4e-16;
/// What a way's end must be off the ray to be bent for certain.
constexpr double Clear = 1e-13;

Vec2 atAngle(double angle, double length)
{
  return { length * std::cos(angle), length * std::sin(angle) };
}

}

TEST(Arrival, IsBentWhereTheWayLeavesTheRayByMoreThanRounding)
{
  geodesictest::Random random(1);
  for (int i = 0; i < 1000; ++i)
  {
    const double longest = std::pow(10.0, random.uniform(-6.0, 6.0));
    const double angle = random.uniform(0.0, 6.28);
    const double side = random.chance(0.5) ? 0.5 : -0.5;
    const Vec2 ray = atAngle(angle, random.uniform(0.1, 2.0) * longest);
    const Vec2 way = atAngle(angle, random.uniform(0.1, 1.0) * longest);
    const Vec2 aside = atAngle(angle + side * 3.14159265358979323846, longest);
    EXPECT_FALSE(bends(ray, way, longest));
    EXPECT_FALSE(bends(ray, way + Rounding * aside, longest));
    EXPECT_TRUE(bends(ray, way + Clear * aside, longest));
    EXPECT_TRUE(bends(ray, -1.0 * way, longest)) << "back";
    EXPECT_TRUE(bends(Rounding * ray, way, longest)) << "a ray that has no direction";
  }
}
