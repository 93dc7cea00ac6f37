// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicPaths.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/ParallelFor.h"
#include "PolyData/PathWriter.h"
#include "field/PathsOnRanks.h"
#include "field/PathsToSource.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkGeodesicPaths);

namespace
{

// Where the stages end, as fractions of the whole; geodesic::FilterExecution has those before.
constexpr double TargetsRead = 0.3;
constexpr double PathsFound = 0.95;

void NoteUnreached(geodesic::FilterExecution& execution, std::size_t count)
{
  execution.notes().add(geodesic::NoteOn::Targets, count, "target", "targets",
    "not reached: no path on the surface leads from there to the source.");
}

/// Where the surface is in pieces: finds the paths of the targets in this rank's piece, and gets
/// those of the targets that this rank's input had, in their order.
std::vector<geodesic::PathOfTarget> PathsOfThisRank(const geodesic::FilterExecution& execution,
  const geodesic::Targets& targets, const geodesic::PathsOptions& options)
{
  const geodesic::SurfacePart& part = *execution.surface().part();
  const std::vector<geodesic::PathInSpace> found = geodesic::pathsOnRanks(
    part, execution.patch(), execution.sources().curves, targets.places, options);
  std::vector<geodesic::Message> messages = part.exchange().noMessages();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (!found[i].points.empty())
    {
      const int home = execution.rankOfTarget(targets.numbers[i]);
      geodesic::Message& message = messages[static_cast<std::size_t>(home)];
      geodesic::put(message, targets.numbers[i]);
      geodesic::put(message, targets.snapDistances[i]);
      geodesic::put(message, found[i].source);
      geodesic::put(message, found[i].points.size());
      geodesic::put(message, found[i].points.data(), found[i].points.size());
    }
  }
  std::vector<geodesic::PathOfTarget> paths;
  geodesic::readEach(part.exchange().step(std::move(messages)),
    [&](int, geodesic::MessageReader& reader)
    {
      geodesic::PathOfTarget& path = paths.emplace_back();
      path.target = reader.get<std::size_t>();
      path.snapDistance = reader.get<double>();
      path.source = reader.get<geodesic::Id>();
      path.points.resize(reader.get<std::size_t>());
      reader.get(path.points.data(), path.points.size());
    });
  std::sort(paths.begin(), paths.end(),
    [](const geodesic::PathOfTarget& a, const geodesic::PathOfTarget& b)
    { return a.target < b.target; });
  return paths;
}

}

//------------------------------------------------------------------------------
vtkGeodesicPaths::vtkGeodesicPaths()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
vtkGeodesicPaths::~vtkGeodesicPaths() = default;

//------------------------------------------------------------------------------
void vtkGeodesicPaths::SetTargetsConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::SetTargetsData(vtkDataObject* targets)
{
  this->SetInputDataInternal(2, targets);
}

//------------------------------------------------------------------------------
int vtkGeodesicPaths::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // so that the error can say what to do
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::ResetResults() {}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::Compute(
  geodesic::FilterExecution& execution, vtkInformationVector* outputVector)
{
  execution.requireTargets();
  execution.readInputs(geodesic::FilterExecution::Pieces::Taken);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  if (execution.surfacePlace() == geodesic::SurfacePlace::Elsewhere)
  {
    geodesic::writePaths(geodesic::PowerOfTwoScale(), {}, output, {});
    return;
  }
  const geodesic::Targets targets = execution.readTargets(TargetsRead);

  execution.enter(geodesic::Stage::ComputingDistances);
  const geodesic::PolyDataSurface& surface = execution.surface();
  geodesic::PathsOptions options;
  options.parallelFor = geodesic::smpParallelFor();
  options.progress = execution.progressBetween(TargetsRead, PathsFound);
  if (surface.part())
  {
    const std::vector<geodesic::PathOfTarget> paths = PathsOfThisRank(execution, targets, options);
    execution.reach(PathsFound);
    NoteUnreached(execution, targets.count - execution.sumOverPieces(paths.size()));
    execution.enter(geodesic::Stage::WritingOutputs);
    geodesic::writePaths(
      surface.scale(), paths, output, execution.progressBetween(PathsFound, 1.0));
    return;
  }
  const std::vector<geodesic::PathToSource> paths =
    geodesic::pathsToSource(surface.mesh(), execution.sources().curves, targets.places, options);
  execution.reach(PathsFound);

  execution.enter(geodesic::Stage::WritingOutputs);
  const auto isFound = [](const geodesic::PathToSource& path) { return !path.points.empty(); };
  const auto found = static_cast<std::size_t>(std::count_if(paths.begin(), paths.end(), isFound));
  NoteUnreached(execution, targets.count - found);
  geodesic::writePaths(surface.mesh(), surface.scale(), targets, paths, output,
    execution.progressBetween(PathsFound, 1.0));
}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
