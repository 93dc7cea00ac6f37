// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/PolyDataBlocks.h"

#include "PolyData/reading/GridSurface.h"
#include "PolyData/reading/InputArrays.h"
#include "Types.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cfloat>
#include <utility>

namespace geodesic
{

namespace
{

const char* const NoSurface =
  ": apply Extract Surface to it first. A vtkPolyData, a vtkUnstructuredGrid of two-dimensional "
  "cells, or a composite data set of these, is needed; vtkDataSetSurfaceFilter and "
  "vtkGeometryFilter make one.";
const char* const NoPoints =
  ", which has no points of its own. A vtkPolyData, a vtkUnstructuredGrid, another vtkPointSet, or "
  "a composite data set of these, is needed: of an image or a grid Extract Surface makes one, of a "
  "table Table To Points.";

/// \param whatToDo where it is of another type.
/// \throws InputError
template <typename Type>
Type* requireType(vtkDataObject* data, const PartName& name, const char* whatToDo)
{
  auto* result = Type::SafeDownCast(data);
  if (!result)
  {
    throw InputError(name.atBeginning() + " is a " + data->GetClassName() + whatToDo);
  }
  return result;
}

/// Makes sure that the cells of a cell array can be read: that there are offsets, and that none
/// decreases or points past the end of the point ids. Neither vtkCellArray nor VTK's readers check
/// that. What the ids are is left to those who read them.
///
/// \param kind what the cells are: "polygons".
/// \param firstCell number of the first of these cells in the data set.
/// \throws InputError that names the first cell that cannot be read.
void requireReadable(
  vtkCellArray* cells, const std::string& kind, vtkIdType firstCell, const PartName& name)
{
  if (cells->IsValid()) // the rule, which is quick
  {
    return;
  }
  const std::string advice = ". Repair the cells upstream.";
  vtkDataArray* offsets = cells->GetOffsetsArray();
  const vtkIdType count = offsets->GetNumberOfValues() - 1;
  const vtkIdType numberOfIds = cells->GetConnectivityArray()->GetNumberOfValues();
  if (count < 0)
  {
    throw InputError(name.atBeginning() + " has " + kind +
      " with an offsets array that is empty, so that cell " + std::to_string(firstCell) +
      " cannot be read: it needs one value more than there are cells" + advice);
  }
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const auto begin = static_cast<vtkIdType>(offsets->GetComponent(cell, 0));
    const auto end = static_cast<vtkIdType>(offsets->GetComponent(cell + 1, 0));
    if (begin < 0 || end < begin || end > numberOfIds)
    {
      throw InputError(name.part("cell", firstCell + cell).atBeginning() +
        " cannot be read: the offsets of the " + kind + " (number " + std::to_string(cell) +
        " of these) say that its point ids go from " + std::to_string(begin) + " to " +
        std::to_string(end) + ", where offsets never decrease and lie between 0 and " +
        std::to_string(numberOfIds) + ", the number of ids" + advice);
    }
  }
}

/// The types of all cells. VTK 9.6 keeps them in arrays of several kinds and has a function without
/// parameters for them; where there is none, they are bytes.
template <class Grid>
auto cellTypesOf(Grid* grid, int) -> decltype(grid->GetCellTypes())
{
  return grid->GetCellTypes();
}

template <class Grid>
vtkDataArray* cellTypesOf(Grid* grid, long)
{
  return grid->GetCellTypesArray();
}

void requireTypes(vtkUnstructuredGrid* grid, const PartName& name)
{
  const vtkDataArray* types = cellTypesOf(grid, 0);
  const vtkIdType count = types ? types->GetNumberOfValues() : 0;
  if (count < grid->GetNumberOfCells())
  {
    throw InputError(name.part("cell", count).atBeginning() + " has no type: there are types of " +
      std::to_string(count) + " cells only, of " + std::to_string(grid->GetNumberOfCells()) +
      ". Repair the cells upstream.");
  }
}

PolyDataBlock surfaceBlock(vtkDataObject* data, const PartName& name)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    if (grid->GetCells())
    {
      requireReadable(grid->GetCells(), "cells", 0, name);
      requireTypes(grid, name);
    }
    return surfaceOfGrid(grid, name);
  }
  auto* polyData = requireType<vtkPolyData>(data, name, NoSurface);
  // vtkPolyData numbers its cells in this order.
  const std::pair<vtkCellArray*, const char*> kinds[] = { { polyData->GetVerts(), "vertices" },
    { polyData->GetLines(), "lines" }, { polyData->GetPolys(), "polygons" },
    { polyData->GetStrips(), "strips" } };
  vtkIdType first = 0;
  for (const auto& [cells, kind] : kinds)
  {
    requireReadable(cells, kind, first, name);
    first += cells->GetNumberOfCells();
  }
  return { polyData, name, {} };
}

/// The points that those of a data set were taken from; empty if it does not say so.
std::vector<vtkIdType> originalPointsOf(vtkPointSet* data)
{
  std::vector<vtkIdType> ids;
  vtkDataArray* array = data->GetPointData()->GetArray("vtkOriginalPointIds");
  const vtkIdType count = data->GetNumberOfPoints();
  if (array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() >= count)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      ids.push_back(static_cast<vtkIdType>(array->GetComponent(i, 0)));
    }
  }
  return ids;
}

PolyDataBlock targetBlock(vtkDataObject* data, const PartName& name)
{
  auto* pointSet = requireType<vtkPointSet>(data, name, NoPoints);
  const auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(pointSet->GetPoints());
  PolyDataBlock block{ points, name, {} };
  block.originalPoints = originalPointsOf(pointSet);
  return block;
}

