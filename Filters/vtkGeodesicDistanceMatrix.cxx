// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceMatrix.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/Inputs.h"
#include "PolyData/Memory.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "field/DistanceMatrix.h"

#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace geodesic;

vtkStandardNewMacro(vtkGeodesicDistanceMatrix);

namespace
{

const char* const TargetIdColumn = "TargetId";
const char* const TargetNameColumn = "TargetName";
const char* const TargetPositionColumn = "TargetPosition";

/// A name for the column of each source that no other column has.
std::vector<std::string> ColumnNames(const Sources& sources)
{
  std::set<std::string> given = { TargetIdColumn, TargetNameColumn, TargetPositionColumn };
  std::vector<std::string> names = sources.names;
  names.resize(sources.ids.size());
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::string id = std::to_string(sources.ids[i]);
    std::string& name = names[i];
    name = name.empty() ? "Source" + id : name;
    while (!given.insert(name).second)
    {
      name.append("_").append(id);
    }
  }
  return names;
}

/// Adds the names of targets that have some.
void AddTargetNames(const Inputs& inputs, vtkTable* table)
{
  vtkNew<vtkStringArray> column;
  column->SetName(TargetNameColumn);
  column->SetNumberOfValues(static_cast<vtkIdType>(inputs.targets.count));
  vtkIdType row = 0;
  bool hasNames = false;
  const auto addNames = [&](const std::vector<std::string>& names)
  {
    hasNames = hasNames || !names.empty();
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      column->SetValue(row + static_cast<vtkIdType>(i), names[i]);
    }
  };
  if (const Sources* sets = inputs.setsOfTargets())
  {
    addNames(sets->names);
  }
  else
  {
    for (const PolyDataBlock& block : inputs.targetBlocks.blocks)
    {
      addNames(block.pointNames);
      row += block.data->GetNumberOfPoints();
    }
  }
  if (hasNames)
  {
    table->AddColumn(column);
  }
}

/// Adds where targets are; of a set the first point on the surface, NaN where there is none.
void AddTargetPositions(const Inputs& inputs, vtkTable* table)
{
  const auto rows = static_cast<vtkIdType>(inputs.targets.count);
  requireMemory(rows, 3 * static_cast<vtkIdType>(sizeof(double)));
  vtkNew<vtkDoubleArray> column;
  column->SetName(TargetPositionColumn);
  column->SetNumberOfComponents(3);
  column->SetNumberOfTuples(rows);
  column->Fill(std::numeric_limits<double>::quiet_NaN());
  if (const Sources* sets = inputs.setsOfTargets())
  {
    const PolyDataSurface& surface = *inputs.surface;
    for (auto curve = sets->curves.rbegin(); curve != sets->curves.rend(); ++curve)
    {
      const Vec3 place = position(surface.mesh(), curve->points.front());
      column->SetTuple(static_cast<vtkIdType>(curve->source), surface.scale.toUser(place).data());
    }
    table->AddColumn(column);
    return;
  }
  vtkIdType row = 0;
  for (const PolyDataBlock& block : inputs.targetBlocks.blocks)
  {
    for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i)
    {
      column->SetTuple(row++, block.data->GetPoint(i));
    }
  }
  table->AddColumn(column);
}

/// Adds the column of a source. Its distances are freed: there may be no memory for all of them
/// twice.
void AddSource(const std::string& name, std::vector<double> distances, const Targets& targets,
  const PowerOfTwoScale& scale, vtkTable* table)
{
  const auto column =
    makeArray<vtkDoubleArray>(name.c_str(), static_cast<vtkIdType>(targets.count));
  column->Fill(Infinity);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    column->SetValue(
      static_cast<vtkIdType>(targets.numbers[i]), scale.distanceToUser(distances[i]));
  }
  table->AddColumn(column);
}

/// \param maximumDistance in the engine's units.
/// \returns for each source the distances of the targets.
std::vector<std::vector<double>> Solve(const Inputs& inputs, double maximumDistance, const Job& job)
{
  const TriangleMesh& mesh = inputs.surface->mesh();
  const Sources& sources = inputs.sources;
  const std::size_t count = sources.ids.size();
  if (inputs.areTargetsSources)
  {
    return distancesBetween(mesh, setsOf(sources.curves, count), maximumDistance, job);
  }
  const Sources* sets = inputs.setsOfTargets();
  const CurveSets targets =
    sets != nullptr ? setsOf(sets->curves, sets->ids.size()) : setsOf(inputs.targets.places);
  return distanceMatrix(mesh, setsOf(sources.curves, count), targets, maximumDistance, job);
}

