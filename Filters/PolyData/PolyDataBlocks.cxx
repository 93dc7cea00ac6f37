// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/PolyDataBlocks.h"

#include "PolyData/Memory.h"
#include "PolyData/reading/GridSurface.h"
#include "Types.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
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

/// An array of the parts of a source, of targets, or of barriers.
struct PartArray
{
  const char* name;
  /// That has this name.
  const char* property;
  bool areOfPoints;
  /// What it names, and what to do where it is missing.
  const char* named;
  const char* advice;

  std::string kind() const { return this->areOfPoints ? "point" : "cell"; }
  vtkIdType count(vtkDataSet* data) const
  {
    return this->areOfPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells();
  }
  vtkAbstractArray* find(vtkDataSet* data, bool ofPoints) const
  {
    vtkFieldData* arrays =
      data->GetAttributesAsFieldData(ofPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
    return arrays ? arrays->GetAbstractArray(this->name) : nullptr;
  }
  /// As messages begin that say what is wrong with it.
  std::string in(const PolyDataBlock& block) const
  {
    return "The " + this->kind() + " array " + this->name + " (" + this->property + ") of " +
      block.name.text();
  }
};

PartArray arrayOfParts(const PolyDataBlock& block, const char* name, const char* property)
{
  return { name, property, block.isSetOfPoints(), "parts",
    "A set of points needs an array of its points, everything else one of its cells." };
}

PartArray arrayOfTargets(const char* name)
{
  return { name, "TargetNameArrayName", true, "points", "Choose an array of its points." };
}

PartArray barrierArray(const char* name)
{
  return { name, "BarrierArrayName", false, "barriers", "" };
}

/// \returns null if no array is chosen, or there is nothing that it could name.
/// \throws InputError if there is no such array, or it has several components or too few values.
vtkAbstractArray* requireArray(vtkDataSet* data, const PolyDataBlock& block, const PartArray& array)
{
  if (!isChosen(array.name) || data->GetNumberOfPoints() + data->GetNumberOfCells() == 0)
  {
    return nullptr;
  }
  vtkAbstractArray* values = array.find(data, array.areOfPoints);
  if (!values)
  {
    const std::string named = std::string(" array named ") + array.name;
    const std::string other = array.areOfPoints ? "cell" : "point";
    throw InputError(block.name.atBeginning() + " has no " + array.kind() + named + ", by which " +
      array.property + " names its " + array.named +
      (array.find(data, !array.areOfPoints) ? ", but a " + other + named : "") + ". " +
      array.advice);
  }
  if (values->GetNumberOfComponents() != 1)
  {
    throw InputError(array.in(block) + " has " + std::to_string(values->GetNumberOfComponents()) +
      " components, where one value is needed. Choose an array with one component.");
  }
  const vtkIdType count = array.count(data);
  if (values->GetNumberOfTuples() < count)
  {
    throw InputError(array.in(block) + " has " + std::to_string(values->GetNumberOfTuples()) +
      " values for " + std::to_string(count) + ' ' + array.kind() + "s. Give each a value.");
  }
  return values;
}

/// Null if the array does not hold integers.
vtkDataArray* integersOf(vtkAbstractArray* any)
{
  auto* values = vtkDataArray::SafeDownCast(any);
  const int type = values ? values->GetDataType() : VTK_FLOAT;
  return type == VTK_FLOAT || type == VTK_DOUBLE ? nullptr : values;
}

/// The names in an array of strings or integers; none if it is not chosen.
///
/// \throws InputError
std::vector<std::string> readNames(
  vtkDataSet* data, const PolyDataBlock& block, const PartArray& array)
{
  std::vector<std::string> names;
  vtkAbstractArray* any = requireArray(data, block, array);
  if (!any)
  {
    return names;
  }
  vtkDataArray* numbers = integersOf(any);
  auto* words = vtkStringArray::SafeDownCast(any);
  if (!numbers && !words)
  {
    throw InputError(array.in(block) + " is a " + any->GetClassName() +
      ", where strings or whole numbers are needed. Choose an array of these.");
  }
  const vtkIdType count = array.count(data);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkVariant value = any->GetVariantValue(i);
    const bool isByte = numbers && numbers->GetDataTypeSize() == 1; // else written as a letter
    names.push_back(isByte ? std::to_string(value.ToInt()) : std::string(value.ToString()));
  }
  return names;
}

/// Whether all numbers are whole ones, whatever they are stored as.
bool areWhole(vtkDataArray* numbers)
{
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    const double value = numbers->GetComponent(i, 0);
    if (value != std::floor(value))
    {
      return false;
    }
  }
  return true;
}

