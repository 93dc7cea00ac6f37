// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CellTriangles_h
#define geodesic_CellTriangles_h

#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/Triangulator.h"

#include <cstddef>
#include <vector>

namespace geodesic
{

/// Calls visit(first, last) for each cell that has triangles, in their order: with its first
/// triangle and the one after its last.
template <typename Visit>
void forEachCell(
  const std::vector<SurfaceBlock>& blocks, const TriangleList& triangles, Visit&& visit)
{
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    const std::size_t end =
      block + 1 < blocks.size() ? blocks[block + 1].firstTriangle : triangles.corners.size();
    for (std::size_t first = blocks[block].firstTriangle; first < end;)
    {
      std::size_t last = first + 1;
      while (last < end && triangles.cells[last] == triangles.cells[first])
      {
        ++last;
      }
      visit(first, last);
      first = last;
    }
  }
}

}

#endif
