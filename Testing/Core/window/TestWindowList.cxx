// SPDX-License-Identifier: BSD-3-Clause
// Where windows of a list meet and are one, up to rounding. That a list is the lower envelope of
// its windows, the distances of whole meshes show.
#include "window/WindowSupport.h"

#include "Tolerance.h"
#include "window/WindowList.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::WindowListBuilder;

namespace
{

constexpr double Length = 2.0;

}

TEST(WindowList, WindowsTooNarrowForTheirEndsAreLeftOut)
{
  WindowListBuilder builder;
  builder.reset(Length);
  const double narrow = 0.25 * geodesic::tolerance::LeastWidth * Length;
  builder.append(circularWindow(0.0, narrow, 0.5, 1.0));
  EXPECT_EQ(builder.windows().size(), 0u);
  builder.append(circularWindow(0.5, 0.5, 0.5, 1.0));
  EXPECT_EQ(builder.windows().size(), 0u);
  builder.append(circularWindow(0.5, 0.6, 0.5, 1.0));
  EXPECT_EQ(builder.windows().size(), 1u);
}

TEST(WindowList, OneWindowKeepsAnOverlapByRoundings)
{
  const double a = 0.5;
  const double b = a * (1.0 + 2.0 * Epsilon);
  for (const double sigma : { 0.0, 1.0 })
  {
    WindowListBuilder builder;
    builder.reset(1.0);
    builder.append(circularWindow(0.0, b, 0.25, 1.0, sigma));
    builder.append(circularWindow(a, 1.0, 0.75, 1.0, 1.0 - sigma));
    const std::vector<Window>& list = builder.windows();
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].end, list[1].begin);
    EXPECT_EQ(list[0].end, sigma == 0.0 ? b : a) << "the lower one has it";
  }
}

TEST(WindowList, PencilsOfOneSourceFromTwoListsBecomeOneAndKeepTheLargerError)
{
  for (const double error : { 0.0, 0.25 })
  {
    for (const Window& whole :
      { circularWindow(0.0, 1.0, 0.3, 2.0, 1.0), linearWindow(0.0, 1.0, 0.6, 1.0) })
    {
      Window left = whole;
      left.end = 0.5;
      left.error = 0.25 - error;
      left.facesCrossed = 3;
      Window right = whole;
      right.begin = 0.5;
      right.error = error;
      right.facesCrossed = error > 0.0 ? 5 : 2;
      right.sourceX *= 1.0 + 8.0 * Epsilon; // as after some unfoldings around a vertex
      WindowListBuilder builder;
      builder.reset(1.0);
      builder.append(left);
      builder.appendOfOther(right);
      ASSERT_EQ(builder.windows().size(), 1u) << whole;
      const Window& one = builder.windows()[0];
      EXPECT_EQ(one.begin, 0.0);
      EXPECT_EQ(one.end, 1.0);
      EXPECT_EQ(one.error, 0.25) << "the larger of the two";
      EXPECT_EQ(one.facesCrossed, error > 0.0 ? 3u : 2u) << "the smaller: a longer way drops none";
    }
  }
}

// As around faces without area, with the rounding of some unfoldings.
TEST(WindowList, TheShorterWayOfAReturningPencilStays)
{
  Window first = circularWindow(0.2, 0.8, 0.3, 2.0, 1.0);
  first.facesCrossed = 3;
  for (const double rounding : { -4.0 * Epsilon, 4.0 * Epsilon })
  {
    Window again = first;
    again.begin = 0.3;
    again.end = 0.9;
    again.facesCrossed = 7;
    again.sigma += rounding;
    again.sourceDepth += rounding;
    for (const bool isFirstAppended : { true, false })
    {
      WindowListBuilder builder;
      builder.reset(1.0);
      builder.append(isFirstAppended ? first : again);
      builder.append(isFirstAppended ? again : first);
      ASSERT_EQ(builder.windows().size(), 2u);
      EXPECT_EQ(builder.windows()[0].facesCrossed, 3u);
      EXPECT_EQ(builder.windows()[0].end, 0.8);
      EXPECT_EQ(builder.windows()[1].facesCrossed, 7u);
    }
  }
}

TEST(WindowList, DifferentPencilsStayTwo)
{
  const Window left = circularWindow(0.0, 0.5, 0.3, 2.0, 1.0);
  std::vector<Window> others(5, circularWindow(0.5, 1.0, 0.3, 2.0, 1.0));
  others[0].sourceX += 1e-9;
  others[1].sourceDepth += 1e-9;
  others[2].sigma += 1e-9;
  others[3].begin = 0.5 + 1e-9; // a gap, in which another window belongs
  others[4] = linearWindow(0.5, 1.0, 0.3, 2.0);
  for (const Window& other : others)
  {
    WindowListBuilder builder;
    builder.reset(1.0);
    builder.append(left);
    builder.appendOfOther(other);
    EXPECT_EQ(builder.windows().size(), 2u) << other;
  }
}

TEST(Window, TwoDistancesAtOnceHaveTheBitsOfOneAfterTheOther)
{
  Random random(9);
  for (int i = 0; i < 500; ++i)
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
