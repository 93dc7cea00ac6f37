// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GatheredBlocks_h
#define geodesic_GatheredBlocks_h

#include "Exchange.h"
#include "PolyData/PolyDataBlocks.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// The blocks of an input of all ranks, on every rank: points, cells and ids, without other data.
/// They stand in the order of ranks, then of each rank's blocks. If all ranks have the same blocks,
/// these count once.
struct GatheredBlocks
{
  std::vector<PolyDataBlock> blocks;
  std::vector<std::size_t> firstPointOfRank = { 0 };

  /// The rank that has a point, by its number over all blocks; 0 where all have the same.
  int rankOfPoint(std::size_t number) const
  {
    const auto& first = this->firstPointOfRank;
    return static_cast<int>(std::upper_bound(first.begin(), first.end(), number) - first.begin()) -
      1;
  }
};

/// All ranks call this together.
///
/// \param own of this rank.
/// \param name as messages call the input.
GatheredBlocks gatherBlocks(
  const std::vector<PolyDataBlock>& own, const PartName& name, Exchange& exchange);

}

#endif
