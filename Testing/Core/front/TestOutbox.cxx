// SPDX-License-Identifier: BSD-3-Clause
// The grouping of what a batch sends, against a stable sort.
#include "front/Outbox.h"

#include "truth/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

using geodesic::Id;
using geodesic::Outbox;
using geodesic::SentList;
using geodesic::Window;
using geodesic::WindowBlock;
using geodesictest::Random;

namespace
{

/// A list that is known again by its place.
WindowBlock blockAt(Window& window)
{
  WindowBlock block{};
  block.data = &window;
  block.size = 1;
  return block;
}

using Groups = std::vector<std::pair<Id, std::vector<const Window*>>>;

/// Sorted by halfedge, what is equal in the order in which it was sent; then the groups in the
/// order of their first list.
Groups sortedGroups(const std::vector<SentList>& sent)
{
  std::vector<std::pair<SentList, std::size_t>> sorted;
  for (std::size_t i = 0; i < sent.size(); ++i)
  {
    sorted.emplace_back(sent[i], i);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const auto& a, const auto& b) { return a.first.halfedge < b.first.halfedge; });
  std::map<std::size_t, std::pair<Id, std::vector<const Window*>>> byFirst;
  for (std::size_t i = 0; i < sorted.size();)
  {
    auto& group = byFirst[sorted[i].second];
    group.first = sorted[i].first.halfedge;
    for (; i < sorted.size() && sorted[i].first.halfedge == group.first; ++i)
    {
      group.second.push_back(sorted[i].first.windows.data);
    }
  }
  Groups result;
  for (const auto& [first, group] : byFirst)
  {
    result.push_back(group);
  }
  return result;
}

Groups groupsOf(const Outbox& outbox)
{
  Groups result;
  for (std::size_t group = 0; group < outbox.numberOfGroups(); ++group)
  {
    result.push_back({ outbox.halfedge(group), {} });
    outbox.forEach(
      group, [&](const WindowBlock& block) { result.back().second.push_back(block.data); });
  }
  return result;
}

/// Sends lists to these halfedges from some workers and compares the groups.
void expectSorted(Outbox& outbox, const std::vector<Id>& halfedges, std::size_t workers)
{
  std::vector<Window> windows(halfedges.size());
  std::vector<SentList> all;
  outbox.clear();
  for (std::size_t worker = 0; worker < workers; ++worker)
  {
    std::vector<SentList> sent;
    for (std::size_t i = worker * halfedges.size() / workers;
         i < (worker + 1) * halfedges.size() / workers; ++i)
    {
      sent.push_back({ halfedges[i], blockAt(windows[i]) });
    }
    all.insert(all.end(), sent.begin(), sent.end());
    outbox.take(sent);
    EXPECT_TRUE(sent.empty()) << "what was taken over is gone from the sender";
  }
  outbox.group();
  EXPECT_EQ(groupsOf(outbox), sortedGroups(all));
}

/// Where the outbox looks for a halfedge first, of a table of 2^bits places.
std::size_t placeOf(Id halfedge, unsigned bits)
{
  return static_cast<std::size_t>((halfedge * std::uint64_t(0x9e3779b97f4a7c15U)) >> (64 - bits));
}

}

TEST(Outbox, WithoutListsThereAreNoGroups)
{
  Outbox outbox;
  outbox.clear();
  outbox.group();
  EXPECT_EQ(outbox.numberOfGroups(), 0U);
}

TEST(Outbox, GroupsAreThoseOfAStableSort)
{
  Outbox outbox; // used again and again, for more and for less
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::size_t count = random.below(seed % 10 == 0 ? 3000 : 40);
    const Id different = random.between(1, 2000);
    const Id first = random.chance(0.5) ? 0 : geodesic::NoId - 1 - different;
    const Id step = random.chance(0.5) ? 1 : random.between(1, 1000000);
    std::vector<Id> halfedges;
    for (std::size_t i = 0; i < count; ++i)
    {
      halfedges.push_back(first + random.below(different) * step);
    }
    expectSorted(outbox, halfedges, random.between(1, 5));
  }
}

TEST(Outbox, HalfedgesOfOnePlaceInTheTableAreToldApart)
{
  // Also in the last place of the table, behind which the first one follows.
  for (const std::size_t place : { 0U, 7U, 15U })
  {
    std::vector<Id> halfedges;
    for (Id halfedge = 0; halfedges.size() < 8; ++halfedge)
    {
      if (placeOf(halfedge, 4) == place)
      {
        halfedges.push_back(halfedge);
      }
    }
    halfedges.resize(4);
    halfedges.insert(halfedges.end(), halfedges.rbegin(), halfedges.rend());
    Outbox outbox;
    expectSorted(outbox, halfedges, 1);
  }
}

TEST(Outbox, WhatWasSentBeforeIsForgotten)
{
  Outbox outbox;
  expectSorted(outbox, { 5, 6, 5, 7 }, 1);
  expectSorted(outbox, { 6 }, 1);
  expectSorted(outbox, {}, 1);
}
