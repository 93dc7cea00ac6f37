// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GatheredBlocks_h
#define geodesic_GatheredBlocks_h

#include "Exchange.h"
#include "PolyData/PolyDataBlocks.h"

#include <algorithm>
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
  /// The rank that has a point, by its number over all blocks; 0 where all have the same.
  int rankOfPoint(std::size_t number) const
  {
    const auto& first = this->firstPointOfRank_;
    return static_cast<int>(std::upper_bound(first.begin(), first.end(), number) - first.begin()) -
      1;
  }

private:
  void unpack(const Message& message, const std::string& suffix);

  std::vector<PolyDataBlock> blocks_;
  std::vector<std::size_t> firstPointOfRank_ = { 0 };
  std::size_t numberOfPoints_ = 0;
};

}

#endif