/// Values that cannot be ids become -1 or SourceIdEnd.
std::vector<vtkIdType> readIds(vtkDataSet* data, const PolyDataBlock& block, const PartArray& array)
{
  std::vector<vtkIdType> ids;
  vtkAbstractArray* any = requireArray(data, block, array);
  if (!any)
  {
    return ids;
  }
  auto* values = vtkDataArray::SafeDownCast(any);
  if (!values || !(integersOf(any) || areWhole(values)))
  {
    throw InputError(array.in(block) + " is a " + any->GetClassName() +
      (values ? " with a value that is no whole number" : "") +
      ", where whole numbers are needed. Choose an array of them, or make one (Calculator, with "
      "floor).");
  }
  const vtkIdType count = array.count(data);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = values->GetComponent(i, 0);
    ids.push_back(value < 0.0                       ? -1
        : value >= static_cast<double>(SourceIdEnd) ? SourceIdEnd
                                                    : static_cast<vtkIdType>(value));
  }
  return ids;
}

/// The cells of the input that are faces, in their order.
std::vector<vtkIdType> facesOf(const PolyDataBlock& block)
{
  std::vector<vtkIdType> faces;
  const vtkIdType first = block.data->GetNumberOfVerts() + block.data->GetNumberOfLines();
  for (vtkIdType cell = first; cell < block.data->GetNumberOfCells(); ++cell)
  {
    const vtkIdType face = block.inputCell(cell);
    if (faces.empty() || faces.back() != face)
    {
      faces.push_back(face);
    }
  }
  return faces;
}

/// Replaces the barriers' array of one value a face by one with a value for each cell, 0 for those
/// that are no faces. The input keeps its own.
void giveToCells(const std::vector<vtkIdType>& faces, PolyDataBlock& block)
{
  vtkDataArray* ofFaces = block.barriers;
  const vtkIdType count = block.countInputCells();
  requireMemory(count, ofFaces->GetDataTypeSize());
  const auto ofCells = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(ofFaces->GetDataType()));
  ofCells->SetName(ofFaces->GetName());
  ofCells->SetNumberOfTuples(count);
  ofCells->Fill(0.0);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    ofCells->SetTuple(faces[i], static_cast<vtkIdType>(i), ofFaces);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(block.data);
  data->GetCellData()->AddArray(ofCells);
  block.data = data;
  block.barriers = ofCells;
}

/// \throws InputError
void requireBarrierValues(PolyDataBlock& block)
{
  vtkDataArray* values = block.barriers;
  const std::string begin = barrierArray(values->GetName()).in(block);
  if (values->GetNumberOfComponents() != 1)
  {
    throw InputError(begin + " has " + std::to_string(values->GetNumberOfComponents()) +
      " components, where one number a cell is needed. Choose an array with one component, or make "
      "one, for example by the Calculator filter.");
  }
  const vtkIdType cells = block.countInputCells();
  if (values->GetNumberOfTuples() != cells)
  {
    const std::vector<vtkIdType> faces = facesOf(block);
    const auto count = static_cast<vtkIdType>(faces.size());
    if (values->GetNumberOfTuples() != count)
    {
      throw InputError(begin + " has " + std::to_string(values->GetNumberOfTuples()) +
        " values for " + std::to_string(cells) + " cells" +
        (count == cells ? ". Give each cell a value."
                        : ", " + std::to_string(count) +
              " of which are faces. Give each cell, or each face, a value."));
    }
    giveToCells(faces, block);
    values = block.barriers;
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

vtkSmartPointer<vtkCellArray> getCells(MessageReader& reader)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto ids = reader.getAll<vtkIdType>();
  cells->ImportLegacyFormat(ids.data(), static_cast<vtkIdType>(ids.size()));
  return cells;
}

void putText(Message& message, const std::string& text)
{
  putAll(message, std::vector<char>(text.begin(), text.end()));
}

std::string getText(MessageReader& reader)
{
  const auto chars = reader.getAll<char>();
  return { chars.begin(), chars.end() };
}

void putNames(Message& message, const std::vector<std::string>& names)
{
  put(message, names.size());
  for (const std::string& name : names)
  {
    putText(message, name);
  }
}

std::vector<std::string> getNames(MessageReader& reader)
{
  std::vector<std::string> names(reader.get<std::size_t>());
  for (std::string& name : names)
  {
    name = getText(reader);
  }
  return names;
}

void putBlock(const PolyDataBlock& block, Message& message)
{
  putText(message, block.name.withoutInput());
  vtkPolyData* data = block.data;
  const vtkIdType count = data->GetNumberOfPoints();
  put(message, block.precision() == FLT_EPSILON ? VTK_FLOAT : VTK_DOUBLE);
  put(message, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    put(message, data->GetPoint(i), 3);
  }
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    vtkNew<vtkIdTypeArray> ids;
    cells->ExportLegacyFormat(ids);
    putAll(message, std::vector<vtkIdType>(ids->Begin(), ids->End()));
  }
  putAll(message, block.inputCells);
  put(message, block.droppedCells);
  putAll(message, block.sourceIds);
  putAll(message, block.originalPoints);
  putNames(message, block.partNames);
  putNames(message, block.pointNames);
}

