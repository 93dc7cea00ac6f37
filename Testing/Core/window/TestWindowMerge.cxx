// SPDX-License-Identifier: BSD-3-Clause
// The claims of Merging.md about merged windows, checked by dense sampling in extended precision.
#include "window/WindowSupport.h"

#include "window/WindowMerge.h"

#include <gtest/gtest.h>

using namespace geodesictest;

namespace
{

/// Relative to the distances on the halfedge.
constexpr double Accuracy = 1e-13;

struct Pair
{
  Window left;
  Window right;

  Extended distance(Extended x) const
  {
    return exactDistance(x < this->left.end ? this->left : this->right, x);
  }
};

/// Two neighbours that meet with equal distances or, sometimes, with a step.
Pair randomPair(Random& random)
{
  const double joint = random.uniform(0.1, 0.9);
  const auto source = [&]
  {
    if (random.chance(0.3))
    {
      return linearWindow(0.0, 1.0, random.uniform(-0.95, 0.95), random.uniform(1.0, 3.0));
    }
    return circularWindow(0.0, 1.0, random.uniform(-1.0, 2.0),
      std::pow(10.0, random.uniform(-2.0, 1.0)), random.uniform(0.5, 2.0));
  };
  Pair pair = { source(), source() };
  pair.left.begin = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.09);
  pair.left.end = joint;
  pair.right.begin = joint;
  if (random.chance(0.9))
  {
    pair.right.sigma += pair.left.distance(joint) - pair.right.distance(joint);
  }
  // a pseudo-source's distance is not negative
  const double raise = std::max(0.0, 0.1 - pair.right.sigma);
  pair.left.sigma += raise;
  pair.right.sigma += raise;
  pair.left.error = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.01);
  pair.right.error = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.01);
  pair.left.facesCrossed = 3;
  pair.right.facesCrossed = 4;
  pair.left.crossed = 1;
  pair.right.crossed = random.chance(0.5) ? 1 : 2;
  return pair;
}

/// The largest gap between the pair and the merged window, which is nowhere above by more than
/// rounding.
double largestGap(const Pair& pair, const Window& merged)
{
  constexpr int samples = 2000;
  Extended largest = 0.0L;
  Extended least = 0.0L;
  for (int k = 0; k <= samples; ++k)
  {
    const Extended x =
      pair.left.begin + (pair.right.end - pair.left.begin) * static_cast<Extended>(k) / samples;
    const Extended gap = pair.distance(x) - exactDistance(merged, x);
    largest = std::max(largest, gap);
    least = std::min(least, gap);
  }
  EXPECT_GE(static_cast<double>(least), -Accuracy * (1.0 + pair.left.sigma + pair.right.sigma))
    << "above the originals:\n"
    << pair.left << "\n"
    << pair.right << "\n"
    << merged;
  return static_cast<double>(largest);
}

std::vector<Window> merge(
  const Pair& pair, double epsilon, double maximumAdded = geodesic::Infinity)
{
  std::vector<Window> windows = { pair.left, pair.right };
  mergeNeighbours(windows, 1.0, epsilon, maximumAdded);
  return windows;
}

}

TEST(WindowMerge, AMergedWindowIsNowhereAboveItsOriginalsAndItsErrorIsTheLargestGapPlusTheirs)
{
  Random random(1);
  int merges = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const Pair pair = randomPair(random);
    const std::vector<Window> list = merge(pair, 10.0);
    if (list.size() != 1)
    {
      continue;
    }
    SCOPED_TRACE(testing::Message() << pair.left << "\n" << pair.right);
    ++merges;
    const Window& merged = list[0];
    EXPECT_EQ(merged.begin, pair.left.begin);
    EXPECT_EQ(merged.end, pair.right.end);
    EXPECT_EQ(merged.facesCrossed, 4u);
    EXPECT_EQ(merged.crossed, pair.right.crossed == 1 ? 1 : geodesic::NoId);
    const double size = 1.0 + pair.left.sigma + pair.right.sigma;
    EXPECT_TRUE(merged.isLinear() || merged.sigma >= -Accuracy) << "a pseudo-source's distance";
    const Extended begin = merged.begin;
    EXPECT_NEAR(static_cast<double>(exactDistance(merged, begin) - exactDistance(pair.left, begin)),
      0.0, Accuracy * size);
    EXPECT_NEAR(static_cast<double>(exactDistance(merged, 1.0L) - exactDistance(pair.right, 1.0L)),
      0.0, Accuracy * size);
    const double inherited = std::max(pair.left.error, pair.right.error);
    const double gap = largestGap(pair, merged); // which is nowhere negative
    EXPECT_GE(merged.error, inherited + gap - Accuracy * size);
    // The error is not larger than the true gap, which samples miss by little.
    EXPECT_LE(merged.error, inherited + gap * 1.01 + 1e-5 * size);
    if (HasFailure())
    {
      return;
    }
  }
  EXPECT_GT(merges, 500);
}

