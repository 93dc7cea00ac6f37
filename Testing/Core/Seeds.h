// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_Seeds_h
#define geodesictest_Seeds_h

#include <cstdint>
#include <cstdlib>

namespace geodesictest
{

/// The seeds of a random test.
struct Seeds
{
  std::uint64_t first = 0;
  std::uint64_t count = 0;

  std::uint64_t end() const { return this->first + this->count; }
};

/// Seeds from 0 to count - 1, or others by an environment variable:
/// GEODESIC_TEST_SEEDS=FIRST,COUNT.
inline Seeds seedsOfTest(std::uint64_t count)
{
  Seeds result{ 0, count };
  if (const char* wanted = std::getenv("GEODESIC_TEST_SEEDS"))
  {
    char* rest = nullptr;
    result.first = std::strtoull(wanted, &rest, 10);
    result.count = *rest == ',' ? std::strtoull(rest + 1, nullptr, 10) : count;
  }
  return result;
}

}

#endif
