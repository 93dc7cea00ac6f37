// SPDX-License-Identifier: BSD-3-Clause
// Distances and rays of one window, compared with extended precision.
#include "window/WindowSupport.h"

#include "window/Interval.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::Id;
using geodesic::Interval;
using geodesic::RayOrigin;
using geodesic::RayStart;
using PlanePoint = geodesic::Vec2;

namespace
{

constexpr int Windows = 500;

TEST(Window, DistancesAreThoseOfTheDefinition)
{
  Random random(1);
  for (int i = 0; i < Windows; ++i)
  {
    const Window w = randomWindow(1.0, random);
    const double x = random.uniform(w.begin, w.end);
    const double y = random.uniform(0.0, 2.0);
    const double size = 2.0 + w.sourceDepth + w.sigma;
    EXPECT_NEAR(w.distance(x), static_cast<double>(exactDistance(w, x)), 4 * Epsilon * size) << w;
    EXPECT_NEAR(
      w.straightDistance({ x, y }), static_cast<double>(exactDistance(w, x, y)), 4 * Epsilon * size)
      << w;
  }
}

TEST(Window, TwoDistancesAtOnceHaveTheBitsOfOneAfterTheOther)
{
  Random random(9);
  for (int i = 0; i < Windows; ++i)
  {
    const Window w = randomWindow(1.0, random);
    const double x = random.uniform(w.begin, w.end);
    const double y = random.uniform(w.begin, w.end);
    const geodesic::TwoDoubles distances = w.distances({ x, y });
    EXPECT_EQ(distances.first(), w.distance(x)) << w;
    EXPECT_EQ(distances.second(), w.distance(y)) << w;
    const geodesic::TwoDoubles directions = w.endDirections();
    EXPECT_EQ(directions.first(), w.direction(w.begin).x) << w;
    EXPECT_EQ(directions.second(), w.direction(w.end).x) << w;
  }
}

TEST(Window, TheMinimumIsTheLeastDistanceOnTheInterval)
{
  Random random(2);
  for (int i = 0; i < Windows; ++i)
  {
    const Window w = randomWindow(1.0, random);
    const Extended least = leastOf([&](Extended x) { return exactDistance(w, x); }, w.begin, w.end);
    EXPECT_NEAR(w.minimum(), static_cast<double>(least), 1e-14 * (1.0 + w.minimum())) << w;
  }
}

TEST(Window, TheBentDistanceIsThatOfTheShortestPathThroughTheInterval)
{
  Random random(3);
  for (int i = 0; i < Windows; ++i)
  {
    const Window w = randomWindow(1.0, random);
    const PlanePoint p = { random.uniform(-1.0, 2.0),
      random.chance(0.1) ? 0.0 : random.uniform(0.0, 2.0) };
    const double truth = static_cast<double>(exactBentDistance(w, p.x, p.y));
    EXPECT_NEAR(w.bentDistance(p), truth, 1e-14 * (2.0 + truth)) << w;
    EXPECT_GE(w.crossing(p), w.begin);
    EXPECT_LE(w.crossing(p), w.end);
  }
}

TEST(Window, TheRayThroughTheCrossingHitsThePoint)
{
  Random random(4);
  int hits = 0;
  for (int i = 0; i < Windows; ++i)
  {
    const Window w = randomWindow(1.0, random);
    const PlanePoint p = { random.uniform(-1.0, 2.0), random.uniform(0.01, 2.0) };
    const double x = w.crossing(p);
    if (w.sourceDepth == 0.0 || x == w.begin || x == w.end)
    {
      continue; // not in the pencil
    }
    ++hits;
    const PlanePoint d = w.direction(x);
    const PlanePoint to = p - PlanePoint{ x, 0.0 };
    EXPECT_NEAR(geodesic::cross(d, to) / (geodesic::norm(d) * geodesic::norm(to)), 0.0, 1e-12) << w;
    EXPECT_NEAR(w.straightDistance(p), w.bentDistance(p), 1e-14 * w.bentDistance(p)) << w;
    EXPECT_FALSE(w.passesRightOf(w.begin, p)) << w;
    EXPECT_TRUE(w.passesRightOf(w.end, p)) << w;
  }
  EXPECT_GT(hits, Windows / 10);
}

TEST(Window, ReversedTwiceItIsTheSameAndHasTheSameDistances)
{
  Random random(5);
  for (int i = 0; i < Windows; ++i)
  {
    const double length = 1.5;
    const Window w = randomWindow(length, random);
    const Window r = reversed(w, length);
    EXPECT_NEAR(r.begin, length - w.end, 2 * Epsilon);
    EXPECT_NEAR(r.end, length - w.begin, 2 * Epsilon);
    for (const double t : { 0.0, 0.3, 1.0 })
    {
      const double x = w.begin + t * (w.end - w.begin);
      EXPECT_NEAR(r.distance(length - x), w.distance(x), 8 * Epsilon * (w.distance(x) + length));
      EXPECT_NEAR(r.straightDistance({ length - x, 0.7 }), w.straightDistance({ x, 0.7 }),
        8 * Epsilon * (w.distance(x) + length));
    }
    const Window back = reversed(r, length);
    EXPECT_NEAR(back.sourceX, w.sourceX, 8 * Epsilon * (length + std::abs(w.sourceX)));
    EXPECT_NEAR(back.sigma, w.sigma, 8 * Epsilon * (length + w.sigma));
  }
}

// Also where the reversed frame is a mirror, as between faces of opposite orientation.
TEST(Window, ReversedItsRaysStartAtTheSamePlaceOfTheSameSideAndAtTheSameAngle)
{
  Random random(7);
  for (int i = 0; i < Windows; ++i)
  {
    const double length = 1.5;
    Window w = randomWindow(length, random);
    const bool isRight = random.chance(0.5);
    const Id number = random.below(9);
    const double start = random.uniform(0.0, 3.0);
    w.origin = w.isLinear() ? RayOrigin::curveSide(number, isRight)
                            : RayOrigin::pointSide(number, isRight, random.chance(0.5));
    w.start = w.isLinear() ? RayStart::atParameter(start) : RayStart::atAngle(start);
    const Window r = reversed(w, length);
    EXPECT_EQ(r.origin, w.origin.mirrored());
    const double x = w.begin + 0.3 * (w.end - w.begin);
    if (w.isLinear())
    {
      EXPECT_NEAR(
        r.startOf({ length - x, 0.0 }).parameter(), w.startOf({ x, 0.0 }).parameter(), 1e-14);
    }
    else
    {
      EXPECT_NEAR(angleAround(r.origin, r.start, r.direction(length - x)),
        angleAround(w.origin, w.start, w.direction(x)), 1e-14);
    }
  }
}

TEST(Window, ItKnowsAgainOneOfTheFacesOfATubeOfEight)
{
  for (const Id facesOfTheTube : { 1U, 2U, 4U, 7U, 8U })
  {
    for (const Id before : { 0U, 3U, 8U, 20U }) // faces on the way there
    {
      Window w = circularWindow(0.0, 1.0, 0.5, 1.0);
      for (Id face = 0; face < before; ++face)
      {
        EXPECT_NE(w.crossed, face);
        w.cross(face);
      }
      const auto faceOfTheTube = [&](Id i) { return before + i % facesOfTheTube; };
      Id i = 0;
      for (; w.crossed != faceOfTheTube(i) && i < 100; ++i)
      {
        w.cross(faceOfTheTube(i));
      }
      EXPECT_GE(i, facesOfTheTube);
      EXPECT_LE(i, 7 + facesOfTheTube);
      EXPECT_EQ(w.facesCrossed, before + i);
    }
  }
}

TEST(Window, ItsErrorIsRoundedUpByAMillionthAtMost)
{
  Random random(11);
  for (int i = 0; i < Windows; ++i)
  {
    const double error = std::pow(10.0, random.uniform(-300.0, 300.0));
    const geodesic::ErrorBound bound = error;
    EXPECT_GE(bound, error);
    EXPECT_LE(bound, error * (1.0 + 1e-6));
    EXPECT_EQ(geodesic::ErrorBound(bound), double(bound));
  }
  for (const double error : { 0.0, 1.0, geodesic::Infinity })
  {
    EXPECT_EQ(geodesic::ErrorBound(error), error);
  }
}

TEST(Interval, AClipKeepsWhatSatisfiesTheCondition)
{
  Random random(6);
  for (int i = 0; i < 200; ++i)
  {
    const double c0 = random.uniform(-1.0, 1.0);
    const double c1 = random.chance(0.2) ? 0.0 : random.uniform(-1.0, 1.0);
    Interval interval{ 0.25, 0.75 };
    interval.clip(c0, c1);
    for (double x = 0.01; x < 1.0; x += 0.01)
    {
      const bool kept = x > interval.begin && x < interval.end;
      const double value = c0 + c1 * x;
      if (std::abs(value) > 1e-12 && std::abs(x - 0.25) > 1e-9 && std::abs(x - 0.75) > 1e-9)
      {
        EXPECT_EQ(kept, value > 0.0 && x > 0.25 && x < 0.75) << c0 << " " << c1 << " " << x;
      }
    }
  }
}

TEST(Interval, WideningStaysInsideAndDoesNotFillWhatIsEmpty)
{
  Interval interval{ 0.1, 0.9 };
  interval.widen(0.05, 1.0);
  EXPECT_DOUBLE_EQ(interval.begin, 0.05);
  EXPECT_DOUBLE_EQ(interval.end, 0.95);
  interval.widen(0.5, 1.0);
  EXPECT_EQ(interval.begin, 0.0);
  EXPECT_EQ(interval.end, 1.0);
  Interval empty{ 0.5, 0.5 };
  empty.widen(0.1, 1.0);
  EXPECT_TRUE(empty.isEmpty());
}

}
