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

/// A hash of 128 bits of some words. It has two halves of 64 bits. In each, a word is mixed in by a
/// function that is one-to-one in the word and in what came before, so that a change of one word
/// always changes the result; other changes go unnoticed once in about 2^128. That is no protection
/// against somebody who looks for two inputs with one result.
using Fingerprint = std::array<std::uint64_t, 2>;

inline void addWord(std::uint64_t word, Fingerprint& print)
{
  print[0] = mixed(print[0] ^ word);
  print[1] = mixed(print[1] + word, 0xd6e8feb86659fd93ULL);
}

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
    hash = mixed(hash ^ word);
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
