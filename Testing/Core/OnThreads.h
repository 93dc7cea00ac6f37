// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_OnThreads_h
#define geodesictest_OnThreads_h

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>

namespace geodesictest
{

/// Runs the tasks on three threads, each of which takes the next one that is left.
inline void onThreads(std::size_t count, const std::function<void(std::size_t)>& task)
{
  std::atomic<std::size_t> next{ 0 };
  const auto work = [&]()
  {
    for (std::size_t i = next++; i < count; i = next++)
    {
      task(i);
    }
  };
  std::thread first(work);
  std::thread second(work);
  work();
  first.join();
  second.join();
}

}

#endif
