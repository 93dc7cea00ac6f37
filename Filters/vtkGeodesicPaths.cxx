// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicPaths.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/writing/CellsOfFaces.h"
#include "PolyData/writing/LineWriter.h"
#include "PolyData/writing/SourceArrays.h"
#include "paths/PathsToSource.h"
#include "source/CurvesOnPatch.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

using namespace geodesic;

vtkStandardNewMacro(vtkGeodesicPaths);

namespace
{

/// Gives paths the cells of their faces.
///
/// \param faces of each path.
void FindCells(const FilterExecution& execution, const std::vector<std::vector<RankAddress>>& faces,
  std::vector<PathOfTarget>& paths)
{
  std::vector<RankAddress> all;
  for (const std::vector<RankAddress>& some : faces)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  const std::vector<vtkIdType> cells =
    cellsOfFaces(execution.surface(), execution.surfaceBlocks(), all);
  auto next = cells.begin();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto begin = std::exchange(next, next + static_cast<std::ptrdiff_t>(faces[i].size()));
    paths[i].cells.assign(begin, next);
  }
}

/// Finds the paths of all targets; where the surface is in pieces, of those in this rank's piece.
std::vector<PathOfTarget> FindPaths(FilterExecution& execution, bool withCells)
{
  const Targets targets = execution.readTargets();
  const PolyDataSurface& surface = execution.surface();
  std::vector<PathOfTarget> paths(targets.places.size());
  std::vector<std::vector<RankAddress>> faces(withCells ? paths.size() : 0);
  const std::vector<vtkIdType>& ids = execution.sourceIds();
  pathsToSource(surface.partition, execution.patch(), execution.sources().curves, targets.places,
    execution.begin(Stage::SolveForTargets),
    [&](std::size_t i, const PathToSource& path)
    {
      paths[i] = { targets.numbers[i], targets.snapDistances[i], {}, path.end,
        path.end.source == NoId ? -1 : ids[path.end.source], {} };
      paths[i].points.reserve(path.points.size());
      for (const SurfacePoint& point : path.points)
      {
        paths[i].points.push_back(position(path.mesh, point));
      }
      for (std::size_t point = 0; withCells && point + 1 < path.points.size(); ++point)
      {
        faces[i].push_back(path.faceAfter(point));
      }
    });
  if (withCells)
  {
    FindCells(execution, faces, paths);
  }
  paths.erase(std::remove_if(paths.begin(), paths.end(),
                [](const PathOfTarget& path) { return path.points.empty(); }),
    paths.end());
  execution.notes().add(NoteOn::Targets, targets.count - execution.sumOverPieces(paths.size()),
    "target", "targets", "not reached: no path on the surface leads from there to the source.");
  return paths;
}

/// Sends every path to the rank whose input had its target. All ranks call this together.
///
/// \param paths found here.
/// \returns those of this rank's targets, in their order.
std::vector<PathOfTarget> SendHome(
  const FilterExecution& execution, std::vector<PathOfTarget> paths)
{
  Exchange& exchange = execution.exchange();
  const bool areFoundByAll = execution.surfacePlace() == SurfacePlace::OnEveryRank;
  std::vector<Message> messages = exchange.noMessages();
  for (PathOfTarget& found : paths)
  {
    const PathOfTarget path = std::move(found); // freed path by path
    const int home = execution.rankOfTarget(path.target);
    if (!areFoundByAll || home == exchange.rank())
    {
      Message& message = messages[rankIndex(home)];
      put(message, path.target);
      put(message, path.snapDistance);
      putAll(message, path.points);
      put(message, path.end);
      put(message, path.sourceId);
      putAll(message, path.cells);
    }
  }
  paths.clear();
  readEach(exchange.step(std::move(messages)),
    [&](int, MessageReader& reader)
    {
      paths.push_back({ reader.get<std::size_t>(), reader.get<double>(), reader.getAll<Vec3>(),
        reader.get<PathEnd>(), reader.get<vtkIdType>(), reader.getAll<vtkIdType>() });
    });
  std::sort(paths.begin(), paths.end(),
    [](const PathOfTarget& a, const PathOfTarget& b) { return a.target < b.target; });
  return paths;
}

}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::Compute(FilterExecution& execution, vtkInformationVector* outputVector)
{
  execution.requireTargets();
  execution.readInputs({ Stage::ReadTargets, Stage::SolveForTargets, Stage::Write }, true);
  std::vector<PathOfTarget> paths;
  SourceFrames frames;
  PowerOfTwoScale scale;
  if (execution.surfacePlace() != SurfacePlace::OnOtherRank)
  {
    paths = FindPaths(execution, this->GenerateFaceIds);
    if (this->GenerateSourceAngle)
    {
      const std::vector<SourceCurve>& curves = execution.sources().curves;
      frames = framesBySource(CurvesOnPatch(execution.patch(), curves), curves,
        execution.sourceIds(), execution.areSourcesNamed());
    }
    scale = execution.surface().scale;
  }
  if (execution.exchange().numberOfRanks() > 1)
  {
    execution.shareResults(scale);
    paths = SendHome(execution, std::move(paths));
  }
  if (this->GenerateSourceAngle)
  {
    execution.shareResults(frames.frames);
    execution.shareResults(frames.ids);
    addSourceFrames(frames, vtkPolyData::GetData(outputVector, 0));
  }
  writePaths(scale, paths,
    { this->GenerateSourceArcLength, this->GenerateSourceAngle, this->GenerateFaceIds },
    vtkPolyData::GetData(outputVector, 0), execution.begin(Stage::Write));
}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool value) { return value ? "On" : "Off"; };
  os << indent << "GenerateSourceArcLength: " << onOff(this->GenerateSourceArcLength) << "\n";
  os << indent << "GenerateSourceAngle: " << onOff(this->GenerateSourceAngle) << "\n";
  os << indent << "GenerateFaceIds: " << onOff(this->GenerateFaceIds) << "\n";
}
