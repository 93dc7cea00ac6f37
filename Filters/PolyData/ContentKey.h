// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ContentKey_h
#define geodesic_ContentKey_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/reading/BarrierArrays.h"

#include <array>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// A fingerprint of all that the structure of a surface depends on: the coordinates, the cells, and
/// the arrays of ghost flags, global ids and barriers of each block. Two surfaces with one key are
/// taken to be the same.
///
/// Values are read, not times of modification: values changed in place, followed by Modified() on
/// the data set, change no time of its points or cells. Reading takes a few percent of what
/// building the structure takes.
///
/// The key has two halves of 64 bits. In each, a word is mixed in by a function that is one-to-one
/// in the word and in what came before, so that a change of one word always changes the key; other
/// changes go unnoticed once in about 2^128. That is no protection against somebody who looks for
/// two surfaces with one key.
struct ContentKey
{
  std::array<std::uint64_t, 2> halves{};

  bool operator==(const ContentKey& other) const { return this->halves == other.halves; }
};

ContentKey contentKey(const std::vector<PolyDataBlock>& blocks, const BarrierArrays& barriers = {});

}

#endif
