// SPDX-License-Identifier: BSD-3-Clause
// The threads that stay for a computation. Under ThreadSanitizer, too.
#include "ThreadTeam.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using geodesic::ThreadTeam;

namespace
{

/// Whether two tasks of one loop run at the same time: each waits for the other. Where other
/// processes want the processors, the team may do some loops with one member.
bool runsTwoAtATime(ThreadTeam& team)
{
  std::atomic<bool> haveMet{ false };
  const auto giveUp = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!haveMet && std::chrono::steady_clock::now() < giveUp)
  {
    std::atomic<int> arrived{ 0 };
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
    team.run(2,
      [&](std::size_t)
      {
        ++arrived;
        while (arrived < 2 && std::chrono::steady_clock::now() < end)
        {
          std::this_thread::yield();
        }
        haveMet = haveMet || std::chrono::steady_clock::now() < end;
      });
  }
  return haveMet;
}

} // anonymous namespace

TEST(ParallelTeam, RunsEachTaskOfManyLoopsOnce)
{
  for (const std::size_t threads : { 1U, 2U, 3U, 8U })
  {
    ThreadTeam team(threads);
    std::vector<int> runs(50, 0);
    constexpr int loops = 2000;
    for (int loop = 0; loop < loops; ++loop)
    {
      team.run(runs.size(), [&](std::size_t task) { ++runs[task]; });
    }
    EXPECT_EQ(runs, std::vector<int>(runs.size(), loops)) << threads;
    team.run(0, [](std::size_t) { FAIL() << "there is no task"; });
  }
}

TEST(ParallelTeam, WorksAtTheSameTimeAlsoAfterAPauseInWhichItSleeps)
{
  ThreadTeam team(2);
  EXPECT_TRUE(runsTwoAtATime(team));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_TRUE(runsTwoAtATime(team));
}

TEST(ParallelTeam, TakesNoProcessorTimeBetweenLoops)
{
  ThreadTeam team(4);
  team.run(4, [](std::size_t) {});
  std::this_thread::sleep_for(std::chrono::milliseconds(100)); // until all sleep
  const std::clock_t begin = std::clock();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 0.1);
}

TEST(ParallelTeam, ThrowsTheExceptionOfATaskAgainAndGoesOn)
{
  ThreadTeam team(3);
  for (int loop = 0; loop < 200; ++loop)
  {
    std::atomic<int> others{ 0 };
    try
    {
      team.run(10,
        [&](std::size_t task)
        {
          if (task == 7)
          {
            throw std::runtime_error("task 7");
          }
          ++others;
        });
      FAIL() << "nothing was thrown";
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(std::string(error.what()), "task 7");
    }
    EXPECT_EQ(others, 9);
  }
}
