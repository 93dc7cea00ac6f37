// SPDX-License-Identifier: BSD-3-Clause
// Memory of windows: blocks of a pool, and the archive of kept windows.
#include "window/WindowSupport.h"

#include "window/WindowArchive.h"
#include "window/WindowPool.h"

#include <gtest/gtest.h>

#include <set>

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

void expectSame(const WindowRange& windows, const std::vector<Window>& expected)
{
  ASSERT_EQ(windows.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_EQ(windows.first[i].begin, expected[i].begin);
    ASSERT_EQ(windows.first[i].sourceX, expected[i].sourceX);
  }
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

TEST(WindowPool, BlocksKeepTheirWindowsWhateverIsAllocatedAndFreed)
{
  Random random(1);
  WindowPool pool;
  struct Held
  {
    WindowBlock block;
    std::vector<Window> windows;
  };
  std::vector<Held> held;
  for (int step = 0; step < 3000; ++step)
  {
    if (!held.empty() && random.chance(0.45))
    {
      const std::size_t i = random.below(held.size());
      expectSame(held[i].block.range(), held[i].windows);
      pool.free(held[i].block);
      held[i] = held.back();
      held.pop_back();
      continue;
    }
    const std::size_t size = random.chance(0.02) ? 3000 : random.between(1, 40);
    const std::vector<Window> windows = numbered(size, step);
    if (!held.empty() && random.chance(0.3))
    {
      Held& one = held[random.below(held.size())];
      const WindowBlock before = one.block;
      pool.assign(one.block, rangeOf(windows));
      one.windows = windows;
      ASSERT_EQ(one.block.data == before.data, size <= std::size_t(1) << before.sizeClass);
      continue;
    }
    held.push_back({ pool.copyOf(rangeOf(windows)), windows });
    ASSERT_GE(std::size_t(1) << held.back().block.sizeClass, size);
  }
  for (const Held& h : held)
  {
    expectSame(h.block.range(), h.windows);
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

TEST(WindowPool, ABlockMayBeFreedIntoAnotherPool)
{
  WindowPool a;
  WindowPool b;
  const WindowBlock block = a.copyOf(rangeOf(numbered(4, 1.0)));
  b.free(block);
  EXPECT_EQ(b.copyOf(rangeOf(numbered(4, 2.0))).data, block.data);
}

TEST(WindowPool, TheReleasedMemoryContainsTheBlocks)
{
  std::vector<std::unique_ptr<Window[]>> memory;
  WindowBlock block;
  const std::vector<Window> windows = numbered(10, 3.0);
  {
    WindowPool pool;
    block = pool.copyOf(rangeOf(windows));
    pool.free(pool.copyOf(rangeOf(windows)));
    memory = pool.release();
    // The pool begins anew and reuses none of the released memory.
    const WindowBlock fresh = pool.copyOf(rangeOf(windows));
    for (const auto& chunk : memory)
    {
      EXPECT_TRUE(
        std::less<>()(fresh.data, chunk.get()) || !std::less<>()(fresh.data, chunk.get() + 1024));
    }
  }
  EXPECT_FALSE(memory.empty());
  expectSame(block.range(), windows);
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

TEST(WindowArchive, ItKeepsCopiesAndWhatItOwns)
{
  WindowArchive archive;
  {
    const std::vector<Window> passing = numbered(6000, 1.0); // more than a chunk
    archive.add(0, rangeOf(passing));
    WindowPool pool;
    archive.adopt(1, pool.copyOf(rangeOf(numbered(3, 2.0))).range());
    archive.own(pool.release());
    archive.add(1, rangeOf(numbered(1, 3.0)));
  }
  archive.index(2);
  EXPECT_EQ(listsOf(archive, 0), std::vector<double>(6000, 1.0));
  EXPECT_EQ(listsOf(archive, 1), (std::vector<double>{ 2, 2, 2, 3 }));
}

TEST(WindowArchive, AnEmptiedArchiveCanBeUsedAgain)
{
  WindowArchive from;
  from.add(0, rangeOf(numbered(1, 1.0)));
  WindowArchive to;
  to.take(from);
  from.add(0, rangeOf(numbered(1, 2.0)));
  to.take(from);
  to.index(1);
  EXPECT_EQ(listsOf(to, 0), (std::vector<double>{ 1, 2 }));
}
