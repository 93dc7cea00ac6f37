// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicPaths.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/Inputs.h"
#include "PolyData/ranks/SharedResults.h"
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
void FindCells(const Inputs& inputs, const std::vector<std::vector<RankAddress>>& faces,
  std::vector<PathOfTarget>& paths)
{
  std::vector<RankAddress> all;
  for (const std::vector<RankAddress>& some : faces)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  const std::vector<vtkIdType> cells = inputs.surface->inputCellsOf(all);
  auto next = cells.begin();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto begin = std::exchange(next, next + static_cast<std::ptrdiff_t>(faces[i].size()));
    paths[i].cells.assign(begin, next);
  }
}

/// Finds the paths of all targets; where the surface is in pieces, of those in this rank's piece.
std::vector<PathOfTarget> FindPaths(
  const Inputs& inputs, bool withCells, FilterExecution& execution)
{
  const Targets& targets = inputs.targets;
  std::vector<PathOfTarget> paths(targets.places.size());
  std::vector<std::vector<RankAddress>> faces(withCells ? paths.size() : 0);
  const std::vector<vtkIdType>& ids = inputs.sources.ids;
  pathsToSource(inputs.surface->partition, *inputs.patch, inputs.sources.curves, targets.places,
    execution.begin(Stage::SolveForTargets),
    [&](const PathToSource& path)
    {
      const Id i = path.target;
      paths[i] = { targets.numbers[i], targets.snapDistances[i], {}, path.end,
        path.end.source == NoId ? -1 : ids[path.end.source], {} };
      paths[i].points.reserve(path.points.size());
      for (const SurfacePoint& point : path.points)
      {
        paths[i].points.push_back(position(path.mesh(), point));
      }
      for (std::size_t point = 0; withCells && point + 1 < path.points.size(); ++point)
      {
        faces[i].push_back(path.faceAfter(point));
      }
    });
  if (withCells)
  {
    FindCells(inputs, faces, paths);
  }
  paths.erase(std::remove_if(paths.begin(), paths.end(),
                [](const PathOfTarget& path) { return path.points.empty(); }),
    paths.end());
  execution.notes().add(NoteOn::Targets, targets.count - inputs.sumOverPieces(paths.size()),
    "target", "targets", "not reached: no path on the surface leads from there to the source.");
  return paths;
}

/// Sends every path to the rank whose input had its target. All ranks call this together.
///
/// \param paths found here.
/// \returns those of this rank's targets, in their order.
std::vector<PathOfTarget> SendHome(
  const Inputs& inputs, std::vector<PathOfTarget> paths, Exchange& exchange)
{
  const bool areFoundByAll = inputs.rank.surface == SurfacePlace::OnEveryRank;
  std::vector<Message> messages = exchange.noMessages();
  for (PathOfTarget& found : paths)
  {
    const PathOfTarget path = std::move(found); // freed path by path
    const int home = inputs.targetBlocks.rankOfPoint(path.target);
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
ExecutionPlan vtkGeodesicPaths::Plan() const
{
  ExecutionPlan plan;
  plan.stages = { Stage::SolveForTargets, Stage::Write };
  plan.targets = TargetPoints::OfTargets;
  return plan;
}

//------------------------------------------------------------------------------
void vtkGeodesicPaths::Compute(
  const Inputs& inputs, FilterExecution& execution, vtkInformationVector* outputVector)
{
  Exchange& exchange = execution.exchange();
  const bool isWorking = inputs.rank.isWorking();
  std::vector<PathOfTarget> paths;
  SourceFrames frames;
  PowerOfTwoScale scale = inputs.surface->scale;
  if (isWorking)
  {
    paths = FindPaths(inputs, this->GenerateFaceIds, execution);
    if (this->GenerateSourceAngle)
    {
      frames = framesBySource(CurvesOnPatch(*inputs.patch, inputs.sources.curves), inputs.sources);
    }
  }
  if (exchange.numberOfRanks() > 1)
  {
    shareResults(exchange, isWorking, scale);
    paths = SendHome(inputs, std::move(paths), exchange);
  }
  if (this->GenerateSourceAngle)
  {
    shareResults(exchange, isWorking, frames.frames);
    shareResults(exchange, isWorking, frames.ids);
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
