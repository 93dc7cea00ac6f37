// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GatheredBlocks_h
#define geodesic_GatheredBlocks_h

#include "Exchange.h"
#include "PolyData/PolyDataBlocks.h"

#include <string>
#include <vector>

namespace geodesic
{

/// The blocks of an input of all ranks, on every rank: points and cells, without other data. They
/// stand in the order of ranks, then of each rank's blocks. If all ranks have the same blocks,
/// these count once.
class GatheredBlocks
{
public:
  GatheredBlocks() = default;

  /// All ranks call this together.
  ///
  /// \param own of this rank.
  /// \param name as messages call the input.
  GatheredBlocks(
    const std::vector<PolyDataBlock>& own, const std::string& name, Exchange& exchange);

  const std::vector<PolyDataBlock>& blocks() const { return this->blocks_; }
  /// From which of the blocks on they are those of a rank; one more than there are ranks. Copies on
  /// all ranks are of rank 0.
  const std::vector<std::size_t>& firstOfRank() const { return this->firstOfRank_; }

private:
  void unpack(const Message& message, const std::string& suffix);

  std::vector<PolyDataBlock> blocks_;
  std::vector<std::size_t> firstOfRank_;
};

}

#endif
