// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_InputArrays_h
#define geodesic_InputArrays_h

#include "Exchange.h"
#include "PolyData/PolyDataBlocks.h"

#include <vector>

class vtkDataSet;

namespace geodesic
{

/// Whether the name of an array stands for one: null, empty and "None" (the first entry of
/// ParaView's list) do not.
bool isChosen(const char* array);

/// Whether the points of a data set have the ids of the arrays where the block's parts have not.
bool haveOnlyPointsIds(vtkDataSet* data, const PolyDataBlock& block, const PartArrays& arrays);

/// Reads PolyDataBlock::sourceIds, partNames and pointNames from a data set.
///
/// \throws InputError as sourceBlocks().
void readPartArrays(vtkDataSet* data, const PartArrays& arrays, PolyDataBlock& block);

/// Finds PolyDataBlock::barriers of the blocks of a surface. Blocks without the array have no
/// barriers. An array with one value a face, which leaves out vertices and lines, is replaced by
/// one with a value for each cell.
///
/// \param array its name; there are no barriers unless it isChosen().
/// \param exchange with other ranks, all of which find the arrays of their blocks now.
/// \throws InputError where no block with cells, of any rank, has the array, or where it is not
///         numeric, has several components, neither a value for each cell nor one for each face, or
///         NaN.
void findBarrierArrays(std::vector<PolyDataBlock>& blocks, const char* array, Exchange& exchange);

}

#endif
