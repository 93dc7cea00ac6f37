// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CellLoop_h
#define geodesic_CellLoop_h

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkSmartPointer.h"

namespace geodesic
{

/// Calls visit(vtkIdType size, const vtkIdType* ids) for each cell.
template <typename Visit>
void forEachCell(vtkCellArray* cells, Visit&& visit)
{
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    visit(size, ids);
  }
}

}

#endif
