// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/PolyDataBlocks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include <cmath>
#include <string>

namespace geodesic
{

namespace
{

/// As messages call it.
std::string nameOfArray(const PolyDataBlock& block, const std::string& name)
{
  return "The cell array " + name + " (BarrierArrayName) of " + block.name;
}

/// \throws InputError
void requireNumbers(const PolyDataBlock& block)
{
  vtkDataArray* values = block.barriers;
  const std::string begin = nameOfArray(block, values->GetName());
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

void findBarrierArrays(std::vector<PolyDataBlock>& blocks, const char* array, Exchange& exchange)
{
  if (!array || !*array || std::string(array) == "None")
  {
    return;
  }
  bool isMissing = false;
  bool isFound = false;
  for (PolyDataBlock& block : blocks)
  {
    vtkAbstractArray* any = block.data->GetCellData()->GetAbstractArray(array);
    block.barriers = vtkDataArray::SafeDownCast(any);
    if (block.barriers)
    {
      requireNumbers(block);
      isFound = true;
    }
    else if (any)
    {
      throw InputError(nameOfArray(block, array) + " is a " + any->GetClassName() +
        ", where numbers are needed. Choose a numeric array.");
    }
    isMissing = isMissing || (!any && block.data->GetNumberOfCells() > 0);
  }
  isFound = exchange.isTrueAnywhere(isFound);
  isMissing = exchange.isTrueAnywhere(isMissing);
  if (isMissing && !isFound)
  {
    throw InputError(std::string("The surface (input port 0) has no cell array named ") + array +
      ", by which BarrierArrayName has barriers. Choose one of its cell arrays, or none.");
  }
}

}
