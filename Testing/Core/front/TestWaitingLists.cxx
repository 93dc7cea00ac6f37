// SPDX-License-Identifier: BSD-3-Clause
// The table of waiting lists, compared with std::map.
#include "front/WaitingLists.h"

#include "truth/TestMeshes.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

using geodesic::Id;
using geodesic::NoId;
using geodesic::WaitingLists;
using geodesic::Window;
using geodesic::WindowBlock;
using geodesic::WindowPool;
using geodesictest::Random;

namespace
{

/// A list of one window, identified by its begin.
WindowBlock listWith(double begin, WindowPool& pool)
{
  Window window{};
  window.begin = begin;
  return pool.copyOf({ &window, &window + 1 });
}

/// The expected begin of each halfedge's list.
using Expected = std::map<Id, double>;

Expected contentOf(const WaitingLists& lists)
{
  Expected content;
  lists.forEach(
    [&](const WaitingLists::List& list) {
      EXPECT_TRUE(content.emplace(list.halfedge, list.windows.data->begin).second) << "found twice";
    });
  return content;
}

/// A halfedge's hash in a table of 2^bits places.
std::size_t homeOf(Id halfedge, unsigned bits)
{
  return static_cast<std::size_t>((halfedge * std::uint64_t(0x9e3779b97f4a7c15U)) >> (64 - bits));
}

}

TEST(WaitingLists, WithoutListsNoneIsFound)
{
  const WaitingLists lists;
  EXPECT_EQ(lists.find(0), NoId);
  EXPECT_EQ(lists.find(NoId), NoId);
  EXPECT_TRUE(contentOf(lists).empty());
}

TEST(WaitingLists, AgreeWithAMap)
{
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    WindowPool pool;
    WaitingLists lists;
    Expected expected;
    const Id halfedges = random.between(1, 400);
    const Id step = random.chance(0.5) ? 1 : random.between(1, 1000000);
    for (int i = 0; i < 3000; ++i)
    {
      const Id halfedge = random.below(halfedges) * step;
      const Id list = lists.find(halfedge);
      ASSERT_EQ(list != NoId, expected.count(halfedge) == 1) << "halfedge " << halfedge;
      if (list == NoId)
      {
        expected[halfedge] = i;
        EXPECT_EQ(lists.find(halfedge), NoId);
        const Id added = lists.add(halfedge, listWith(i, pool));
        EXPECT_EQ(lists.find(halfedge), added);
        continue;
      }
      EXPECT_EQ(lists[list].halfedge, halfedge);
      EXPECT_EQ(lists[list].windows.data->begin, expected[halfedge]);
      const WindowBlock removed = lists.remove(list);
      EXPECT_EQ(removed.data->begin, expected[halfedge]);
      pool.free(removed);
      expected.erase(halfedge);
    }
    EXPECT_EQ(contentOf(lists), expected);
  }
}

TEST(WaitingLists, HalfedgesWithEqualHashesAreDistinguished)
{
  // Including the end of the table, where probing continues at its beginning; removed in random
  // order.
  constexpr unsigned bits = 5;
  for (const std::size_t home : { 0U, 7U, 30U, 31U })
  {
    std::vector<Id> halfedges;
    for (Id halfedge = 0; halfedges.size() < 8; ++halfedge)
    {
      const std::size_t behind = (homeOf(halfedge, bits) - home) & 31U;
      if (behind < 2)
      {
        halfedges.push_back(halfedge);
      }
    }
    for (std::uint64_t seed = 0; seed < 50; ++seed)
    {
      Random random(seed);
      WindowPool pool;
      WaitingLists lists;
      for (const Id halfedge : halfedges)
      {
        lists.add(halfedge, listWith(halfedge, pool));
      }
      std::vector<Id> left = halfedges;
      while (!left.empty())
      {
        const std::size_t i = random.below(static_cast<Id>(left.size()));
        lists.remove(lists.find(left[i]));
        EXPECT_EQ(lists.find(left[i]), NoId);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        for (const Id halfedge : left)
        {
          ASSERT_NE(lists.find(halfedge), NoId);
          EXPECT_EQ(lists[lists.find(halfedge)].windows.data->begin, halfedge);
        }
      }
    }
  }
}

TEST(WaitingLists, AListMayGrowAndShrink)
{
  WindowPool pool;
  WaitingLists lists;
  const Id list = lists.add(7, listWith(1.0, pool));
  const std::vector<Window> longer(5, *lists[list].windows.data);
  lists.assign(list, { longer.data(), longer.data() + longer.size() }, pool);
  EXPECT_EQ(lists[list].windows.size, 5U);
  EXPECT_EQ(lists.find(7), list);
  lists.assign(list, { longer.data(), longer.data() + 2 }, pool);
  EXPECT_EQ(lists[list].windows.size, 2U);
  EXPECT_EQ(lists.remove(list).sizeClass, 3U) << "its block holds what it once held";
}
