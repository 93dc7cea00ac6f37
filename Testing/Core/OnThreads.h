// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_OnThreads_h
#define geodesictest_OnThreads_h

#include "Tasks.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace geodesictest
{

/// Runs the tasks on several threads, each of which takes the next remaining task.
inline void onSomeThreads(
  std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& task)
{
  std::atomic<std::size_t> next{ 0 };
  const auto work = [&]()
  {
    for (std::size_t i = next++; i < count; i = next++)
    {
      task(i);
    }
  };
  std::vector<std::thread> others;
  while (others.size() + 1 < threads)
  {
    others.emplace_back(work);
  }
  work();
  for (std::thread& other : others)
  {
    other.join();
  }
}

/// onSomeThreads() on three threads.
inline void onThreads(std::size_t count, const std::function<void(std::size_t)>& task)
{
  onSomeThreads(3, count, task);
}

/// One task after another, forwards and backwards, and on several threads.
inline std::vector<geodesic::ParallelFor> waysToRun()
{
  using Task = std::function<void(std::size_t)>;
  std::vector<geodesic::ParallelFor> ways = { geodesic::ParallelFor(),
    [](std::size_t count, const Task& task)
    {
      while (count > 0)
      {
        task(--count);
      }
    } };
  for (const std::size_t threads : { std::size_t(2), std::size_t(5) })
  {
    ways.emplace_back(
      [threads](std::size_t count, const Task& task) { onSomeThreads(threads, count, task); });
  }
  return ways;
}

}

#endif