/// Adds the blocks of a message to others.
///
/// \param input as messages call what they are blocks of.
/// \returns how many points they have.
std::size_t takeBlocks(
  const Message& message, const PartName& input, std::vector<PolyDataBlock>& blocks)
{
  std::size_t numberOfPoints = 0;
  MessageReader reader(message);
  while (!reader.isAtEnd())
  {
    const std::string part = getText(reader);
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(reader.get<int>());
    points->SetNumberOfPoints(reader.get<vtkIdType>());
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, reader.get<Vec3>().data());
    }
    numberOfPoints += static_cast<std::size_t>(points->GetNumberOfPoints());
    data->SetPoints(points);
    data->SetVerts(getCells(reader));
    data->SetLines(getCells(reader));
    data->SetPolys(getCells(reader));
    data->SetStrips(getCells(reader));
    auto inputCells = reader.getAll<vtkIdType>();
    blocks.push_back({ data, part.empty() ? input : input.part(part), std::move(inputCells),
      reader.get<vtkIdType>() });
    blocks.back().sourceIds = reader.getAll<vtkIdType>();
    blocks.back().originalPoints = reader.getAll<vtkIdType>();
    blocks.back().partNames = getNames(reader);
    blocks.back().pointNames = getNames(reader);
  }
  return numberOfPoints;
}

}

bool isChosen(const char* array)
{
  return array && *array && std::string(array) != "None";
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
    : block.name.atBeginning() + " has coordinates that are NaN or infinite, at point " +
      listIds(bad) + ". Remove or repair these points upstream.";
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
      PolyDataBlock block = sourceBlock(object, ownName);
      auto* data = vtkDataSet::SafeDownCast(object);
      const char* const role = arrays.areTargets ? "Target" : "Source";
      const std::string idProperty = std::string(role) + "IdArrayName";
      const std::string nameProperty = std::string(role) + "NameArrayName";
      const PartArray ids = arrayOfParts(block, arrays.sourceIds, idProperty.c_str());
      if (arrays.areTargets && !ids.find(data, ids.areOfPoints) && ids.find(data, true))
      {
        block = targetBlock(object, ownName);
      }
      block.sourceIds =
        readIds(data, block, arrayOfParts(block, arrays.sourceIds, idProperty.c_str()));
      block.partNames =
        readNames(data, block, arrayOfParts(block, arrays.sourceNames, nameProperty.c_str()));
      block.pointNames = readNames(data, block, arrayOfTargets(arrays.targetNames));
      return block;
    });
}

std::vector<PolyDataBlock> targetBlocks(
  vtkDataObject* input, const PartName& name, const char* nameArray)
{
  return blocksOf(input, name,
    [nameArray](vtkDataObject* data, const PartName& ownName)
    {
      PolyDataBlock block = targetBlock(data, ownName);
      block.pointNames =
        readNames(vtkDataSet::SafeDownCast(data), block, arrayOfTargets(nameArray));
      return block;
    });
}

void findBarrierArrays(std::vector<PolyDataBlock>& blocks, const char* array, Exchange& exchange)
{
  if (!isChosen(array))
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
      requireBarrierValues(block);
      isFound = true;
    }
    else if (any)
    {
      throw InputError(barrierArray(array).in(block) + " is a " + any->GetClassName() +
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

GatheredBlocks gatherBlocks(
  const std::vector<PolyDataBlock>& own, const PartName& name, Exchange& exchange)
{
  GatheredBlocks gathered;
  if (exchange.numberOfRanks() == 1)
  {
    gathered.blocks = own;
    return gathered;
  }
  Message message;
  for (const PolyDataBlock& block : own)
  {
    if (block.data->GetNumberOfPoints() > 0 || block.data->GetNumberOfCells() > 0)
    {
      putBlock(block, message);
    }
  }
  const std::vector<Message> all = exchange.tellAll(message);
  const auto ranks = static_cast<std::ptrdiff_t>(all.size());
  const bool isOnOneRank = std::count(all.begin(), all.end(), Message()) >= ranks - 1;
  const bool areCopies = std::count(all.begin(), all.end(), all.front()) == ranks;
  for (std::size_t rank = 0; rank < (areCopies ? 1 : all.size()); ++rank)
  {
    const PartName input = isOnOneRank || areCopies ? name : name.onRank(static_cast<int>(rank));
    gathered.firstPointOfRank.push_back(
      gathered.firstPointOfRank.back() + takeBlocks(all[rank], input, gathered.blocks));
  }
  if (gathered.blocks.empty())
  {
    gathered.blocks.push_back({ vtkSmartPointer<vtkPolyData>::New(), name, {} });
  }
  return gathered;
}

}
