// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Hash_h
#define geodesic_Hash_h

#include "Types.h"

#include <cstring>

namespace geodesic
{

/// Mixes a word by a function that is one-to-one.
inline std::uint64_t mixed(std::uint64_t word, std::uint64_t odd = 0x9e3779b97f4a7c15ULL)
{
  word *= odd;
  return word ^ (word >> 32);
}

/// A hash of some words, in two halves of 64 bits. Each word is mixed into each half by a function
/// that is one-to-one in the word and in the half, so that a change of a single word always changes
/// the result; other changes go unnoticed once in about 2^128. The hash is no protection against
/// somebody who looks for two inputs with one result.
using Fingerprint = std::array<std::uint64_t, 2>;

inline void addWord(std::uint64_t word, Fingerprint& print)
{
  print[0] = mixed(print[0] ^ word);
  print[1] = mixed(print[1] + word, 0xd6e8feb86659fd93ULL);
}

/// A hash of one or several words of 64 bits.
template <typename Words>
std::uint64_t hashOf(const Words& words)
{
  std::array<std::uint64_t, sizeof(Words) / sizeof(std::uint64_t)> all;
  static_assert(sizeof(all) == sizeof(words));
  std::memcpy(&all, &words, sizeof(all));
  std::uint64_t hash = 0;
  for (const std::uint64_t word : all)
  {
    hash = mixed(hash ^ word);
  }
  return hash;
}

inline std::uint64_t hashOf(const Vec3& place)
{
  return hashOf<Vec3>(place + Vec3{}); // -0 and 0 are one place
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
