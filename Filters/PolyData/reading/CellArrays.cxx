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

/// \param offsetAt the offset of a number.
/// \param cells how many there are, one less than offsets.
/// \returns the first cell whose offsets do not enclose some of the ids; the number of cells where
///          there is none.
template <typename OffsetAt>
vtkIdType firstUnreadable(const OffsetAt& offsetAt, vtkIdType cells, vtkIdType numberOfIds)
{
  vtkIdType begin = static_cast<vtkIdType>(offsetAt(0));
  if (begin < 0)
  {
    return 0;
  }
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const vtkIdType end = static_cast<vtkIdType>(offsetAt(cell + 1));
    if (end < begin || end > numberOfIds)
    {
      return cell;
    }
    begin = end;
  }
  return cells;
}

template <typename Offset>
vtkIdType firstUnreadable(vtkDataArray* offsets, vtkIdType cells, vtkIdType numberOfIds)
{
  const auto* values = static_cast<const Offset*>(offsets->GetVoidPointer(0));
  return firstUnreadable([values](vtkIdType i) { return values[i]; }, cells, numberOfIds);
}

/// Reads the offsets where they lie, which for large meshes is much faster than one at a time.
vtkIdType firstUnreadableOf(vtkDataArray* offsets, vtkIdType cells, vtkIdType numberOfIds)
{
  if (offsets->HasStandardMemoryLayout() && offsets->GetDataTypeSize() == 8)
  {
    return firstUnreadable<vtkTypeInt64>(offsets, cells, numberOfIds);
  }
  if (offsets->HasStandardMemoryLayout() && offsets->GetDataTypeSize() == 4)
  {
    return firstUnreadable<vtkTypeInt32>(offsets, cells, numberOfIds);
  }
  return firstUnreadable(
    [offsets](vtkIdType i) { return offsets->GetComponent(i, 0); }, cells, numberOfIds);
}

}

void requireReadable(
  vtkCellArray* cells, const std::string& kind, vtkIdType firstCell, const std::string& name)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  const vtkIdType count = offsets->GetNumberOfValues() - 1;
  const vtkIdType numberOfIds = cells->GetConnectivityArray()->GetNumberOfValues();
  if (count < 0)
  {
    throw InputError(capitalized(name) + " has " + kind +
      " with an offsets array that is empty, so that cell " + std::to_string(firstCell) +
      " cannot be read: it needs one value more than there are cells" + Advice);
  }
  const vtkIdType bad = firstUnreadableOf(offsets, count, numberOfIds);
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
