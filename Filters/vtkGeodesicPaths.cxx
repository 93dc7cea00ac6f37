// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicPaths.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/ParallelFor.h"
#include "PolyData/writing/PathWriter.h"
#include "PolyData/writing/SourceArrays.h"
#include "paths/PathsToSource.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

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

std::vector<geodesic::Vec3> PlacesOf(
  const geodesic::TriangleMesh& mesh, const std::vector<geodesic::SurfacePoint>& points)
{
  std::vector<geodesic::Vec3> places;
  places.reserve(points.size());
  for (const geodesic::SurfacePoint& point : points)
  {
    places.push_back(geodesic::position(mesh, point));
  }
  return places;
}

/// Finds the paths of all targets; where the surface is in pieces, of those in this rank's piece.
std::vector<geodesic::PathOfTarget> FindPaths(geodesic::FilterExecution& execution)
{
  const geodesic::Targets targets = execution.readTargets(TargetsRead);
  execution.enter(geodesic::Stage::ComputingDistances);
  const geodesic::PolyDataSurface& surface = execution.surface();
  geodesic::PathsOptions options;
  options.parallelFor = geodesic::smpParallelFor();
  options.progress = execution.progressBetween(TargetsRead, PathsFound);
  std::vector<geodesic::PathOfTarget> paths(targets.places.size());
  geodesic::pathsToSource(surface.partition(), execution.patch(), execution.sources().curves,
    targets.places, options,
    [&](std::size_t i, const geodesic::PathToSource& path)
    {
      paths[i] = { targets.numbers[i], targets.snapDistances[i], PlacesOf(path.mesh, path.points),
        path.end };
    });
  paths.erase(std::remove_if(paths.begin(), paths.end(),
                [](const geodesic::PathOfTarget& path) { return path.points.empty(); }),
    paths.end());
  execution.reach(PathsFound);
  NoteUnreached(execution, targets.count - execution.sumOverPieces(paths.size()));
  return paths;
}

std::vector<geodesic::SourceFrame> FramesOf(const geodesic::FilterExecution& execution)
{
  const std::vector<geodesic::SourceCurve>& curves = execution.sources().curves;
  const geodesic::PathEnds ends(execution.patch(), curves);
  return geodesic::framesBySource(
    curves, [&ends](geodesic::Id curve) { return ends.frameOf(curve); });
}

void PutPath(geodesic::Message& message, const geodesic::PathOfTarget& path)
{
  geodesic::put(message, path.target);
  geodesic::put(message, path.snapDistance);
  geodesic::put(message, path.end);
  geodesic::putAll(message, path.points);
}

geodesic::PathOfTarget GetPath(geodesic::MessageReader& reader)
{
  geodesic::PathOfTarget path;
  path.target = reader.get<std::size_t>();
  path.snapDistance = reader.get<double>();
  path.end = reader.get<geodesic::PathEnd>();
  path.points = reader.getAll<geodesic::Vec3>();
  return path;
}

/// Sends every path to the rank whose input had its target. All ranks call this together.
///
/// \param paths found here.
/// \returns those of this rank's targets, in their order.
std::vector<geodesic::PathOfTarget> SendHome(
  const geodesic::FilterExecution& execution, std::vector<geodesic::PathOfTarget> paths)
{
  geodesic::Exchange& exchange = execution.exchange();
  const bool areFoundByAll = execution.surfacePlace() == geodesic::SurfacePlace::OnEveryRank;
  std::vector<geodesic::Message> messages = exchange.noMessages();
  for (geodesic::PathOfTarget& found : paths)
  {
    const geodesic::PathOfTarget path = std::move(found); // freed path by path
    const int home = execution.rankOfTarget(path.target);
    if (!areFoundByAll || home == exchange.rank())
    {
      PutPath(messages[geodesic::rankIndex(home)], path);
    }
  }
  paths.clear();
  geodesic::readEach(exchange.step(std::move(messages)),
    [&](int, geodesic::MessageReader& reader) { paths.push_back(GetPath(reader)); });
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
void vtkGeodesicPaths::Compute(
  geodesic::FilterExecution& execution, vtkInformationVector* outputVector)
{
  execution.requireTargets();
  execution.readInputs(true);
  std::vector<geodesic::PathOfTarget> paths;
  std::vector<geodesic::SourceFrame> frames;
  geodesic::PowerOfTwoScale scale;
  if (execution.surfacePlace() != geodesic::SurfacePlace::OnOtherRank)
  {
    paths = FindPaths(execution);
    frames = this->GenerateSourceAngle ? FramesOf(execution) : frames;
    scale = execution.surface().scale();
  }
  if (execution.exchange().numberOfRanks() > 1)
  {
    execution.shareResult(scale);
    paths = SendHome(execution, std::move(paths));
  }
  if (this->GenerateSourceAngle)
  {
    execution.shareResults(frames);
    geodesic::addSourceFrames(frames, vtkPolyData::GetData(outputVector, 0));
  }
  execution.enter(geodesic::Stage::WritingOutputs);
  geodesic::writePaths(scale, paths, { this->GenerateSourceArcLength, this->GenerateSourceAngle },
    vtkPolyData::GetData(outputVector, 0), execution.progressBetween(PathsFound, 1.0));
}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool value) { return value ? "On" : "Off"; };
  os << indent << "GenerateSourceArcLength: " << onOff(this->GenerateSourceArcLength) << "\n";
  os << indent << "GenerateSourceAngle: " << onOff(this->GenerateSourceAngle) << "\n";
}
