// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadTeam.h"

#include <system_error>
#include <utility>

namespace geodesic
{

ThreadTeam::ThreadTeam(std::size_t threads)
  : ranges_(std::max<std::size_t>(threads, 1))
{
}

ThreadTeam::~ThreadTeam()
{
  {
    const std::lock_guard<std::mutex> lock(this->guard_);
    this->stops_.store(true);
  }
  this->wake_.notify_all();
  for (std::thread& helper : this->helpers_)
  {
    helper.join();
  }
}

void ThreadTeam::run(std::size_t count, const std::function<void(std::size_t)>& task)
{
  if (this->loops_.load(std::memory_order_relaxed) == 0)
  {
    this->start();
  }
  this->task_.store(&task, std::memory_order_relaxed);
  this->first_.store(this->end_, std::memory_order_relaxed);
  this->done_.store(0, std::memory_order_relaxed);
  for (std::size_t i = 0; i < this->ranges_.size(); ++i)
  {
    // In this order: whoever sees the new end sees all that was stored before it, and no task is
    // left before the old one.
    Range& range = this->ranges_[i];
    range.next.store(this->end_ + i * count / this->ranges_.size(), std::memory_order_relaxed);
    range.end.store(this->end_ + (i + 1) * count / this->ranges_.size(), std::memory_order_release);
  }
  this->end_ += count;
  // Either this thread sees that one sleeps, or that one sees the loop before it sleeps: see
  // sleepUntilNext().
  this->loops_.fetch_add(1);
  if (this->sleepers_.load() > 0)
  {
    const std::lock_guard<std::mutex> lock(this->guard_);
    this->wake_.notify_all();
  }
  while (this->takeOne(0))
  {
  }
  while (this->done_.load(std::memory_order_acquire) < count)
  {
    std::this_thread::yield();
  }
  if (this->thrown_)
  {
    std::rethrow_exception(std::exchange(this->thrown_, nullptr));
  }
}

void ThreadTeam::start()
{
  try
  {
    for (std::size_t member = 1; member < this->ranges_.size(); ++member)
    {
      this->helpers_.emplace_back([this, member]() { this->help(member); });
    }
  }
  catch (const std::system_error&)
  {
    // no more threads to be had: those that there are do everything
  }
}

void ThreadTeam::help(std::size_t member)
{
  constexpr int patience = 2000;
  int idle = 0;
  while (!this->stops_.load(std::memory_order_relaxed))
  {
    const std::uint64_t loops = this->loops_.load();
    if (this->takeOne(member))
    {
      idle = 0;
    }
    else if (++idle < patience)
    {
      std::this_thread::yield();
    }
    else
    {
      this->sleepUntilNext(loops);
      idle = 0;
    }
  }
}

void ThreadTeam::sleepUntilNext(std::uint64_t loops)
{
  std::unique_lock<std::mutex> lock(this->guard_);
  this->sleepers_.fetch_add(1);
  this->wake_.wait(lock, [&]() { return this->stops_.load() || this->loops_.load() != loops; });
  this->sleepers_.fetch_sub(1);
}

bool ThreadTeam::takeOne(std::size_t member)
{
  const std::size_t ranges = this->ranges_.size();
  for (std::size_t i = 0; i < ranges; ++i)
  {
    if (this->takeOneOf(this->ranges_[(member + i) % ranges]))
    {
      return true;
    }
  }
  return false;
}

bool ThreadTeam::takeOneOf(Range& range)
{
  const std::uint64_t end = range.end.load(std::memory_order_acquire);
  std::uint64_t next = range.next.load(std::memory_order_relaxed);
  do
  {
    if (next >= end)
    {
      return false;
    }
  } while (!range.next.compare_exchange_weak(next, next + 1, std::memory_order_acq_rel));
  try
  {
    (*this->task_.load(std::memory_order_relaxed))(
      next - this->first_.load(std::memory_order_relaxed));
  }
  catch (...) // it must not leave the thread
  {
    const std::lock_guard<std::mutex> lock(this->guard_);
    this->thrown_ = std::current_exception();
  }
  this->done_.fetch_add(1, std::memory_order_release);
  return true;
}

ParallelFor teamOf(std::size_t threads)
{
  if (threads < 2)
  {
    return {};
  }
  const auto team = std::make_shared<ThreadTeam>(threads);
  return [team](std::size_t count, const std::function<void(std::size_t)>& task)
  { team->run(count, task); };
}

}
