// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/CellArrays.h"

#include "PolyData/PolyDataBlocks.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <utility>

namespace geodesic
{

namespace
{

const char* const Advice = ". Repair the cells upstream.";

/// \returns the first cell whose offsets do not enclose some of the ids; the number of cells where
///          there is none.
vtkIdType firstUnreadable(vtkDataArray* offsets, vtkIdType cells, vtkIdType numberOfIds)
{
  const auto offsetAt = [offsets](vtkIdType i)
  { return static_cast<vtkIdType>(offsets->GetComponent(i, 0)); };
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const vtkIdType begin = offsetAt(cell);
    const vtkIdType end = offsetAt(cell + 1);
    if (begin < 0 || end < begin || end > numberOfIds)
    {
      return cell;
    }
  }
  return cells;
}

}

void requireReadable(
  vtkCellArray* cells, const std::string& kind, vtkIdType firstCell, const std::string& name)
{
  if (cells->IsValid()) // the rule, which is quick
  {
    return;
  }
  vtkDataArray* offsets = cells->GetOffsetsArray();
  const vtkIdType count = offsets->GetNumberOfValues() - 1;
  const vtkIdType numberOfIds = cells->GetConnectivityArray()->GetNumberOfValues();
  if (count < 0)
  {
    throw InputError(capitalized(name) + " has " + kind +
      " with an offsets array that is empty, so that cell " + std::to_string(firstCell) +
      " cannot be read: it needs one value more than there are cells" + Advice);
  }
  const vtkIdType bad = firstUnreadable(offsets, count, numberOfIds);
  if (bad == count)
  {
    return;
  }
  const auto offset = [offsets](vtkIdType i)
  { return std::to_string(static_cast<vtkIdType>(offsets->GetComponent(i, 0))); };
  throw InputError("Cell " + std::to_string(firstCell + bad) + " of " + name +
    " cannot be read: the offsets of the " + kind + " (number " + std::to_string(bad) +
    " of these) say that its point ids go from " + offset(bad) + " to " + offset(bad + 1) +
    ", where offsets never decrease and lie between 0 and " + std::to_string(numberOfIds) +
    ", the number of ids" + Advice);
}

void requireReadable(vtkPolyData* data, const std::string& name)
{
  // vtkPolyData numbers its cells in this order.
  const std::pair<vtkCellArray*, const char*> kinds[] = { { data->GetVerts(), "vertices" },
    { data->GetLines(), "lines" }, { data->GetPolys(), "polygons" },
    { data->GetStrips(), "strips" } };
  vtkIdType first = 0;
  for (const auto& [cells, kind] : kinds)
  {
    requireReadable(cells, kind, first, name);
    first += cells->GetNumberOfCells();
  }
}

}
