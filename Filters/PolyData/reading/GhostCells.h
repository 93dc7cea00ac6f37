// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GhostCells_h
#define geodesic_GhostCells_h

#include "vtkType.h"

class vtkPolyData;
class vtkUnsignedCharArray;

namespace geodesic
{

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

}

#endif