TEST(WindowMerge, TheErrorStaysWithinEpsilonOfTheLeastDistance)
{
  Random random(3);
  for (const double epsilon : { 1e-4, 1e-2, 0.3 })
  {
    int merges = 0;
    int refused = 0;
    for (int i = 0; i < 20000; ++i)
    {
      const Pair pair = randomPair(random);
      std::vector<Window> list = { pair.left, pair.right };
      const double largest = mergeNeighbours(list, 1.0, epsilon);
      if (list.size() == 2)
      {
        ++refused;
        ASSERT_EQ(largest, 0.0);
        continue;
      }
      ++merges;
      ASSERT_LE(list[0].error, epsilon * list[0].minimum());
      ASSERT_EQ(largest, list[0].error / list[0].minimum());
    }
    EXPECT_GT(merges, 10) << epsilon;
    EXPECT_GT(refused, 10) << epsilon;
  }
}

TEST(WindowMerge, TheSumOfTheMergesOfOneListIsBoundedAndTheLargestErrorIsThatOfAllMerges)
{
  Random random(4);
  constexpr double maximum = 1e-3;
  std::size_t merges = 0;
  std::size_t chains = 0;
  for (int i = 0; i < 300; ++i)
  {
    // the envelope of many sources in a row, such as a curve's points
    std::vector<Window> windows;
    const int count = 40;
    for (int k = 0; k < count; ++k)
    {
      windows.push_back(circularWindow(k / 40.0, (k + 1) / 40.0,
        (k + random.uniform(0.3, 0.7)) / count, random.uniform(0.9, 1.1), 1.0));
      if (k > 0)
      {
        const double joint = windows[windows.size() - 1].begin;
        windows.back().sigma +=
          windows[windows.size() - 2].distance(joint) - windows.back().distance(joint);
      }
    }
    std::vector<Window> list = windows;
    const double found = mergeNeighbours(list, 1.0, 10.0, maximum);
    merges += windows.size() - list.size();
    double largest = 0.0;
    for (const Window& merged : list)
    {
      largest = std::max(largest, merged.error / merged.minimum());
      std::size_t replaced = 0;
      for (const Window& w : windows)
      {
        if (w.begin < merged.begin || w.end > merged.end)
        {
          continue;
        }
        ++replaced;
        for (int s = 0; s <= 20; ++s)
        {
          const Extended x = w.begin + (w.end - w.begin) * static_cast<Extended>(s) / 20.0L;
          const double gap = static_cast<double>(exactDistance(w, x) - exactDistance(merged, x));
          ASSERT_LE(gap, maximum + Accuracy * 10.0);
          ASSERT_GE(gap, -Accuracy * 10.0);
        }
      }
      chains += replaced > 2 ? 1 : 0;
    }
    EXPECT_DOUBLE_EQ(found, largest);
  }
  EXPECT_GT(merges, 300u);
  EXPECT_GT(chains, 100u) << "merged windows merge again";
}

TEST(WindowMerge, AtDistanceZeroNothingIsMerged)
{
  const Pair pair = { circularWindow(0.0, 0.5, 0.25, 0.0), circularWindow(0.5, 1.0, 0.25, 0.0) };
  EXPECT_EQ(merge(pair, 10.0).size(), 2u);
}

TEST(WindowMerge, WindowsThatDoNotMeetAreNotMerged)
{
  Pair pair = { circularWindow(0.0, 0.5, 0.5, 1.0, 1.0), circularWindow(0.5, 1.0, 0.5, 1.0, 1.0) };
  ASSERT_EQ(merge(pair, 10.0).size(), 1u);
  pair.right.begin += 1e-9;
  EXPECT_EQ(merge(pair, 10.0).size(), 2u);
}

TEST(WindowMerge, ParallelRaysThatDivergeAreNotMerged)
{
  Pair converge = { linearWindow(0.0, 0.5, 0.5, 1.0), linearWindow(0.5, 1.0, -0.5, 1.5) };
  EXPECT_EQ(merge(converge, 10.0).size(), 1u);
  Pair diverge = { linearWindow(0.0, 0.5, -0.5, 2.0), linearWindow(0.5, 1.0, 0.5, 1.5) };
  EXPECT_EQ(merge(diverge, 10.0).size(), 2u);
}

TEST(WindowMerge, RaysOfAMergedWindowLeadNoFartherThanThoseOfItsOriginals)
{
  // Even if the merged source comes close to the halfedge, and its depth, which determines where
  // rays go, is a difference of nearly equal numbers.
  Random random(5);
  int merges = 0;
  int shallow = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const double depth = std::pow(10.0, random.uniform(-12.0, -2.0));
    const double x = random.uniform(-0.2, 1.2);
    const double joint = random.uniform(0.1, 0.9);
    Pair pair = { circularWindow(0.0, joint, x, depth, 1.0),
      circularWindow(joint, 1.0, x * (1.0 + random.uniform(-1.0, 1.0) * depth), depth, 1.0) };
    pair.right.sigma += pair.left.distance(joint) - pair.right.distance(joint);
    const std::vector<Window> list = merge(pair, 10.0);
    if (list.size() != 1)
    {
      continue;
    }
    ++merges;
    shallow += list[0].sourceDepth < 1e-5 ? 1 : 0;
    for (const geodesic::Vec2 p :
      { geodesic::Vec2{ x, 1.0 }, { x + 0.3, 0.5 }, { x - 1.0, 1.0 }, { 0.5, 2.0 } })
    {
      const double original = std::min(pair.left.bentDistance(p), pair.right.bentDistance(p));
      ASSERT_LE(list[0].bentDistance(p), original + 2e-10) << pair.left << "\n"
                                                           << pair.right << "\n"
                                                           << list[0];
    }
  }
  EXPECT_GT(merges, 100);
  EXPECT_GT(shallow, 10);
}
