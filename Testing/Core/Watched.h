// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_Watched_h
#define geodesictest_Watched_h

#include "Errors.h"
#include "Job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace geodesictest
{

/// Checks that work tells its watcher how far it is, from 0 to 1 and never back, and that it stops
/// in the call in which the watcher asks for it. \returns what the watcher was told.
///
/// \param leastCalls of the watcher. In the first half of these, up to the fourth, it asks to stop.
/// \param work (const geodesic::Job&).
template <typename Work>
std::vector<double> expectWatched(std::size_t leastCalls, const Work& work)
{
  std::vector<double> told = { 0.0 };
  work(geodesic::Job(
    [&told](double fraction)
    {
      told.push_back(fraction);
      return true;
    }));
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);
  told.erase(told.begin());
  EXPECT_GE(told.size(), leastCalls);
  for (std::size_t allowed = 0; allowed < std::min<std::size_t>(leastCalls / 2, 4); ++allowed)
  {
    std::size_t calls = 0;
    EXPECT_THROW(work(geodesic::Job([&](double) { return calls++ < allowed; })), geodesic::Aborted);
    EXPECT_EQ(calls, allowed + 1);
  }
  return told;
}

}

#endif
