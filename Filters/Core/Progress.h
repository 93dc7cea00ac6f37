// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Progress_h
#define geodesic_Progress_h

#include "Errors.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>

namespace geodesic
{

/// Called now and then with the fraction done in [0, 1]; returns false to ask for a stop.
using ProgressCallback = std::function<bool(double)>;

/// The same callback, but the fraction never decreases: for work that may have to be repeated. The
/// original callback must outlive it.
inline ProgressCallback ascending(const ProgressCallback& callback)
{
  if (!callback)
  {
    return {};
  }
  return [&callback, reported = 0.0](double fraction) mutable
  {
    reported = std::max(reported, fraction);
    return callback(reported);
  };
}

/// The same for work that takes the whole from one fraction to another. The callback must outlive
/// it.
inline ProgressCallback progressBetween(const ProgressCallback& callback, double begin, double end)
{
  return callback ? [&callback, begin, end](double fraction)
  { return callback(begin + (end - begin) * fraction); }
                  : ProgressCallback();
}

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

/// \throws Aborted where the callback asks to stop.
inline void reportProgress(const ProgressCallback& callback, double fraction)
{
  if (callback && !callback(fraction))
  {
    throw Aborted();
  }
}

/// Reports the progress of a loop, one of several that follow each other.
class LoopProgress
{
public:
  explicit LoopProgress(const ProgressCallback& callback)
    : callback_(callback)
  {
  }

  /// The next loop takes the work to this fraction of the whole.
  void nextUntil(double end)
  {
    this->begin_ = this->end_;
    this->end_ = end;
  }

  double end() const { return this->end_; }

  /// For one of several loops within this loop's stretch: from one fraction of the stretch to
  /// another.
  LoopProgress between(double from, double to) const
  {
    LoopProgress part(this->callback_);
    part.begin_ = this->begin_ + (this->end_ - this->begin_) * from;
    part.end_ = this->begin_ + (this->end_ - this->begin_) * to;
    return part;
  }

  /// Reports item `item` of a loop over `count` items.
  ///
  /// \throws Aborted
  void at(std::size_t item, std::size_t count) const
  {
    constexpr std::size_t itemsPerReport = 8192; // a power of two
    if (item % itemsPerReport == 0 && this->callback_)
    {
      const double done = static_cast<double>(item) / static_cast<double>(count);
      if (!this->callback_(this->begin_ + (this->end_ - this->begin_) * done))
      {
        throw Aborted();
      }
    }
  }

private:
  const ProgressCallback& callback_;
  double begin_ = 0.0;
  double end_ = 0.0;
};

}

#endif
