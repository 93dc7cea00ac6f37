// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Tasks_h
#define geodesic_Tasks_h

#include "Progress.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace geodesic
{

/// Runs task(0) to task(count - 1), in any order and possibly at the same time, and returns when
/// all have finished.
using ParallelFor =
  std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// Runs the tasks one after another if there is no ParallelFor.
template <typename Task>
void forAll(const ParallelFor& parallelFor, std::size_t count, const Task& task)
{
  if (parallelFor && count > 1)
  {
    parallelFor(count, task);
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    task(i);
  }
}

/// A loop over many small items is cut into ranges of this many items, so that each range's result
/// depends on the items alone.
constexpr std::size_t ItemsInRange = 1024;

inline std::size_t numberOfRanges(std::size_t count)
{
  return (count + ItemsInRange - 1) / ItemsInRange;
}

/// Calls range(begin, end) in parallel for ranges that make up the items below `count`.
///
/// \param progress called between ranges, by the calling thread.
/// \throws Aborted
template <typename Range>
void forRanges(const ParallelFor& parallelFor, std::size_t count, const LoopProgress& progress,
  const Range& range)
{
  const std::size_t rangesPerReport = parallelFor ? 32 : 8;
  const std::size_t ranges = numberOfRanges(count);
  for (std::size_t first = 0; first < ranges; first += rangesPerReport)
  {
    progress.at(first * ItemsInRange, count);
    forAll(parallelFor, std::min(rangesPerReport, ranges - first),
      [&](std::size_t i)
      {
        const std::size_t begin = (first + i) * ItemsInRange;
        range(begin, std::min(begin + ItemsInRange, count));
      });
  }
}

template <typename Range>
void forRanges(const ParallelFor& parallelFor, std::size_t count, const Range& range)
{
  const ProgressCallback nobody;
  forRanges(parallelFor, count, LoopProgress(nobody), range);
}

/// forRanges() for ranges that return a result. \returns the results in the order of the ranges.
template <typename Range>
auto resultsOfRanges(const ParallelFor& parallelFor, std::size_t count,
  const LoopProgress& progress, const Range& range)
{
  using Result = std::invoke_result_t<Range, std::size_t, std::size_t>;
  static_assert(!std::is_same_v<Result, bool>, "neighbours would share a byte");
  std::vector<Result> results(numberOfRanges(count));
  forRanges(parallelFor, count, progress,
    [&](std::size_t begin, std::size_t end) { results[begin / ItemsInRange] = range(begin, end); });
  return results;
}

template <typename Range>
auto resultsOfRanges(const ParallelFor& parallelFor, std::size_t count, const Range& range)
{
  const ProgressCallback nobody;
  return resultsOfRanges(parallelFor, count, LoopProgress(nobody), range);
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
