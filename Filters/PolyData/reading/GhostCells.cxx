// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/GhostCells.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace geodesic
{

GhostCells::GhostCells(vtkPolyData* data)
{
  auto* flags = vtkUnsignedCharArray::SafeDownCast(
    data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!flags || flags->GetNumberOfComponents() != 1 ||
    flags->GetNumberOfTuples() < data->GetNumberOfCells())
  {
    return;
  }
  constexpr int marks = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells() && !this->flags_; ++cell)
  {
    this->flags_ = (flags->GetValue(cell) & marks) != 0 ? flags : nullptr;
  }
}

bool GhostCells::isDuplicate(vtkIdType cell) const
{
  return this->flags_ && (this->flags_->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

bool GhostCells::isHidden(vtkIdType cell) const
{
  return this->flags_ && (this->flags_->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0;
}

vtkIdType GhostCells::countOwn(vtkIdType first, vtkIdType last) const
{
  vtkIdType count = 0;
  for (vtkIdType cell = first; cell < last; ++cell)
  {
    count += this->isDuplicate(cell) || this->isHidden(cell) ? 0 : 1;
  }
  return count;
}

}
