// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicPaths.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/ParallelFor.h"
#include "PolyData/PathWriter.h"
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
  execution.readInputs(geodesic::FilterExecution::Pieces::Refused);
  if (execution.surfacePlace() == geodesic::SurfacePlace::Elsewhere)
  {
    return;
  }
  const geodesic::Targets targets = execution.readTargets(TargetsRead);

  execution.enter(geodesic::Stage::ComputingDistances);
  const geodesic::PolyDataSurface& surface = execution.surface();
  geodesic::PathsOptions options;
  options.parallelFor = geodesic::smpParallelFor();
  options.progress = execution.progressBetween(TargetsRead, PathsFound);
  const std::vector<geodesic::PathToSource> paths =
    geodesic::pathsToSource(surface.mesh(), execution.sources().curves, targets.places, options);
  execution.reach(PathsFound);

  execution.enter(geodesic::Stage::WritingOutputs);
  const auto isFound = [](const geodesic::PathToSource& path) { return !path.points.empty(); };
  const auto found = static_cast<std::size_t>(std::count_if(paths.begin(), paths.end(), isFound));
  execution.notes().add(geodesic::NoteOn::Targets, targets.count - found, "target", "targets",
    "not reached: no path on the surface leads from there to the source.");
  geodesic::writePaths(surface.mesh(), surface.scale(), targets, paths,
    vtkPolyData::GetData(outputVector, 0), execution.progressBetween(PathsFound, 1.0));
}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
