// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/PolyDataBlocks.h"

#include "PolyData/CellLoop.h"
#include "PolyData/reading/CellArrays.h"
#include "Types.h"

#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace geodesic
{

namespace
{

const char* const NoSurface =
  ": apply Extract Surface to it first. A vtkPolyData, or a composite data set of these, is "
  "needed; vtkDataSetSurfaceFilter and vtkGeometryFilter make one.";
const char* const NoPoints =
  ", which has no points of its own. A vtkPolyData, a vtkUnstructuredGrid, another vtkPointSet, or "
  "a composite data set of these, is needed: of an image or a grid Extract Surface makes one, of a "
  "table Table To Points.";

/// \param whatToDo where it is of another type.
/// \throws InputError
template <typename Type>
Type* requireType(vtkDataObject* data, const std::string& name, const char* whatToDo)
{
  auto* result = Type::SafeDownCast(data);
  if (!result)
  {
    throw InputError(capitalized(name) + " is a " + data->GetClassName() + whatToDo);
  }
  return result;
}

PolyDataBlock surfaceBlock(vtkDataObject* data, const std::string& name)
{
  auto* polyData = requireType<vtkPolyData>(data, name, NoSurface);
  requireReadable(polyData, name);
  return { polyData, name, {}, 0 };
}

PolyDataBlock targetBlock(vtkDataObject* data, const std::string& name)
{
  const auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(requireType<vtkPointSet>(data, name, NoPoints)->GetPoints());
  return { points, name, {}, 0 };
}

vtkUnsignedCharArray* requireTypes(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  const vtkIdType count = types ? types->GetNumberOfValues() : 0;
  if (count < grid->GetNumberOfCells())
  {
    throw InputError("Cell " + std::to_string(count) + " of " + name +
      " has no type: there are types of " + std::to_string(count) + " cells only, of " +
      std::to_string(grid->GetNumberOfCells()) + ". Repair the cells upstream.");
  }
  return types;
}

/// A cell that is neither a vertex nor a line becomes a line without points, so that the others
/// keep their numbers.
void addVerticesAndLines(vtkUnstructuredGrid* grid, PolyDataBlock& block)
{
  vtkUnsignedCharArray* types = requireTypes(grid, block.name);
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> cellsOfLines;
  vtkIdType next = 0;
  forEachCell(grid->GetCells(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      const vtkIdType cell = next++;
      const int type = types->GetValue(cell);
      if (type == VTK_VERTEX || type == VTK_POLY_VERTEX)
      {
        vertices->InsertNextCell(size, ids);
        block.inputCells.push_back(cell);
        return;
      }
      const bool isLine = type == VTK_LINE || type == VTK_POLY_LINE;
      lines->InsertNextCell(isLine ? size : 0, ids);
      cellsOfLines.push_back(cell);
      block.droppedCells += isLine || type == VTK_EMPTY_CELL ? 0 : 1;
    });
  block.inputCells.insert(block.inputCells.end(), cellsOfLines.begin(), cellsOfLines.end());
  block.data->SetVerts(vertices);
  block.data->SetLines(lines);
}

PolyDataBlock sourceBlock(vtkDataObject* data, const std::string& name)
{
  if (data->IsA("vtkPolyData"))
  {
    return surfaceBlock(data, name);
  }
  PolyDataBlock block = targetBlock(data, name);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid && grid->GetCells())
  {
    requireReadable(grid->GetCells(), "cells", 0, name);
    addVerticesAndLines(grid, block);
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
std::vector<PolyDataBlock> blocksOf(vtkDataObject* input, const std::string& name,
  PolyDataBlock (*read)(vtkDataObject*, const std::string&))
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return { read(input, name) };
  }
  std::vector<PolyDataBlock> blocks;
  forEachBlock(composite,
    [&](vtkCompositeDataIterator*, vtkDataObject* block, const std::string& ownName)
    { blocks.push_back(read(block, ownName + " of " + name)); });
  return blocks;
}

}

std::string capitalized(std::string name)
{
  name[0] = name[0] == 'b' ? 'B' : 'T';
  return name;
}

std::string listIds(const std::vector<vtkIdType>& ids)
{
  const std::size_t shown = std::min<std::size_t>(ids.size(), 5);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i)
  {
    text += (i == 0 ? "" : ", ") + std::to_string(ids[i]);
  }
  if (ids.size() > shown)
  {
    text += " and " + std::to_string(ids.size() - shown) + " more";
  }
  return text;
}

std::string whereNotFinite(const PolyDataBlock& block, const char* isUsed)
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
  return bad.empty()
    ? std::string()
    : capitalized(block.name) + " has coordinates that are NaN or infinite, at point " +
      listIds(bad) + ". Remove or repair these points upstream.";
}

std::vector<PolyDataBlock> polyDataBlocks(vtkDataObject* input, const std::string& name)
{
  return blocksOf(input, name, surfaceBlock);
}

std::vector<PolyDataBlock> sourceBlocks(vtkDataObject* input, const std::string& name)
{
  return blocksOf(input, name, sourceBlock);
}

std::vector<PolyDataBlock> targetBlocks(vtkDataObject* input, const std::string& name)
{
  return blocksOf(input, name, targetBlock);
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
