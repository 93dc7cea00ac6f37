// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PacedProgress_h
#define geodesic_PacedProgress_h

#include "Progress.h"

#include <chrono>

namespace geodesic
{

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

}

#endif
