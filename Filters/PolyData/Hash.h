// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Hash_h
#define geodesic_Hash_h

#include "Types.h"

#include <cstring>

namespace geodesic
{

/// A hash of some words of 64 bits.
template <typename Word>
std::uint64_t hashOf(const Word* words, std::size_t count)
{
  static_assert(sizeof(Word) == sizeof(std::uint64_t));
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::uint64_t word;
    std::memcpy(&word, words + i, sizeof(word));
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash;
}

inline std::uint64_t hashOf(std::int64_t number)
{
  return hashOf(&number, 1);
}

inline std::uint64_t hashOf(const std::array<std::int64_t, 4>& numbers)
{
  return hashOf(numbers.data(), numbers.size());
}

inline std::uint64_t hashOf(const Vec3& place)
{
  const Vec3 normalized = place + Vec3{}; // -0 and 0 are one place
  return hashOf(normalized.data(), normalized.size());
}

/// For tables by such keys.
struct Hash
{
  template <typename Key>
  std::size_t operator()(const Key& key) const
  {
    return static_cast<std::size_t>(hashOf(key));
  }
};

}

#endif