PolyDataBlock sourceBlock(vtkDataObject* data, const PartName& name)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    PolyDataBlock block = surfaceBlock(data, name);
    block.originalPoints = originalPointsOf(polyData);
    return block;
  }
  PolyDataBlock block = targetBlock(data, name);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid && grid->GetCells())
  {
    requireReadable(grid->GetCells(), "cells", 0, name);
    requireTypes(grid, block.name);
    return sourceOfGrid(grid, std::move(block));
  }
  return block;
}

/// Goes through the blocks of a composite data set, those of nested ones too.
///
/// \param visit (iterator, block, name): "block 3 (wing)" is called by its number (as ParaView's
///        composite index) and the name that a file or the user has given. The parts of a
///        partitioned data set go by its name where they have none of their own.
template <typename Visit>
void forEachBlock(vtkCompositeDataSet* data, Visit&& visit)
{
  const auto at = vtk::TakeSmartPointer(data->NewIterator());
  if (auto* tree = vtkDataObjectTreeIterator::SafeDownCast(at))
  {
    tree->VisitOnlyLeavesOff();
  }
  std::string parent;
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    vtkInformation* info = at->HasCurrentMetaData() ? at->GetCurrentMetaData() : nullptr;
    const char* text = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
    const std::string own = text ? text : "";
    vtkDataObject* block = at->GetCurrentDataObject();
    if (block->IsA("vtkCompositeDataSet"))
    {
      parent = block->IsA("vtkPartitionedDataSet") ? own : "";
      continue;
    }
    const std::string& given = own.empty() ? parent : own;
    visit(at.Get(), block,
      "block " + std::to_string(at->GetCurrentFlatIndex()) +
        (given.empty() ? "" : " (" + given + ")"));
  }
}

/// \param read makes a block of a data set and its name.
template <typename Read>
std::vector<PolyDataBlock> blocksOf(vtkDataObject* input, const PartName& name, Read&& read)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return { read(input, name) };
  }
  std::vector<PolyDataBlock> blocks;
  forEachBlock(composite,
    [&](vtkCompositeDataIterator*, vtkDataObject* block, const std::string& ownName)
    { blocks.push_back(read(block, name.part(ownName))); });
  return blocks;
}

}

double PolyDataBlock::precision() const
{
  const bool isFloat =
    this->data->GetNumberOfPoints() > 0 && this->data->GetPoints()->GetDataType() == VTK_FLOAT;
  return isFloat ? FLT_EPSILON : DBL_EPSILON;
}

std::string listFirst(const std::vector<std::string>& names, std::size_t count)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return count > names.size() ? text + " and " + std::to_string(count - names.size()) + " more"
                              : text;
}

std::string listIds(const std::vector<vtkIdType>& ids)
{
  std::vector<std::string> first;
  for (std::size_t i = 0; i < std::min<std::size_t>(ids.size(), 5); ++i)
  {
    first.push_back(std::to_string(ids[i]));
  }
  return listFirst(first, ids.size());
}

void requireFinite(const PolyDataBlock& block, const char* isUsed)
{
  std::vector<vtkIdType> bad;
  for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i)
  {
    Vec3 p;
    block.data->GetPoint(i, p.data());
    if ((!isUsed || isUsed[i]) && !isFinite(p))
    {
      bad.push_back(i);
    }
  }
  if (!bad.empty())
  {
    throw InputError(block.name.atBeginning() +
      " has coordinates that are NaN or infinite, at point " + listIds(bad) +
      ". Remove or repair these points upstream.");
  }
}

void requirePoints(const PolyDataBlock& block, vtkIdType cell, vtkIdType size, const vtkIdType* ids)
{
  const vtkIdType count = block.data->GetNumberOfPoints();
  const auto* missing =
    std::find_if(ids, ids + size, [count](vtkIdType id) { return id < 0 || id >= count; });
  if (missing != ids + size)
  {
    throw InputError(block.name.part("cell", cell).atBeginning() + " names point " +
      std::to_string(*missing) + ", but there are only " + std::to_string(count) +
      " points. Repair the cells upstream.");
  }
}

std::vector<PolyDataBlock> polyDataBlocks(vtkDataObject* input, const PartName& name)
{
  return blocksOf(input, name, surfaceBlock);
}

std::vector<PolyDataBlock> sourceBlocks(
  vtkDataObject* input, const PartName& name, const PartArrays& arrays)
{
  return blocksOf(input, name,
    [&arrays](vtkDataObject* object, const PartName& ownName)
    {
      const bool hasIds = isChosen(arrays.sourceIds);
      PolyDataBlock block =
        arrays.areTargets && !hasIds ? targetBlock(object, ownName) : sourceBlock(object, ownName);
      auto* data = vtkDataSet::SafeDownCast(object);
      if (arrays.areTargets && hasIds && haveOnlyPointsIds(data, block, arrays))
      {
        block = targetBlock(object, ownName);
      }
      readPartArrays(data, arrays, block);
      return block;
    });
}

std::vector<vtkPolyData*> makeBlocksLike(vtkDataObject* input, vtkDataObject* output)
{
  if (auto* data = vtkPolyData::SafeDownCast(output))
  {
    return { data };
  }
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  auto* to = vtkCompositeDataSet::SafeDownCast(output);
  to->CopyStructure(from);
  std::vector<vtkPolyData*> blocks;
  forEachBlock(from,
    [&](vtkCompositeDataIterator* at, vtkDataObject*, const std::string&)
    {
      vtkNew<vtkPolyData> block;
      to->SetDataSet(at, block);
      blocks.push_back(block);
    });
  return blocks;
}

}
