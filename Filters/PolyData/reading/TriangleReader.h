// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleReader_h
#define geodesic_TriangleReader_h

#include "Job.h"
#include "PolyData/PolyDataBlocks.h"
#include "PolyData/reading/PolyDataSurface.h"

#include "vtkType.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace geodesic
{

/// The triangles of all blocks, one after another.
struct TriangleList
{
  /// Points at the corners, numbered through all blocks.
  std::vector<Triangle> corners;
  /// The cell of its block that each triangle came from.
  std::vector<vtkIdType> cells;
  /// Whether a ghost array marks that cell as a duplicate.
  std::vector<bool> isDuplicate;
  /// The first triangle of each block, then the number of all.
  std::vector<std::size_t> firstOfBlock;

  /// The triangles of a cell: the first and the one after the last.
  using Range = std::pair<std::size_t, std::size_t>;

  /// Calls visit(Range) for each cell that has triangles, in their order.
  template <typename Visit>
  void forEachCell(Visit&& visit) const
  {
    for (std::size_t block = 0; block + 1 < this->firstOfBlock.size(); ++block)
    {
      const std::size_t end = this->firstOfBlock[block + 1];
      for (std::size_t first = this->firstOfBlock[block]; first < end;)
      {
        std::size_t last = first + 1;
        while (last < end && this->cells[last] == this->cells[first])
        {
          ++last;
        }
        visit(Range(first, last));
        first = last;
      }
    }
  }
};

/// Reads the triangles of all blocks, and cuts polygons and strips into triangles. Those that have
/// two corners at one vertex are left out.
///
/// \param blocks whose points are numbered; they are given their triangles as cells: the input's
///        own cells if these are the same.
/// \param numberOfFaces of all inputs.
/// \param report to which what was dropped is added.
/// \throws MeshError if a cell names a point that does not exist.
TriangleList readTriangles(const std::vector<PolyDataBlock>& inputs, const VertexOfPoint& vertexOf,
  vtkIdType numberOfFaces, const Job& job, std::vector<SurfaceBlock>& blocks,
  SurfaceReport& report);

/// Gives blocks their triangles as cells, after duplicates have been given those of their
/// originals.
void keepTriangles(const std::vector<PolyDataBlock>& inputs, const TriangleList& triangles,
  std::vector<SurfaceBlock>& blocks);

}

#endif
