// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeter.h"

#include <fstream>

#ifdef __GLIBC__
#include <malloc.h>
#endif

std::uint64_t memory(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, key.size() + 1, key + ":") == 0)
    {
      return std::stoull(line.substr(key.size() + 1)) * 1024;
    }
  }
  return 0;
}

void forgetPeakMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5;
}
