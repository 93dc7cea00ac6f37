// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadTeam.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace geodesic
{

namespace
{

/// How long a member that has no processor stays away.
constexpr std::chrono::steady_clock::duration LeastPause = std::chrono::milliseconds(20);
constexpr std::chrono::steady_clock::duration MostPause = std::chrono::milliseconds(640);

} // anonymous namespace

ThreadTeam::ThreadTeam(std::size_t threads)
  : ranges_(std::max<std::size_t>(threads, 1))
  , active_(this->ranges_.size())
  , members_(this->ranges_.size())
  , pause_(LeastPause)
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

void ThreadTeam::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& wait)
{
  if (this->loops_.load(std::memory_order_relaxed) == 0)
  {
    this->start();
  }
  this->fitToMachine();
  this->task_.store(&task, std::memory_order_relaxed);
  this->done_.store(0, std::memory_order_relaxed);
  this->share(count);
  // Either this thread sees that one sleeps, or that one sees the loop before it sleeps: see
  // sleepUntilNext().
  this->loops_.fetch_add(1);
  if (this->sleepers_.load() > this->ranges_.size() - this->members_)
  {
    const std::lock_guard<std::mutex> lock(this->guard_);
    this->wake_.notify_all();
  }
  while (this->takeOne(0))
  {
  }
  this->waitForOthers(count, wait);
  if (this->thrown_)
  {
    std::rethrow_exception(std::exchange(this->thrown_, nullptr));
  }
}

// Deals the tasks of the next loop out to the members that work.
void ThreadTeam::share(std::size_t count)
{
  this->first_.store(this->end_, std::memory_order_relaxed);
  for (std::size_t i = 0; i < this->ranges_.size(); ++i)
  {
    // In this order: whoever sees the new end sees all that was stored before it, and no task is
    // left before the old one.
    const std::size_t begin = std::min(i, this->members_) * count / this->members_;
    const std::size_t end = std::min(i + 1, this->members_) * count / this->members_;
    Range& range = this->ranges_[i];
    range.next.store(this->end_ + begin, std::memory_order_relaxed);
    range.end.store(this->end_ + end, std::memory_order_release);
  }
  this->end_ += count;
}

// If it takes long, this thread sleeps. So one that has a task and no processor gets this one's.
void ThreadTeam::waitForOthers(std::size_t count, const std::function<void()>& wait)
{
  constexpr int patience = 200;
  bool isWatched = static_cast<bool>(wait);
  for (int waited = 0; this->done_.load(std::memory_order_acquire) < count; ++waited)
  {
    if (isWatched)
    {
      try
      {
        wait();
      }
      catch (...) // others are still at their tasks
      {
        this->keepException();
        isWatched = false;
      }
    }
    if (waited < patience)
    {
      this->letOthersRun(this->lateness_);
    }
    else
    {
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
  }
}

// Members that have left come back after a pause. It is longer each time that some leave again at
// once.
void ThreadTeam::fitToMachine()
{
  const std::size_t active = this->active_.load(std::memory_order_relaxed);
  if (active == this->ranges_.size())
  {
    return;
  }
  const Clock::time_point now = Clock::now();
  if (active < this->members_)
  {
    const bool isAgain = now - this->grown_ < 2 * this->pause_;
    this->pause_ = isAgain ? std::min(2 * this->pause_, MostPause) : LeastPause;
    this->nextGrowth_ = now + this->pause_;
    this->members_ = active;
  }
  else if (now >= this->nextGrowth_)
  {
    this->grow(now);
  }
}

void ThreadTeam::grow(Clock::time_point now)
{
  this->members_ = std::min(2 * this->members_, this->ranges_.size());
  this->grown_ = now;
  this->nextGrowth_ = now + this->pause_;
  const std::lock_guard<std::mutex> lock(this->guard_);
  this->active_.store(this->members_);
  this->wake_.notify_all();
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

// Other threads that want this one's processor run before it comes back. Once may be by chance.
//
// \param lateness of the member: rises with each late return, and falls with each early one.
void ThreadTeam::letOthersRun(int& lateness)
{
  constexpr std::chrono::microseconds late(20);
  constexpr int ofOneReturn = 8;
  constexpr int most = 6 * ofOneReturn;
  const Clock::time_point begin = Clock::now();
  std::this_thread::yield();
  if (Clock::now() - begin < late)
  {
    lateness = std::max(lateness - 1, 0);
    return;
  }
  lateness += ofOneReturn;
  if (lateness >= most)
  {
    lateness = 0;
    std::size_t active = this->active_.load(std::memory_order_relaxed);
    if (active > 1)
    {
      this->active_.compare_exchange_strong(active, active - 1);
    }
  }
}

void ThreadTeam::help(std::size_t member)
{
  constexpr int patience = 2000;
  int idle = 0;
  int lateness = 0;
  while (!this->stops_.load(std::memory_order_relaxed))
  {
    const std::uint64_t loops = this->loops_.load();
    const bool isActive = member < this->active_.load(std::memory_order_relaxed);
    if (isActive && this->takeOne(member))
    {
      idle = 0;
    }
    else if (isActive && ++idle < patience)
    {
      this->letOthersRun(lateness);
    }
    else
    {
      this->sleepUntilNext(member, loops);
      idle = 0;
    }
  }
}

void ThreadTeam::sleepUntilNext(std::size_t member, std::uint64_t loops)
{
  std::unique_lock<std::mutex> lock(this->guard_);
  this->sleepers_.fetch_add(1);
  this->wake_.wait(lock,
    [&]() {
      return this->stops_.load() || (this->loops_.load() != loops && member < this->active_.load());
    });
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
    this->keepException();
  }
  this->done_.fetch_add(1, std::memory_order_release);
  return true;
}

void ThreadTeam::keepException()
{
  const std::lock_guard<std::mutex> lock(this->guard_);
  this->thrown_ = std::current_exception();
}

ParallelFor teamOf(std::size_t threads)
{
  if (threads < 2)
  {
    return {};
  }
  const auto team = std::make_shared<ThreadTeam>(threads);
  return [team](std::size_t count, const std::function<void(std::size_t)>& task,
           const std::function<void()>& wait) { team->run(count, task, wait); };
}

}
