// SPDX-License-Identifier: BSD-3-Clause
#include "Job.h"

#include "Errors.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <future>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace geodesic
{

struct Job::Caller
{
  using Clock = std::chrono::steady_clock;

  Watcher watcher;
  ParallelFor threads;
  Sharing sharing = Sharing::Always;
  double reached = 0.0;
  Clock::time_point nextLook = Clock::time_point::min();
  /// The thread that last shared tasks with others. None if there are no others.
  std::thread::id thread;
  std::atomic<bool> hasStopped{ false };

  bool isElsewhere() const
  {
    return this->thread != std::thread::id() && this->thread != std::this_thread::get_id();
  }
  /// Remembers that the work has come to a fraction of a stretch. It never goes back.
  void moveTo(double begin, double end, double fraction)
  {
    this->reached = std::max(this->reached, begin + (end - begin) * std::min(fraction, 1.0));
  }
  void tellWatcher()
  {
    if (!this->watcher(this->reached))
    {
      this->hasStopped.store(true, std::memory_order_relaxed);
      throw Aborted();
    }
  }
};

namespace
{

/// Long tasks in other threads, as the caller's thread watches them.
class TasksAside
{
public:
  TasksAside(std::size_t count, const std::function<void(std::size_t, const Job&)>& task)
    : count_(count)
    , task_(task)
  {
  }

  /// \throws std::system_error if no thread can be started; then nothing is done.
  void run(const ParallelFor& threads, const Job& job)
  {
    std::future<void> done = std::async(std::launch::async,
      [&]() { threads(this->count_, [this](std::size_t number) { this->runOne(number); }, {}); });
    constexpr std::chrono::milliseconds betweenReports(20);
    while (done.wait_for(betweenReports) != std::future_status::ready)
    {
      const double all = Units * static_cast<double>(this->count_);
      const double fraction = std::min(1.0, static_cast<double>(this->done_.load()) / all);
      this->orStop([&]() { job.reach(fraction); }); // tasks still use this object
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
          this->task_(number, Job(reach));
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
  const std::function<void(std::size_t, const Job&)>& task_;
  std::atomic<std::uint64_t> done_{ 0 };
  std::atomic<bool> stops_{ false };
  std::mutex guard_;
  std::exception_ptr thrown_;
};

}

Job::Job(Watcher watcher, ParallelFor threads, Sharing sharing)
  : caller_(std::make_shared<Caller>())
{
  this->caller_->watcher = std::move(watcher);
  this->caller_->threads = std::move(threads);
  this->caller_->sharing = sharing;
}

bool Job::isParallel() const
{
  return this->caller_ && this->caller_->threads;
}

Job::Sharing Job::sharing() const
{
  return this->caller_ ? this->caller_->sharing : Sharing::Always;
}

void Job::reach(double fraction) const
{
  if (this->caller_ && this->caller_->watcher)
  {
    this->caller_->moveTo(this->begin_, this->end_, fraction);
    this->caller_->tellWatcher();
  }
}

void Job::look(double fraction) const
{
  if (!this->caller_ || !this->caller_->watcher)
  {
    return;
  }
  Caller& caller = *this->caller_;
  if (caller.hasStopped.load(std::memory_order_relaxed))
  {
    throw Aborted();
  }
  if (caller.isElsewhere())
  {
    return;
  }
  // Looks of tasks, which do not know how far the work is, tell what was reached before.
  caller.moveTo(this->begin_, this->end_, fraction);
  constexpr std::chrono::milliseconds betweenCalls(20);
  const Caller::Clock::time_point now = Caller::Clock::now();
  if (now >= caller.nextLook)
  {
    caller.nextLook = now + betweenCalls;
    caller.tellWatcher();
  }
}

void Job::inParallel(std::size_t count, const std::function<void(std::size_t)>& task) const
{
  Caller& caller = *this->caller_;
  caller.thread = std::this_thread::get_id();
  caller.threads(count, task, [this]() { this->look(); });
}

void Job::longTasks(
  std::size_t count, const std::function<void(std::size_t number, const Job& job)>& task) const
{
  if (this->isParallel() && count > 1)
  {
    try
    {
      TasksAside(count, task).run(this->caller_->threads, *this);
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
    const Job part = this->part(before / all, (before + 1.0) / all);
    task(i, part);
  }
}

}
