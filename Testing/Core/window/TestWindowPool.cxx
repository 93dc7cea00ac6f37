// SPDX-License-Identifier: BSD-3-Clause
// Memory of windows: that it is used again, and in which order an archive has its lists.
#include "window/WindowSupport.h"

#include "window/WindowArchive.h"
#include "window/WindowPool.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::Id;
using geodesic::WindowArchive;
using geodesic::WindowBlock;
using geodesic::WindowPool;
using geodesic::WindowRange;

namespace
{

/// Windows marked with their list and their position in it.
std::vector<Window> numbered(std::size_t count, double list)
{
  std::vector<Window> windows;
  for (std::size_t i = 0; i < count; ++i)
  {
    windows.push_back(
      circularWindow(static_cast<double>(i), static_cast<double>(i) + 1.0, list, 1.0));
  }
  return windows;
}

WindowRange rangeOf(const std::vector<Window>& windows)
{
  return { windows.data(), windows.data() + windows.size() };
}

/// The numbers of the lists that an archive has of a halfedge.
std::vector<double> listsOf(const WindowArchive& archive, Id halfedge)
{
  std::vector<double> lists;
  for (const Window& w : archive.at(halfedge))
  {
    lists.push_back(w.sourceX);
  }
  return lists;
}

}

TEST(WindowPool, FreedBlocksAreUsedAgain)
{
  WindowPool pool;
  const std::vector<Window> windows = numbered(5, 1.0);
  const WindowBlock first = pool.copyOf(rangeOf(windows));
  pool.free(first);
  EXPECT_EQ(pool.copyOf(rangeOf(numbered(7, 2.0))).data, first.data) << "of the same size class";
  EXPECT_NE(pool.copyOf(rangeOf(windows)).data, first.data) << "in use";
}

TEST(WindowArchive, TheListsOfAHalfedgeComeInTheOrderOfTheirTime)
{
  WindowArchive a;
  WindowArchive b;
  a.add(2, rangeOf(numbered(2, 10.0)), 1);
  b.add(2, rangeOf(numbered(1, 20.0)), 0);
  b.add(1, rangeOf(numbered(3, 30.0)), 1);
  a.add(2, rangeOf(numbered(1, 40.0)), 3);
  b.add(2, rangeOf(numbered(1, 50.0)), 2);
  a.add(0, rangeOf({}), 4);
  WindowArchive all;
  all.take(a);
  all.take(b);
  EXPECT_FALSE(all.isIndexed());
  all.index(4);
  EXPECT_TRUE(all.isIndexed());
  EXPECT_EQ(listsOf(all, 2), (std::vector<double>{ 20, 10, 10, 50, 40 }));
  EXPECT_EQ(listsOf(all, 1), (std::vector<double>{ 30, 30, 30 }));
  EXPECT_TRUE(all.at(0).empty());
  EXPECT_TRUE(all.at(3).empty());
}