/// \param maximumDistance in the units of the surface; 0: no limit.
void ComputeTable(const Inputs& inputs, double maximumDistance, bool hasPositions,
  FilterExecution& execution, vtkTable* table)
{
  const Sources* sets = inputs.setsOfTargets();
  const auto rows = static_cast<vtkIdType>(inputs.targets.count);
  const auto numberOfSources = static_cast<vtkIdType>(inputs.sources.ids.size());

  const Job job = execution.begin(Stage::SolveForTargets);
  // Once as they are computed, once as they are put out.
  requireMemory(rows,
    static_cast<vtkIdType>(sizeof(vtkIdType)) +
      2 * static_cast<vtkIdType>(sizeof(double)) * numberOfSources);
  const PowerOfTwoScale& scale = inputs.surface->scale;
  std::vector<std::vector<double>> matrix = Solve(inputs, inputs.limitOf(maximumDistance), job);

  execution.begin(Stage::Write);
  const auto ids = makeArray<vtkIdTypeArray>(TargetIdColumn, rows);
  std::iota(ids->GetPointer(0), ids->GetPointer(rows), 0);
  if (sets)
  {
    std::copy(sets->ids.begin(), sets->ids.end(), ids->GetPointer(0));
  }
  table->AddColumn(ids);
  AddTargetNames(inputs, table);
  if (hasPositions)
  {
    AddTargetPositions(inputs, table);
  }
  const std::vector<std::string> names = ColumnNames(inputs.sources);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    AddSource(names[i], std::move(matrix[i]), inputs.targets, scale, table);
  }
}

/// Where another rank than the first has made the table, hands it over. All ranks call this.
void MoveToFirstRank(Exchange& exchange, vtkTable* table)
{
  std::vector<Message> messages = exchange.noMessages();
  vtkNew<vtkCharArray> bytes;
  if (exchange.rank() > 0 && table->GetNumberOfColumns() > 0)
  {
    vtkCommunicator::MarshalDataObject(table, bytes);
    put(
      messages.front(), bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()));
    table->Initialize();
  }
  for (const Message& message : exchange.step(std::move(messages)))
  {
    if (!message.empty())
    {
      bytes->SetNumberOfValues(static_cast<vtkIdType>(message.size()));
      MessageReader(message).get(bytes->GetPointer(0), message.size());
      vtkCommunicator::UnMarshalDataObject(bytes, table);
    }
  }
}

}

//------------------------------------------------------------------------------
vtkGeodesicDistanceMatrix::~vtkGeodesicDistanceMatrix()
{
  this->SetSourceNameArrayName(nullptr);
  this->SetTargetNameArrayName(nullptr);
  this->SetTargetIdArrayName(nullptr);
}

//------------------------------------------------------------------------------
vtkTable* vtkGeodesicDistanceMatrix::GetOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
int vtkGeodesicDistanceMatrix::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkGeodesicDistanceMatrix::FindWrongProperty() const
{
  return this->MaximumDistance >= 0.0 ? this->Superclass::FindWrongProperty()
                                      : WrongMaximumDistance;
}

//------------------------------------------------------------------------------
std::string vtkGeodesicDistanceMatrix::AdviceOnMemory() const
{
  return "Decimate the surface, cut it into parts, set MaximumDistance, or use fewer threads or "
         "targets.";
}

//------------------------------------------------------------------------------
ExecutionPlan vtkGeodesicDistanceMatrix::Plan() const
{
  ExecutionPlan plan;
  plan.stages = { Stage::SolveForTargets, Stage::Write };
  plan.targets = TargetPoints::OfTargetsOrSource;
  plan.supportsPieces = false;
  plan.sourceNameArray = this->SourceNameArrayName;
  plan.targetNameArray = this->TargetNameArrayName;
  plan.targetIdArray = this->TargetIdArrayName;
  return plan;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::Compute(
  const Inputs& inputs, FilterExecution& execution, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector);
  if (inputs.rank.isWorking())
  {
    ComputeTable(inputs, this->MaximumDistance, this->GenerateTargetPositions, execution, table);
  }
  MoveToFirstRank(execution.exchange(), table);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "SourceNameArrayName: "
     << (this->SourceNameArrayName ? this->SourceNameArrayName : "(none)") << "\n";
  os << indent << "TargetNameArrayName: "
     << (this->TargetNameArrayName ? this->TargetNameArrayName : "(none)") << "\n";
  os << indent
     << "TargetIdArrayName: " << (this->TargetIdArrayName ? this->TargetIdArrayName : "(none)")
     << "\n";
  os << indent << "GenerateTargetPositions: " << (this->GenerateTargetPositions ? "On" : "Off")
     << "\n";
}
