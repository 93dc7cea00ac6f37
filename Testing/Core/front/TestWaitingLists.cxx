// SPDX-License-Identifier: BSD-3-Clause
// Groups of waiting lists, compared with plain vectors.
#include "front/WaitingLists.h"

#include "truth/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

using geodesic::HalfedgeList;
using geodesic::Id;
using geodesic::NoId;
using geodesic::WaitingLists;
using geodesictest::Random;

namespace
{

std::vector<Id> halfedgesOf(const std::vector<HalfedgeList>& lists)
{
  std::vector<Id> halfedges(lists.size());
  std::transform(lists.begin(), lists.end(), halfedges.begin(),
    [](const HalfedgeList& list) { return list.halfedge; });
  return halfedges;
}

}

TEST(WaitingLists, AreFoundAndTakenTheNewestFirst)
{
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    WaitingLists lists;
    std::array<Id, 3> groups = { NoId, NoId, NoId };
    std::array<std::vector<Id>, 3> expected;
    for (int step = 0; step < 1000; ++step)
    {
      const Id vertex = random.below(3);
      const Id halfedge = 3 * random.below(20) + vertex;
      std::vector<Id>& waiting = expected[vertex];
      const WaitingLists::List* found = lists.find(groups[vertex], halfedge);
      const bool isThere = std::count(waiting.begin(), waiting.end(), halfedge) > 0;
      ASSERT_EQ(found != nullptr, isThere);
      if (!isThere)
      {
        EXPECT_EQ(lists.add(groups[vertex], { halfedge, {} }).halfedge, halfedge);
        waiting.insert(waiting.begin(), halfedge);
        continue;
      }
      EXPECT_EQ(found->halfedge, halfedge);
      const Id divisor = random.between(2, 5);
      const auto isTaken = [divisor](Id taken) { return taken % divisor == 0; };
      std::vector<HalfedgeList> taken = { { NoId, {} } };
      lists.take(
        groups[vertex],
        [&](const WaitingLists::List& list)
        {
          EXPECT_EQ(list.due, geodesic::Infinity);
          return isTaken(list.halfedge);
        },
        taken);
      std::vector<Id> expectedTaken;
      std::copy_if(waiting.begin(), waiting.end(), std::back_inserter(expectedTaken), isTaken);
      EXPECT_EQ(halfedgesOf(taken), expectedTaken);
      waiting.erase(std::remove_if(waiting.begin(), waiting.end(), isTaken), waiting.end());
      EXPECT_EQ(groups[vertex] == NoId, waiting.empty());
    }
    std::vector<Id> all;
    lists.forEach([&](const WaitingLists::List& list) { all.push_back(list.halfedge); });
    std::vector<Id> left;
    for (const std::vector<Id>& waiting : expected)
    {
      left.insert(left.end(), waiting.begin(), waiting.end());
    }
    std::sort(all.begin(), all.end());
    std::sort(left.begin(), left.end());
    EXPECT_EQ(all, left);
  }
}
