// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Job_h
#define geodesic_Job_h

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace geodesic
{

/// Runs task(0) to task(count - 1), in any order and possibly at the same time, and returns when
/// all have finished. While the caller's thread has nothing to do but to wait for others, it calls
/// wait() now and then. If tasks throw, one of their exceptions is thrown again in the end.
using ParallelFor = std::function<void(std::size_t count,
  const std::function<void(std::size_t)>& task, const std::function<void()>& wait)>;

/// Called now and then, by the thread that called the engine, with the fraction done in [0, 1],
/// which never decreases; returns false to ask for a stop.
using Watcher = std::function<bool(double done)>;

/// A loop over many small items is cut into ranges of this many items, so that each range's result
/// depends on the items alone.
constexpr std::size_t ItemsInRange = 1024;

/// What the caller of a computation gives it: threads to work on, and a watcher, who is told how
/// far the work is and can stop it. A job is passed down from function to function; part() is the
/// stretch of it that a step of the work takes. Copies are cheap and share the watcher.
///
/// Results never depend on the threads. Members that tell the watcher throw Aborted if the watcher
/// asks for a stop. Only the caller's thread calls them; tasks may call look().
class Job
{
public:
  /// Which tasks are shared among several threads: all, or only those of steps that take less time
  /// that way. What pays is found out by the clock; results are the same.
  enum class Sharing
  {
    Always,
    WherePaying
  };

  /// One thread, and nobody watches.
  Job() = default;

  /// \param watcher if empty, nobody watches.
  /// \param threads if empty, one thread.
  explicit Job(Watcher watcher, ParallelFor threads = {}, Sharing sharing = Sharing::Always);

  bool isParallel() const;
  /// Always, unless the job was made otherwise.
  Sharing sharing() const;

  /// The stretch of this job from one of its fractions to another. Work that is repeated may use
  /// the same stretch again: the watcher does not see that.
  Job part(double begin, double end) const
  {
    Job result = *this;
    result.begin_ = this->begin_ + (this->end_ - this->begin_) * begin;
    result.end_ = this->begin_ + (this->end_ - this->begin_) * end;
    return result;
  }

  /// Tells the watcher that the work has come so far.
  void reach(double fraction) const;

  /// The same for steps that take unknown times: it may be called as often as convenient, and the
  /// watcher hears about fifty calls a second. In a task on another thread it only throws Aborted
  /// once the watcher has asked for a stop.
  void look(double fraction = 0.0) const;

  /// The same for item `item` of a loop over many small ones.
  void reachItem(std::size_t item, std::size_t count) const
  {
    constexpr std::size_t itemsPerReport = 8192; // a power of two
    if (item % itemsPerReport == 0)
    {
      this->reach(static_cast<double>(item) / static_cast<double>(count));
    }
  }

  /// Runs task(i) for i below `count` on the threads.
  template <typename Task>
  void tasks(std::size_t count, const Task& task) const
  {
    if (this->isParallel() && count > 1)
    {
      this->inParallel(count, std::cref(task));
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      task(i);
    }
  }

  /// Runs item(i) for i below `count` on the threads, many at a time: for small items.
  template <typename Item>
  void loop(std::size_t count, const Item& item) const
  {
    this->ranges(count,
      [&item](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          item(i);
        }
      });
  }

  /// Runs range(begin, end) on the threads for ranges that make up the items below `count`.
  template <typename Range>
  void ranges(std::size_t count, const Range& range) const
  {
    const std::size_t rangesPerReport = this->isParallel() ? 32 : 8;
    const std::size_t ranges = numberOfRanges(count);
    for (std::size_t first = 0; first < ranges; first += rangesPerReport)
    {
      this->reachItem(first * ItemsInRange, count);
      this->tasks(std::min(rangesPerReport, ranges - first),
        [&](std::size_t i)
        {
          const std::size_t begin = (first + i) * ItemsInRange;
          range(begin, std::min(begin + ItemsInRange, count));
        });
    }
  }

  /// ranges() for ranges that return a result. \returns the results in the order of the ranges.
  template <typename Range>
  auto resultsOfRanges(std::size_t count, const Range& range) const
  {
    using Result = std::invoke_result_t<Range, std::size_t, std::size_t>;
    static_assert(!std::is_same_v<Result, bool>, "neighbours would share a byte");
    std::vector<Result> results(numberOfRanges(count));
    this->ranges(count,
      [&](std::size_t begin, std::size_t end)
      { results[begin / ItemsInRange] = range(begin, end); });
    return results;
  }

  /// Into how many tasks loopByTasks() divides a loop at most.
  static constexpr std::size_t MostTasks = 64;

  /// Runs item(task, i) for i below `count`, for items that may take long. The tasks run on the
  /// threads, each with its own share of the items. The number of items alone determines them.
  template <typename Item>
  void loopByTasks(std::size_t count, const Item& item) const
  {
    const std::size_t itemsPerLook = this->isParallel() ? 256 : 16;
    constexpr std::size_t itemsPerTask = 2;
    for (std::size_t first = 0; first < count; first += itemsPerLook)
    {
      this->look();
      const std::size_t items = std::min(itemsPerLook, count - first);
      const std::size_t tasks =
        this->isParallel() ? std::clamp<std::size_t>(items / itemsPerTask, 1, MostTasks) : 1;
      this->tasks(tasks,
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

  /// Runs long tasks on the threads. Each gets a job of its own, with one thread, and tells that
  /// one how far it is; meanwhile the caller's thread tells the watcher, many times a second. If a
  /// task throws, the others are stopped, and the exception is thrown again.
  void longTasks(
    std::size_t count, const std::function<void(std::size_t number, const Job& job)>& task) const;

private:
  struct Caller;

  static std::size_t numberOfRanges(std::size_t count)
  {
    return (count + ItemsInRange - 1) / ItemsInRange;
  }

  void inParallel(std::size_t count, const std::function<void(std::size_t)>& task) const;

  /// Null: one thread, and nobody watches.
  std::shared_ptr<Caller> caller_;
  double begin_ = 0.0;
  double end_ = 1.0;
};

}

#endif
