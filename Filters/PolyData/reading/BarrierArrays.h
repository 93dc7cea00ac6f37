// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BarrierArrays_h
#define geodesic_BarrierArrays_h

#include "Exchange.h"
#include "PolyData/PolyDataBlocks.h"

#include <vector>

namespace geodesic
{

/// Finds PolyDataBlock::barriers of the blocks of a surface. Blocks without the array have no
/// barriers.
///
/// \param name of the array; null, empty and "None" (the first entry of ParaView's list) stand for
///        no barriers.
/// \param exchange with other ranks, all of which find the arrays of their blocks now.
/// \throws InputError where no block with cells, of any rank, has the array, or where it is not
///         numeric, has several components, no value for some cell, or NaN.
void findBarrierArrays(std::vector<PolyDataBlock>& blocks, const char* name, Exchange& exchange);

}

#endif
