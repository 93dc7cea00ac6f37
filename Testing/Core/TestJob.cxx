// SPDX-License-Identifier: BSD-3-Clause
// What a job tells its watcher, and how it divides loops among threads.
#include "OnThreads.h"

#include "Errors.h"
#include "Job.h"
#include "ThreadTeam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace geodesictest;
using geodesic::Job;
using geodesic::ParallelFor;

namespace
{

/// A watcher that remembers what it was told.
struct Memory
{
  std::vector<double> told;

  geodesic::Watcher watcher()
  {
    return [this](double done)
    {
      this->told.push_back(done);
      return true;
    };
  }
};

} // anonymous namespace

TEST(Job, APartTellsItsStretchOfTheWhole)
{
  Memory memory;
  const Job job(memory.watcher());
  const Job inner = job.part(0.5, 1.0).part(0.5, 0.75);
  job.reach(0.25);
  inner.reach(0.0);
  inner.reach(0.5);
  inner.reach(2.0);
  EXPECT_EQ(memory.told, (std::vector<double>{ 0.25, 0.75, 0.8125, 0.875 }));
}

TEST(Job, NeverTellsThatWorkWasUndone)
{
  Memory memory;
  const Job job(memory.watcher());
  job.part(0.0, 0.8).reach(1.0);
  job.part(0.2, 0.4).reach(0.5);
  EXPECT_EQ(memory.told, (std::vector<double>{ 0.8, 0.8 }));
}

TEST(Job, StopsWhereItsWatcherAsksForIt)
{
  const Job job([](double done) { return done < 0.5; });
  EXPECT_NO_THROW(job.reach(0.4));
  EXPECT_THROW(job.part(0.5, 1.0).reach(0.0), geodesic::Aborted);
  EXPECT_THROW(Job([](double) { return false; }).loop(1, [](std::size_t) {}), geodesic::Aborted);
  EXPECT_NO_THROW(Job().reach(0.5));
}

TEST(Job, LookingAMillionTimesTellsTheWatcherFiftyTimesASecond)
{
  Memory memory;
  const Job job(memory.watcher());
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000000; ++i)
  {
    job.look();
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(memory.told.size(), 1U);
  EXPECT_LE(static_cast<double>(memory.told.size()), 2.0 + 50.0 * seconds.count());
}

TEST(JobInParallel, VisitsEachItemOnceAndReturnsResultsInOrder)
{
  for (const std::size_t count : { 0U, 1U, 1023U, 1024U, 1025U, 100000U })
  {
    std::vector<std::size_t> expected(count);
    std::iota(expected.begin(), expected.end(), std::size_t(0));
    for (const ParallelFor& way : waysToRun())
    {
      const Job job({}, way);
      std::vector<std::size_t> visited(count, 0);
      job.loop(count, [&](std::size_t i) { visited[i] += i; });
      EXPECT_EQ(visited, expected);
      std::size_t next = 0;
      for (const auto& [begin, end] : job.resultsOfRanges(
             count, [](std::size_t first, std::size_t last) { return std::pair(first, last); }))
      {
        EXPECT_EQ(begin, next);
        next = end;
      }
      EXPECT_EQ(next, count);
      std::vector<std::size_t> ofTasks(count, 0);
      job.loopByTasks(count,
        [&](std::size_t task, std::size_t i)
        {
          EXPECT_LT(task, Job::MostTasks);
          ofTasks[i] += i;
        });
      EXPECT_EQ(ofTasks, expected);
    }
  }
}

