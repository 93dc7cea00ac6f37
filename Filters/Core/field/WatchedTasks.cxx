// SPDX-License-Identifier: BSD-3-Clause
#include "field/WatchedTasks.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <future>
#include <mutex>
#include <system_error>

namespace geodesic
{

namespace
{

/// Tasks in other threads, as the calling thread watches them.
class TasksAside
{
public:
  TasksAside(std::size_t count, const WatchedTask& task)
    : count_(count)
    , task_(task)
  {
  }

  /// \throws std::system_error if no thread can be started; then nothing is done.
  void run(const ParallelFor& parallelFor, const ProgressCallback& progress)
  {
    std::future<void> done = std::async(std::launch::async,
      [&]() { parallelFor(this->count_, [this](std::size_t number) { this->runOne(number); }); });
    constexpr std::chrono::milliseconds betweenReports(20);
    while (done.wait_for(betweenReports) != std::future_status::ready)
    {
      const double all = Units * static_cast<double>(this->count_);
      const double fraction = std::min(1.0, static_cast<double>(this->done_.load()) / all);
      this->orStop([&]() { reportProgress(progress, fraction); }); // tasks still use this object
    }
    done.get();
    if (this->thrown_)
    {
      std::rethrow_exception(this->thrown_);
    }
  }

private:
  static constexpr double Units = 1e6; // of one task

  void runOne(std::size_t number)
  {
    std::uint64_t reported = 0;
    const auto reach = [&](double fraction)
    {
      const auto units = static_cast<std::uint64_t>(Units * std::clamp(fraction, 0.0, 1.0));
      this->done_ += units > reported ? units - reported : 0;
      reported = std::max(reported, units);
      return !this->stops_.load(std::memory_order_relaxed);
    };
    if (reach(0.0))
    {
      this->orStop(
        [&]()
        {
          this->task_(number, reach);
          reach(1.0);
        });
    }
  }

  // Keeps the first exception; it stops the tasks, which may cause others.
  template <typename Action>
  void orStop(const Action& action)
  {
    try
    {
      action();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->guard_);
      this->thrown_ = this->thrown_ ? this->thrown_ : std::current_exception();
      this->stops_.store(true);
    }
  }

  std::size_t count_;
  const WatchedTask& task_;
  std::atomic<std::uint64_t> done_{ 0 };
  std::atomic<bool> stops_{ false };
  std::mutex guard_;
  std::exception_ptr thrown_;
};

} // anonymous namespace

void runWatched(std::size_t count, const WatchedTask& task, const ParallelFor& parallelFor,
  const ProgressCallback& progress)
{
  if (parallelFor && count > 1)
  {
    try
    {
      TasksAside(count, task).run(parallelFor, progress);
      return;
    }
    catch (const std::system_error&)
    {
      // no thread could be started
    }
  }
  const auto all = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto before = static_cast<double>(i);
    task(i, [&](double fraction) { return !progress || progress((before + fraction) / all); });
  }
}

}
