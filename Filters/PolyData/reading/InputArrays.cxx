// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/InputArrays.h"

#include "PolyData/Memory.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <cmath>
#include <string>

namespace geodesic
{

namespace
{

/// An array of a block that a property chooses.
struct InputArray
{
  const PolyDataBlock& block;
  const char* name;
  std::string property;
  bool isOfPoints;
  /// What it names, and what to do where it is missing.
  const char* named = "";
  const char* advice = "";

  std::string kind() const { return this->isOfPoints ? "point" : "cell"; }
  vtkIdType count(vtkDataSet* data) const
  {
    return this->isOfPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells();
  }
  vtkAbstractArray* find(vtkDataSet* data, bool ofPoints) const
  {
    vtkFieldData* arrays =
      data->GetAttributesAsFieldData(ofPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
    return arrays ? arrays->GetAbstractArray(this->name) : nullptr;
  }

  /// That something is wrong with it: " is a vtkStringArray, where ..."
  InputError error(const std::string& what) const
  {
    return InputError("The " + this->kind() + " array " + this->name + " (" + this->property +
      ") of " + this->block.name.text() + what);
  }
  InputError errorOfType(vtkAbstractArray* any, const std::string& what) const
  {
    return this->error(std::string(" is a ") + any->GetClassName() + what);
  }
  void requireOneComponent(vtkAbstractArray* any, const std::string& needed) const
  {
    if (any->GetNumberOfComponents() != 1)
    {
      throw this->error(
        " has " + std::to_string(any->GetNumberOfComponents()) + " components, where " + needed);
    }
  }

  /// \returns null if no array is chosen, or there is nothing that it could name.
  /// \throws InputError if there is no such array, or it has several components or too few values.
  vtkAbstractArray* require(vtkDataSet* data) const
  {
    if (!isChosen(this->name) || data->GetNumberOfPoints() + data->GetNumberOfCells() == 0)
    {
      return nullptr;
    }
    vtkAbstractArray* any = this->find(data, this->isOfPoints);
    if (!any)
    {
      const std::string arrayNamed = std::string(" array named ") + this->name;
      const std::string other = this->isOfPoints ? "cell" : "point";
      throw InputError(this->block.name.atBeginning() + " has no " + this->kind() + arrayNamed +
        ", by which " + this->property + " names its " + this->named +
        (this->find(data, !this->isOfPoints) ? ", but a " + other + arrayNamed : "") + ". " +
        this->advice);
    }
    this->requireOneComponent(any, "one value is needed. Choose an array with one component.");
    if (any->GetNumberOfTuples() < this->count(data))
    {
      throw this->error(" has " + std::to_string(any->GetNumberOfTuples()) + " values for " +
        std::to_string(this->count(data)) + ' ' + this->kind() + "s. Give each a value.");
    }
    return any;
  }
};

/// \param what the array tells of parts: "Id".
InputArray arrayOfParts(
  const PolyDataBlock& block, const PartArrays& arrays, const char* name, const char* what)
{
  return { block, name,
    (arrays.areTargets ? "Target" : "Source") + (what + std::string("ArrayName")),
    block.isSetOfPoints(), "parts",
    "A set of points needs an array of its points, everything else one of its cells." };
}

/// The names in an array of strings or integers; none if it is not chosen.
///
/// \throws InputError
std::vector<std::string> readNames(vtkDataSet* data, const InputArray& array)
{
  std::vector<std::string> names;
  vtkAbstractArray* any = array.require(data);
  if (!any)
  {
    return names;
  }
  const bool areNumbers = vtkDataArray::SafeDownCast(any) && any->GetDataType() != VTK_FLOAT &&
    any->GetDataType() != VTK_DOUBLE;
  if (!areNumbers && !vtkStringArray::SafeDownCast(any))
  {
    throw array.errorOfType(
      any, ", where strings or whole numbers are needed. Choose an array of these.");
  }
  const bool areBytes = areNumbers && any->GetDataTypeSize() == 1; // else written as letters
  const vtkIdType count = array.count(data);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkVariant value = any->GetVariantValue(i);
    names.push_back(areBytes ? std::to_string(value.ToInt()) : std::string(value.ToString()));
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
std::vector<vtkIdType> readIds(vtkDataSet* data, const InputArray& array)
{
  std::vector<vtkIdType> ids;
  vtkAbstractArray* any = array.require(data);
  auto* values = vtkDataArray::SafeDownCast(any);
  if (any && (!values || !areWhole(values)))
  {
    throw array.errorOfType(any,
      std::string(values ? " with a value that is no whole number" : "") +
        ", where whole numbers are needed. Choose an array of them, or make one (Calculator, with "
        "floor).");
  }
  const vtkIdType count = values ? array.count(data) : 0;
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
void requireBarrierValues(const InputArray& array, PolyDataBlock& block)
{
  array.requireOneComponent(block.barriers,
    "one number a cell is needed. Choose an array with one component, or make one, for example by "
    "the Calculator filter.");
  const vtkIdType cells = block.countInputCells();
  const vtkIdType values = block.barriers->GetNumberOfTuples();
  if (values != cells)
  {
    const std::vector<vtkIdType> faces = facesOf(block);
    const auto count = static_cast<vtkIdType>(faces.size());
    if (values != count)
    {
      throw array.error(" has " + std::to_string(values) + " values for " + std::to_string(cells) +
        " cells" +
        (count == cells ? ". Give each cell a value."
                        : ", " + std::to_string(count) +
              " of which are faces. Give each cell, or each face, a value."));
    }
    giveToCells(faces, block);
  }
  std::vector<vtkIdType> bad;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    if (std::isnan(block.barriers->GetComponent(cell, 0)))
    {
      bad.push_back(cell);
    }
  }
  if (!bad.empty())
  {
    throw array.error(" is NaN at cell " + listIds(bad) +
      ", which says neither that these are barriers nor that they are none. Set it to 0 where "
      "paths may pass and to 1 where they may not.");
  }
}

}

bool isChosen(const char* array)
{
  return array && *array && std::string(array) != "None";
}

bool haveOnlyPointsIds(vtkDataSet* data, const PolyDataBlock& block, const PartArrays& arrays)
{
  const InputArray ids = arrayOfParts(block, arrays, arrays.sourceIds, "Id");
  return !ids.find(data, ids.isOfPoints) && ids.find(data, true);
}

void readPartArrays(vtkDataSet* data, const PartArrays& arrays, PolyDataBlock& block)
{
  block.sourceIds = readIds(data, arrayOfParts(block, arrays, arrays.sourceIds, "Id"));
  block.partNames = readNames(data, arrayOfParts(block, arrays, arrays.sourceNames, "Name"));
  block.pointNames = readNames(data,
    { block, arrays.targetNames, "TargetNameArrayName", true, "points",
      "Choose an array of its points." });
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
    const InputArray barriers{ block, array, "BarrierArrayName", false };
    vtkAbstractArray* any = barriers.find(block.data, false);
    block.barriers = vtkDataArray::SafeDownCast(any);
    if (block.barriers)
    {
      requireBarrierValues(barriers, block);
      isFound = true;
    }
    else if (any)
    {
      throw barriers.errorOfType(any, ", where numbers are needed. Choose a numeric array.");
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