// Each task goes on until its look says that the watcher, who hears of the work on the caller's
// thread alone, wants it to stop.
TEST(JobInParallel, TasksOnAllThreadsStopWhenTheirWatcherAsksForIt)
{
  const std::thread::id caller = std::this_thread::get_id();
  for (const std::size_t tasks : { 2U, 3U, 40U })
  {
    for (const int calls : { 1, 5 })
    {
      int called = 0;
      const auto watcher = [&](double)
      {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        return ++called < calls;
      };
      const Job job(watcher, geodesic::teamOf(3));
      std::atomic<std::size_t> stopped{ 0 };
      const auto workUntilStopped = [&](std::size_t)
      {
        try
        {
          while (true)
          {
            job.look();
          }
        }
        catch (const geodesic::Aborted&)
        {
          ++stopped;
          throw;
        }
      };
      EXPECT_THROW(job.tasks(tasks, workUntilStopped), geodesic::Aborted);
      EXPECT_EQ(stopped, tasks);
      EXPECT_EQ(called, calls);
    }
  }
}

// One thread still works at a long task when the caller's has nothing left to do. Where other
// processes want the processors, the caller's may have to do all, and the next loop is looked at.
TEST(JobInParallel, IsWatchedWhileAnotherThreadIsAtTheLastTask)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> called{ 0 };
  const auto watcher = [&](double)
  {
    ++called;
    return called < 5;
  };
  const ParallelFor team = geodesic::teamOf(2);
  std::atomic<bool> isElsewhere{ false };
  const auto task = [&](const Job& job)
  {
    const auto begin = std::chrono::steady_clock::now();
    if (std::this_thread::get_id() == caller)
    {
      while (
        !isElsewhere && std::chrono::steady_clock::now() < begin + std::chrono::milliseconds(100))
      {
        std::this_thread::yield();
      }
      return;
    }
    isElsewhere = true;
    while (std::chrono::steady_clock::now() < begin + std::chrono::seconds(20))
    {
      job.look();
    }
  };
  bool isAborted = false;
  for (int loop = 0; loop < 200 && !isElsewhere; ++loop)
  {
    called = 0;
    const Job job(watcher, team);
    try
    {
      job.tasks(2, [&](std::size_t) { task(job); });
    }
    catch (const geodesic::Aborted&)
    {
      isAborted = true;
    }
  }
  EXPECT_TRUE(isElsewhere);
  EXPECT_TRUE(isAborted);
  EXPECT_EQ(called, 5);
}

// One task takes much longer than the others and only tells how far it is.
TEST(LongTasksInParallel, AreReportedAndStoppedFromTheCallingThreadWhileTheyRun)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> isStopped{ false };
  const auto task = [&](std::size_t number, const Job& job)
  {
    try
    {
      if (number == 3)
      {
        for (double fraction = 0.0;; fraction = 0.5)
        {
          job.reach(fraction);
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      }
    }
    catch (const geodesic::Aborted&)
    {
      isStopped = true;
      throw;
    }
  };
  std::vector<double> reports;
  const auto watcher = [&](double fraction)
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    reports.push_back(fraction);
    return reports.size() < 5;
  };
  EXPECT_THROW(Job(watcher, onThreads).longTasks(10, task), geodesic::Aborted);
  EXPECT_TRUE(isStopped);
  EXPECT_EQ(reports.size(), 5U);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_GT(reports.back(), 0.5);
  EXPECT_LT(reports.back(), 1.0);
}

TEST(LongTasksInParallel, EndWithTheFirstExceptionOfOne)
{
  const auto task = [&](std::size_t number, const Job& job)
  {
    if (number == 0)
    {
      throw std::runtime_error("the first");
    }
    while (true)
    {
      job.reach(0.1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  try
  {
    Job({}, onThreads).longTasks(6, task);
    FAIL() << "nothing was thrown";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), "the first");
  }
}

TEST(LongTasks, OneAfterAnotherAreReportedAsOne)
{
  std::vector<double> reports;
  const auto watcher = [&](double fraction)
  {
    reports.push_back(fraction);
    return true;
  };
  Job(watcher).longTasks(4, [](std::size_t, const Job& job) { job.reach(0.5); });
  EXPECT_EQ(reports, (std::vector<double>{ 0.125, 0.375, 0.625, 0.875 }));
}
