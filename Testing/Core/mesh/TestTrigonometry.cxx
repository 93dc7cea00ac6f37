// SPDX-License-Identifier: BSD-3-Clause
// Angles and unit vectors are those of the library's long double functions, but for their last
// bits.
#include "truth/TestMeshes.h"

#include "Trigonometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using geodesic::Pi;
using geodesictest::Random;

namespace
{

using Exact = long double;
using PlaneVector = geodesic::Vec2;

constexpr double Infinity = std::numeric_limits<double>::infinity();
/// What the functions promise; and where long double is double, the library is off by as much as
/// one unit itself.
constexpr double AllowedUnits = std::numeric_limits<Exact>::digits > 53 ? 2.0 : 3.0;

/// Near zeros of sine and cosine.
constexpr double AllowedAtZero = 1e-24;

/// The difference in units in the last place.
double unitsOff(double value, Exact exact)
{
  const double nearest = std::abs(static_cast<double>(exact));
  const double unit = std::nextafter(nearest, Infinity) - nearest;
  return static_cast<double>(std::abs(static_cast<Exact>(value) - exact)) / unit;
}

double unitsOff(PlaneVector v)
{
  return unitsOff(
    geodesic::polarAngle(v), std::atan2(static_cast<Exact>(v.y), static_cast<Exact>(v.x)));
}

TEST(Trigonometry, AnglesAreRightInAllDirections)
{
  Random random(1);
  double worst = 0.0;
  for (int i = 0; i < 200000; ++i)
  {
    PlaneVector v = { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0) };
    worst = std::max(worst, unitsOff(v));
    v.y *= std::ldexp(1.0, -static_cast<int>(random.below(200)));
    worst = std::max({ worst, unitsOff(v), unitsOff({ v.y, v.x }) });
  }
  EXPECT_LE(worst, AllowedUnits);
  EXPECT_GT(worst, 0.0);
}

TEST(Trigonometry, AnglesAreRightBesideTheTablesVectors)
{
  double worst = 0.0;
  for (int k = 0; k <= 16; ++k)
  {
    for (const double ratio :
      { k / 8.0, std::nextafter(k / 8.0, -1.0), std::nextafter(k / 8.0, 3.0) })
    {
      for (const double x : { -1.0, 1.0 })
      {
        for (const double y : { -ratio, ratio })
        {
          worst = std::max({ worst, unitsOff({ x, y }), unitsOff({ y, x }) });
        }
      }
    }
  }
  EXPECT_LE(worst, AllowedUnits);
}

TEST(Trigonometry, AnglesOfAxesAndDiagonalsAreThoseOfTheLibrary)
{
  for (const double x : { -0.0, 0.0, -1.0, 1.0, 1e-300, -1e300 })
  {
    for (const double y : { -0.0, 0.0, x, -x })
    {
      for (const PlaneVector v : { PlaneVector{ x, y }, PlaneVector{ y, x } })
      {
        const double expected = std::atan2(v.y, v.x);
        const double angle = geodesic::polarAngle(v);
        EXPECT_EQ(angle, expected) << v.x << ' ' << v.y;
        EXPECT_EQ(std::signbit(angle), std::signbit(expected)) << v.x << ' ' << v.y;
      }
    }
  }
}

TEST(Trigonometry, UnitVectorsAreRight)
{
  Random random(2);
  double worst = 0.0;
  const auto look = [&](double angle)
  {
    const PlaneVector v = geodesic::unitVector(angle);
    const std::pair<double, Exact> pairs[] = { { v.x, std::cos(static_cast<Exact>(angle)) },
      { v.y, std::sin(static_cast<Exact>(angle)) } };
    for (const auto& [value, exact] : pairs)
    {
      const bool isZero = std::abs(value - static_cast<double>(exact)) < AllowedAtZero;
      worst = std::max(worst, isZero ? 0.0 : unitsOff(value, exact));
    }
  };
  for (int i = 0; i < 200000; ++i)
  {
    const double angle = random.uniform(-5.0 * Pi, 5.0 * Pi);
    look(angle);
    look(angle * std::ldexp(1.0, -static_cast<int>(random.below(200))));
  }
  for (int eighths = -40; eighths <= 40; ++eighths)
  {
    look(eighths * Pi / 4.0);
  }
  EXPECT_LE(worst, AllowedUnits);
  EXPECT_GT(worst, 0.0);
}

TEST(Trigonometry, TangentsAndArcSinesAreRight)
{
  Random random(3);
  double worst = 0.0;
  for (int i = 0; i < 200000; ++i)
  {
    const double angle = random.uniform(-0.5 * Pi, 0.5 * Pi);
    worst =
      std::max(worst, unitsOff(geodesic::tangent(angle), std::tan(static_cast<Exact>(angle))));
    const double sine = random.uniform(-1.0, 1.0);
    worst = std::max(worst, unitsOff(geodesic::arcSine(sine), std::asin(static_cast<Exact>(sine))));
  }
  // Both have the rounding of two results.
  EXPECT_LE(worst, 2.0 * AllowedUnits);
  EXPECT_EQ(geodesic::arcSine(1.0), 0.5 * Pi);
}

} // anonymous namespace
