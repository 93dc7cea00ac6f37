// SPDX-License-Identifier: BSD-3-Clause
#include "OnThreads.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace geodesictest
{

namespace
{

using Work = std::function<void(std::size_t)>;

/// A thread that stays for the next work: beside other processes a new thread may wait for long.
class Helper
{
public:
  Helper()
    : thread_([this] { this->run(); })
  {
  }

  ~Helper()
  {
    this->become(State::Ended);
    this->thread_.join();
  }

  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;

  void start(const Work& work, std::size_t index)
  {
    this->work_ = &work;
    this->index_ = index;
    this->become(State::Working);
  }

  void waitUntilDone() { this->waitWhile(State::Working); }

private:
  enum class State
  {
    Waiting,
    Working,
    Ended
  };

  void run()
  {
    while (this->waitWhile(State::Waiting) == State::Working)
    {
      (*this->work_)(this->index_);
      this->become(State::Waiting);
    }
  }

  void become(State state)
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    this->state_ = state;
    this->changed_.notify_all();
  }

  State waitWhile(State state)
  {
    std::unique_lock<std::mutex> lock(this->mutex_);
    this->changed_.wait(lock, [&] { return this->state_ != state; });
    return this->state_;
  }

  const Work* work_ = nullptr;
  std::size_t index_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  State state_ = State::Waiting;
  std::thread thread_;
};

/// The helpers that have nothing to do, of all threads: on Windows a thread that ends may wait for
/// no other.
class IdleHelpers
{
public:
  std::unique_ptr<Helper> take()
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    if (this->idle_.empty())
    {
      return std::make_unique<Helper>();
    }
    std::unique_ptr<Helper> helper = std::move(this->idle_.back());
    this->idle_.pop_back();
    return helper;
  }

  void giveBack(std::unique_ptr<Helper> helper)
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    this->idle_.push_back(std::move(helper));
  }

private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Helper>> idle_;
};

}

// The work may itself call this function: it finds only those that are idle.
void together(std::size_t count, const Work& work)
{
  static IdleHelpers idle;
  std::vector<std::unique_ptr<Helper>> helpers;
  for (std::size_t i = 1; i < count; ++i)
  {
    helpers.push_back(idle.take());
    helpers.back()->start(work, i);
  }
  work(0);
  for (std::unique_ptr<Helper>& helper : helpers)
  {
    helper->waitUntilDone();
    idle.giveBack(std::move(helper));
  }
}

void onSomeThreads(
  std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& task)
{
  std::atomic<std::size_t> next{ 0 };
  together(threads,
    [&](std::size_t)
    {
      for (std::size_t i = next++; i < count; i = next++)
      {
        task(i);
      }
    });
}

}
