// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_OnThreads_h
#define geodesictest_OnThreads_h

#include "Job.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace geodesictest
{

/// Runs work(0), ..., work(count - 1) at the same time: the first in the calling thread, the others
/// in threads that stay for the next call. None may throw.
void together(std::size_t count, const std::function<void(std::size_t)>& work);

/// Runs the tasks on several threads, each of which takes the next remaining task. None may throw.
void onSomeThreads(
  std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& task);

/// onSomeThreads() on three threads, as a ParallelFor that nobody watches.
inline void onThreads(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& = {})
{
  onSomeThreads(3, count, task);
}

/// One task after another, forwards and backwards, and on several threads.
inline std::vector<geodesic::ParallelFor> waysToRun()
{
  using Task = std::function<void(std::size_t)>;
  using Wait = std::function<void()>;
  std::vector<geodesic::ParallelFor> ways = { geodesic::ParallelFor(),
    [](std::size_t count, const Task& task, const Wait&)
    {
      while (count > 0)
      {
        task(--count);
      }
    } };
  for (const std::size_t threads : { std::size_t(2), std::size_t(5) })
  {
    ways.emplace_back([threads](std::size_t count, const Task& task, const Wait&)
      { onSomeThreads(threads, count, task); });
  }
  return ways;
}

}

#endif
