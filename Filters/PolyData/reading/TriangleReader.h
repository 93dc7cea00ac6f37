// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleReader_h
#define geodesic_TriangleReader_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/Triangulator.h"
#include "Progress.h"
#include "Tasks.h"

#include <vector>

namespace geodesic
{

/// Reads the triangles of all blocks.
///
/// \param blocks whose points are numbered; they are given their triangles as cells: the input's
///        own cells if these are the same.
/// \param numberOfFaces of all inputs, for the progress.
/// \param report to which what was dropped is added.
/// \throws MeshError if a cell names a point that does not exist.
TriangleList readTriangles(const std::vector<PolyDataBlock>& inputs, const VertexOfPoint& vertexOf,
  vtkIdType numberOfFaces, const LoopProgress& progress, const ParallelFor& parallelFor,
  std::vector<SurfaceBlock>& blocks, SurfaceReport& report);

/// Gives blocks their triangles as cells, after duplicates have been given those of their
/// originals.
void keepTriangles(const std::vector<PolyDataBlock>& inputs, const TriangleList& triangles,
  std::vector<SurfaceBlock>& blocks);

}

#endif
