// SPDX-License-Identifier: BSD-3-Clause
// The list of a halfedge is the lower envelope of all appended windows.
#include "window/WindowSupport.h"

#include "Tolerance.h"
#include "window/WindowList.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::WindowListBuilder;

namespace
{

constexpr double Length = 2.0;

std::vector<Window> someWindows(Random& random)
{
  std::vector<Window> windows;
  for (Index i = random.between(1, 8); i > 0; --i)
  {
    windows.push_back(randomWindow(Length, random));
  }
  // some that begin or end where another window does
  for (Index i = random.below(3); i > 0; --i)
  {
    Window w = windows[random.below(windows.size())];
    w.sourceX = w.isLinear() ? -w.sourceX : w.sourceX + 0.1;
    w.sigma += random.uniform(-0.1, 0.1);
    w.end = random.chance(0.5) ? w.end : 0.5 * (w.begin + w.end);
    windows.push_back(w);
  }
  return windows;
}

Extended least(const std::vector<Window>& windows, Extended x)
{
  Extended result = geodesic::Infinity;
  for (const Window& w : windows)
  {
    result = x >= w.begin && x <= w.end ? std::min(result, exactDistance(w, x)) : result;
  }
  return result;
}

void expectLowerEnvelope(const std::vector<Window>& appended, const std::vector<Window>& list)
{
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    ASSERT_GT(list[i].end, list[i].begin);
    ASSERT_TRUE(i == 0 || list[i - 1].end <= list[i].begin) << "windows overlap";
  }
  constexpr int samples = 400;
  for (int k = 0; k <= samples; ++k)
  {
    const Extended x = Length * (k + 0.37L) / (samples + 1);
    const Extended truth = least(appended, x);
    const Extended value = least(list, x);
    if (truth == geodesic::Infinity)
    {
      ASSERT_EQ(value, geodesic::Infinity) << "at " << static_cast<double>(x);
      continue;
    }
    ASSERT_NEAR(
      static_cast<double>(value - truth), 0.0, 1e-11 * (Length + static_cast<double>(truth)))
      << "at " << static_cast<double>(x);
  }
}

}

TEST(WindowList, IsTheLowerEnvelopeInAnyOrderOfAppending)
{
  Random random(1);
  WindowListBuilder builder;
  for (int i = 0; i < 2000; ++i)
  {
    SCOPED_TRACE(i);
    std::vector<Window> windows = someWindows(random);
    if (random.chance(0.5))
    {
      std::sort(windows.begin(), windows.end(),
        [](const Window& a, const Window& b) { return a.begin < b.begin; });
    }
    builder.reset(Length);
    for (const Window& w : windows)
    {
      builder.append(w);
    }
    expectLowerEnvelope(windows, builder.windows());
    if (HasFatalFailure())
    {
      return;
    }
  }
}

TEST(WindowList, OfTwoListsIsTheLowerEnvelopeOfBoth)
{
  Random random(2);
  std::size_t longest = 0;
  for (int i = 0; i < 1000; ++i)
  {
    SCOPED_TRACE(i);
    std::vector<Window> both;
    // side by side, overlapping, or one of them empty
    const double split = random.uniform(0.0, 1.5);
    const auto listWithin = [&](double lo, double hi, Index count)
    {
      WindowListBuilder list;
      list.reset(Length);
      for (; count > 0; --count)
      {
        Window w = randomWindow(Length, random);
        w.begin = lo + (hi - lo) * random.uniform(0.0, 0.9);
        w.end = w.begin + 0.1 * (hi - lo) * random.uniform(0.1, 1.0);
        list.append(w);
      }
      both.insert(both.end(), list.windows().begin(), list.windows().end());
      longest = std::max(longest, list.windows().size());
      return list;
    };
    const WindowListBuilder first =
      listWithin(0.0, random.chance(0.5) ? split : Length, random.below(30));
    const WindowListBuilder second =
      listWithin(random.chance(0.5) ? split : 0.0, Length, random.below(30));
    WindowListBuilder builder;
    builder.reset(Length);
    builder.appendLists(first.range(), second.range());
    expectLowerEnvelope(both, builder.windows());
    if (HasFatalFailure())
    {
      return;
    }
  }
  EXPECT_GT(longest, 12u);
}

TEST(WindowList, WhereOthersAreLowerAWindowIsLeftOut)
{
  Random random(3);
  for (int i = 0; i < 1000; ++i)
  {
    SCOPED_TRACE(i);
    WindowListBuilder others;
    others.reset(Length);
    std::vector<Window> appended;
    for (const Window& w : someWindows(random))
    {
      others.append(w);
      appended.push_back(w);
    }
    appended.push_back(randomWindow(Length, random));
    WindowListBuilder builder;
    builder.reset(Length);
    builder.appendWhereLower(appended.back(), others.range());
    // What is left is nowhere higher than the others, and with them the envelope of all.
    std::vector<Window> left = builder.windows();
    for (const Window& part : left)
    {
      const double middle = 0.5 * (part.begin + part.end);
      ASSERT_LE(static_cast<double>(exactDistance(part, middle)),
        (1.0 + 1e-11) * static_cast<double>(least(others.windows(), middle)));
    }
    WindowListBuilder all;
    all.reset(Length);
    all.appendLists(others.range(), builder.range());
    expectLowerEnvelope(appended, all.windows());
    if (HasFatalFailure())
    {
      return;
    }
  }
}

TEST(WindowList, ResetForgetsTheListBefore)
{
  WindowListBuilder builder;
  builder.reset(1.0);
  builder.append(circularWindow(0.0, 1.0, 0.5, 1.0));
  builder.reset(1.0);
  EXPECT_EQ(builder.range().size(), 0u);
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
      left.crossed = 1;
      Window right = whole;
      right.begin = 0.5;
      right.error = error;
      right.facesCrossed = error > 0.0 ? 5 : 2;
      right.crossed = 2;
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
      EXPECT_EQ(one.crossed, geodesic::NoId) << "not a face that only one of them has crossed";
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
