// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/BarrierArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <cmath>

namespace geodesic
{

namespace
{

/// \throws InputError
void requireNumbers(const PolyDataBlock& block, vtkDataArray* values, const std::string& name)
{
  const std::string begin = "The cell array " + name + " (BarrierArrayName) of " + block.name;
  if (values->GetNumberOfComponents() != 1)
  {
    throw InputError(begin + " has " + std::to_string(values->GetNumberOfComponents()) +
      " components, where one number a cell is needed. Choose an array with one component, or make "
      "one, for example by the Calculator filter.");
  }
  const vtkIdType cells = block.data->GetNumberOfCells();
  if (values->GetNumberOfTuples() < cells)
  {
    throw InputError(begin + " has " + std::to_string(values->GetNumberOfTuples()) +
      " values for " + std::to_string(cells) + " cells. Give each cell a value.");
  }
  std::vector<vtkIdType> bad;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    if (std::isnan(values->GetComponent(cell, 0)))
    {
      bad.push_back(cell);
    }
  }
  if (!bad.empty())
  {
    throw InputError(begin + " is NaN at cell " + listIds(bad) +
      ", which says neither that these are barriers nor that they are none. Set it to 0 where "
      "paths may pass and to 1 where they may not.");
  }
}

}

BarrierArrays::BarrierArrays(
  const std::vector<PolyDataBlock>& blocks, const char* name, Exchange& exchange)
{
  if (!name || !*name || std::string(name) == "None")
  {
    return;
  }
  this->name_ = name;
  bool isMissing = false;
  bool isFound = false;
  for (const PolyDataBlock& block : blocks)
  {
    vtkAbstractArray* any = block.data->GetCellData()->GetAbstractArray(name);
    auto* values = vtkDataArray::SafeDownCast(any);
    if (any && !values)
    {
      throw InputError("The cell array " + this->name_ + " (BarrierArrayName) of " + block.name +
        " is a " + any->GetClassName() + ", where numbers are needed. Choose a numeric array.");
    }
    if (values)
    {
      requireNumbers(block, values, this->name_);
    }
    isFound = isFound || values;
    isMissing = isMissing || (!values && block.data->GetNumberOfCells() > 0);
    this->arrays_.push_back(values);
  }
  isFound = exchange.isTrueAnywhere(isFound);
  isMissing = exchange.isTrueAnywhere(isMissing);
  if (isMissing && !isFound)
  {
    throw InputError("The surface (input port 0) has no cell array named " + this->name_ +
      ", by which BarrierArrayName has barriers. Choose one of its cell arrays, or none.");
  }
}

bool BarrierArrays::isBarrier(std::size_t block, vtkIdType cell) const
{
  vtkDataArray* values = this->of(block);
  return values && values->GetComponent(cell, 0) != 0.0;
}

}
