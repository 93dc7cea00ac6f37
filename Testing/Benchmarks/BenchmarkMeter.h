// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkMeter_h
#define BenchmarkMeter_h

#include <chrono>
#include <cstdint>
#include <string>

/// A value of /proc/self/status, in bytes; 0 where there is none.
std::uint64_t memory(const std::string& key);

/// Returns what is free to the system and lets the peak begin anew, as far as that can be done.
void forgetPeakMemory();

class Stopwatch
{
public:
  /// Seconds since the last call.
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - this->start_).count();
    this->start_ = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

#endif
