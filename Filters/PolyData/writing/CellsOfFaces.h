// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CellsOfFaces_h
#define geodesic_CellsOfFaces_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/reading/PolyDataSurface.h"

#include "vtkType.h"

#include <vector>

namespace geodesic
{

/// Finds the cells of the input that faces come from, by a number that they have in the whole
/// input: all cells of all blocks, in their order, and of the ranks that have a piece, one after
/// another. All ranks that have a piece call this together.
///
/// \param inputs the blocks that the surface was read from.
/// \param faces of any rank.
std::vector<vtkIdType> cellsOfFaces(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& inputs, const std::vector<RankAddress>& faces);

}

#endif
