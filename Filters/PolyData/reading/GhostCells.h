// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GhostCells_h
#define geodesic_GhostCells_h

#include "Types.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPolyData;
class vtkUnsignedCharArray;

namespace geodesic
{

struct SurfaceBlock;
struct TriangleList;

/// What the ghost array of a vtkPolyData says of its cells.
class GhostCells
{
public:
  explicit GhostCells(vtkPolyData* data);

  /// Whether any cell may be marked.
  bool areAny() const { return this->flags_ != nullptr; }
  /// Whether a cell is marked as a duplicate of one of another block or piece.
  bool isDuplicate(vtkIdType cell) const;
  /// Whether a cell is hidden: it is not surface.
  bool isHidden(vtkIdType cell) const;
  /// How many of the cells from first to the one before last are neither.
  vtkIdType countOwn(vtkIdType first, vtkIdType last) const;

private:
  vtkUnsignedCharArray* flags_ = nullptr;
};

/// Finds the originals of triangles that are marked as duplicates. A marked cell on the corners of
/// one that is not marked gets that one's triangles (a polygon may be cut in several ways). A
/// duplicate without an original is surface itself; of several such on the same vertices, the
/// first.
///
/// \param vertexOfPoint which vertex each point is; empty where each is its own.
/// \param blocks where the triangles of each begin.
/// \param triangles of all blocks; the corners of marked ones may change.
/// \returns whether a triangle is a copy of another; one a triangle.
std::vector<std::uint8_t> findCopies(const std::vector<Id>& vertexOfPoint,
  const std::vector<SurfaceBlock>& blocks, TriangleList& triangles);

}

#endif
