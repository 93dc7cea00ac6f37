// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryRanks.h"

#include "OnThreads.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <utility>

namespace geodesictest
{

using geodesic::Message;

namespace
{

/// A rank's contribution to a step.
struct Brought
{
  std::vector<Message> messages;
  std::vector<double> numbers;
  bool hasFailed = false;
  std::string why;
  /// Processor seconds since the rank's last step.
  double work = 0.0;
};

/// Processor seconds of this thread.
double threadSeconds()
{
  timespec time = {}; // of POSIX
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What a rank receives in a step.
struct Taken
{
  std::vector<Message> messages;
  std::vector<double> least;
  bool hasFailed = false;
  std::string why;
};

}

/// The shared memory of the ranks.
class MemoryRanks::Hub
{
public:
  Hub(int numberOfRanks, std::uint64_t seed)
    : disorder(seed)
    , brought_(static_cast<std::size_t>(numberOfRanks))
    , taken_(brought_.size())
  {
  }

  std::size_t size() const { return this->brought_.size(); }

  Taken step(std::size_t rank, Brought brought)
  {
    std::unique_lock<std::mutex> lock(this->mutex_);
    this->brought_[rank] = std::move(brought);
    if (++this->here_ == this->size())
    {
      this->deliver();
      this->here_ = 0;
      ++this->generation_;
      this->all_.notify_all();
    }
    else
    {
      const std::uint64_t generation = this->generation_;
      this->all_.wait(lock, [&] { return this->generation_ != generation; });
    }
    return std::move(this->taken_[rank]);
  }

  const std::uint64_t disorder;
  ExchangeCounts counts;

private:
  void deliver()
  {
    Taken common;
    common.least = this->brought_.front().numbers;
    for (const Brought& brought : this->brought_)
    {
      if (brought.hasFailed && !common.hasFailed)
      {
        common.hasFailed = true;
        common.why = brought.why;
      }
      for (std::size_t i = 0; i < std::min(common.least.size(), brought.numbers.size()); ++i)
      {
        common.least[i] = std::min(common.least[i], brought.numbers[i]);
      }
    }
    this->count();
    for (std::size_t to = 0; to < this->size(); ++to)
    {
      this->taken_[to] = common;
      for (std::size_t from = 0; from < this->size() && !common.hasFailed; ++from)
      {
        this->taken_[to].messages.push_back(std::move(this->brought_[from].messages[to]));
      }
    }
  }

  void count()
  {
    std::vector<std::uint64_t> bytes(this->size(), 0);
    double busiest = 0.0;
    for (std::size_t from = 0; from < this->size(); ++from)
    {
      for (std::size_t to = 0; to < this->brought_[from].messages.size(); ++to)
      {
        const std::size_t size = from == to ? 0 : this->brought_[from].messages[to].size();
        this->counts.messages += size > 0 ? 1 : 0;
        this->counts.bytes += size;
        bytes[from] += size;
        bytes[to] += size;
      }
      this->counts.work += this->brought_[from].work;
      busiest = std::max(busiest, this->brought_[from].work);
    }
    this->counts.busiest += busiest;
    this->counts.busiestBytes += *std::max_element(bytes.begin(), bytes.end());
    ++this->counts.steps;
  }

  std::mutex mutex_;
  std::condition_variable all_;
  std::size_t here_ = 0;
  std::uint64_t generation_ = 0;
  std::vector<Brought> brought_;
  std::vector<Taken> taken_;
};

class MemoryRanks::Rank : public geodesic::Exchange
{
public:
  Rank(Hub& hub, int rank)
    : hub_(hub)
    , rank_(rank)
    , random_(hub.disorder + static_cast<std::uint64_t>(rank))
  {
  }

  using geodesic::Exchange::step;
  int rank() const override { return this->rank_; }
  int numberOfRanks() const override { return static_cast<int>(this->hub_.size()); }

  std::vector<Message> step(std::vector<Message> messages, std::vector<double>& least) override
  {
    Brought brought;
    brought.messages = std::move(messages);
    brought.numbers = least;
    Taken taken = this->meet(std::move(brought));
    if (taken.hasFailed && taken.why.empty())
    {
      throw geodesic::AbortedElsewhere();
    }
    if (taken.hasFailed)
    {
      throw geodesic::FailedElsewhere(taken.why);
    }
    least = std::move(taken.least);
    return std::move(taken.messages);
  }

  std::string fail(const std::string& why) override
  {
    Brought brought;
    brought.hasFailed = true;
    brought.why = why;
    return this->meet(std::move(brought)).why;
  }

private:
  Taken meet(Brought brought)
  {
    brought.work = threadSeconds() - this->lastStep_;
    this->dawdle();
    Taken taken = this->hub_.step(static_cast<std::size_t>(this->rank_), std::move(brought));
    this->dawdle();
    this->lastStep_ = threadSeconds();
    return taken;
  }

  void dawdle()
  {
    if (this->hub_.disorder != 0 && this->random_() % 4 == 0)
    {
      std::this_thread::sleep_for(std::chrono::microseconds(this->random_() % 50));
    }
  }

  Hub& hub_;
  int rank_;
  std::mt19937_64 random_;
  /// In processor time of this thread.
  double lastStep_ = threadSeconds();
};

MemoryRanks::MemoryRanks(int numberOfRanks, std::uint64_t disorder)
  : hub_(std::make_unique<Hub>(numberOfRanks, disorder))
{
}

MemoryRanks::~MemoryRanks() = default;

std::vector<std::exception_ptr> MemoryRanks::tryRun(
  const std::function<void(geodesic::Exchange&)>& work)
{
  std::vector<std::exception_ptr> thrown(this->hub_->size());
  const auto runRank = [&](std::size_t number)
  {
    Rank rank(*this->hub_, static_cast<int>(number));
    try
    {
      work(rank);
      rank.step(rank.noMessages()); // no rank ends before all are done
    }
    catch (const geodesic::FailedElsewhere&)
    {
      thrown[number] = std::current_exception();
    }
    catch (const geodesic::AbortedElsewhere&)
    {
      thrown[number] = std::current_exception();
    }
    catch (const std::exception& error)
    {
      thrown[number] = std::current_exception();
      const bool isAbort = dynamic_cast<const geodesic::Aborted*>(&error) != nullptr;
      rank.fail(isAbort ? "" : error.what());
    }
  };
  together(thrown.size(), runRank);
  return thrown;
}

void MemoryRanks::run(const std::function<void(geodesic::Exchange&)>& work)
{
  const std::vector<std::exception_ptr> thrown = this->tryRun(work);
  const auto isThrown = [](const std::exception_ptr& e) { return e != nullptr; };
  const auto first = std::find_if(thrown.begin(), thrown.end(), isThrown);
  if (first != thrown.end())
  {
    std::rethrow_exception(*first);
  }
}

const ExchangeCounts& MemoryRanks::counts() const
{
  return this->hub_->counts;
}

}
