// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PacedProgress_h
#define geodesic_PacedProgress_h

#include "Tasks.h"

#include <chrono>

namespace geodesic
{

/// The same callback, for work whose pieces take unknown times: the work may call it after each of
/// them, and it passes on about fifty calls a second. The original callback must outlive it.
inline ProgressCallback paced(const ProgressCallback& callback)
{
  if (!callback)
  {
    return {};
  }
  using Clock = std::chrono::steady_clock;
  return [&callback, next = Clock::time_point::min()](double fraction) mutable
  {
    constexpr std::chrono::milliseconds betweenCalls(20);
    const Clock::time_point now = Clock::now();
    if (now < next)
    {
      return true;
    }
    next = now + betweenCalls;
    return callback(fraction);
  };
}

/// Calls item(task, i) for i below `count`. The tasks run in parallel, each with its own share of
/// the items, and look() is called every few items: for items that may take long.
///
/// \param prepare called with the number of tasks before some of them run.
template <typename Look, typename Prepare, typename Item>
void forItems(const ParallelFor& parallelFor, std::size_t count, const Look& look,
  const Prepare& prepare, const Item& item)
{
  const std::size_t itemsPerLook = parallelFor ? 256 : 16;
  constexpr std::size_t itemsPerTask = 2;
  constexpr std::size_t mostTasks = 64;
  for (std::size_t first = 0; first < count; first += itemsPerLook)
  {
    look();
    const std::size_t items = std::min(itemsPerLook, count - first);
    const std::size_t tasks =
      parallelFor ? std::clamp<std::size_t>(items / itemsPerTask, 1, mostTasks) : 1;
    prepare(tasks);
    forAll(parallelFor, tasks,
      [&](std::size_t task)
      {
        const std::size_t end = first + (task + 1) * items / tasks;
        for (std::size_t i = first + task * items / tasks; i < end; ++i)
        {
          item(task, i);
        }
      });
  }
}

}

#endif
