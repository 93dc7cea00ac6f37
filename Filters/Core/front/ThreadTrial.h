// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThreadTrial_h
#define geodesic_ThreadTrial_h

#include "Job.h"

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace geodesic
{

/// Whether several threads pay, that is, whether the front is to be split into districts. A narrow
/// front, with little work in a batch, is not split: to wake other threads would take as long as
/// the work. A wide one is split if that makes it clearly faster. A trial of a millisecond tells,
/// and is repeated from time to time: other processes may take the processors, and the front
/// changes.
///
/// What it says decides how long a solve takes, and nothing else.
class ThreadTrial
{
public:
  using Clock = std::chrono::steady_clock;

  explicit ThreadTrial(Job::Sharing sharing)
    : sharing_(sharing)
  {
  }

  /// To be asked after each batch.
  ///
  /// \param work of the batch (FrontWorker::work).
  /// \param now () -> the time; it is asked for a wide front only.
  template <typename Now>
  bool isSplit(std::uint64_t work, const Now& now)
  {
    if (this->sharing_ == Job::Sharing::Always)
    {
      return true;
    }
    constexpr double weight = 0.125; // a mean over some eight batches
    this->meanWork_ += weight * (static_cast<double>(work) - this->meanWork_);
    if (this->meanWork_ < (this->isWide_ ? LeastWork / 2.0 : LeastWork))
    {
      this->isWide_ = false;
      return false;
    }
    this->measure(static_cast<double>(work), now());
    return this->isSplit_;
  }

private:
  /// The work of a batch below which two threads gained nothing: half of it takes about as long as
  /// to wake threads for a batch's two steps.
  static constexpr double LeastWork = 1000.0;
  /// Less gain is not told from chance. On two threads a wide front is 1.4 to 1.8 times as fast.
  static constexpr double LeastGain = 1.15;
  /// The speed is measured over so long, after the time that a change takes.
  static constexpr std::chrono::microseconds Stretch{ 1000 };
  static constexpr std::chrono::microseconds Change{ 500 };
  /// The time between trials; it doubles while they change nothing. A front is wide for the least
  /// of it before it is tried: a trial costs some .4 milliseconds if threads do not pay, which is a
  /// twentieth of a short solve.
  static constexpr std::chrono::milliseconds LeastPause{ 10 };
  static constexpr std::chrono::milliseconds MostPause{ 640 };

  void measure(double work, Clock::time_point now)
  {
    if (!this->isWide_)
    {
      this->isWide_ = true;
      this->breakOffTrial(now);
      this->nextTrial_ = std::max(this->nextTrial_, now + LeastPause);
      this->beginStretch(now);
    }
    if (now < this->begin_)
    {
      return;
    }
    this->work_ += work;
    const std::chrono::duration<double> time = now - this->begin_;
    if (time >= Stretch)
    {
      this->endStretch(this->work_ / time.count(), now);
    }
  }

  void beginStretch(Clock::time_point begin)
  {
    this->begin_ = begin;
    this->work_ = 0.0;
  }

  // A front that was narrow for a while goes on as it was before. If each wide stretch began with a
  // trial, one that is wide and narrow in turn would be on trial most of the time.
  void breakOffTrial(Clock::time_point now)
  {
    if (this->isTrial_)
    {
      this->isSplit_ = !this->isSplit_;
      this->isTrial_ = false;
      this->nextTrial_ = now + this->pause_;
    }
  }

  // Compares a trial with the stretch before it, or begins one.
  void endStretch(double speed, Clock::time_point now)
  {
    this->beginStretch(now);
    if (this->isTrial_)
    {
      const double split = this->isSplit_ ? speed : this->speedBefore_;
      const double joined = this->isSplit_ ? this->speedBefore_ : speed;
      const bool wasSplit = !this->isSplit_;
      this->isSplit_ = split > LeastGain * joined;
      this->pause_ =
        this->isSplit_ == wasSplit ? std::min(2 * this->pause_, MostPause) : LeastPause;
      this->nextTrial_ = now + this->pause_;
      this->isTrial_ = false;
    }
    else if (now >= this->nextTrial_)
    {
      this->speedBefore_ = speed;
      this->isSplit_ = !this->isSplit_;
      this->isTrial_ = true;
      this->beginStretch(now + Change);
    }
  }

  Job::Sharing sharing_;
  double meanWork_ = 0.0;
  bool isWide_ = false;
  bool isSplit_ = false;

  /// The current stretch of time, which may begin later, and the work done in it.
  Clock::time_point begin_;
  double work_ = 0.0;

  /// Whether the current stretch is a trial, the speed before it, and when the next one begins.
  bool isTrial_ = false;
  double speedBefore_ = 0.0;
  Clock::time_point nextTrial_;
  std::chrono::milliseconds pause_ = LeastPause;
};

}

#endif
