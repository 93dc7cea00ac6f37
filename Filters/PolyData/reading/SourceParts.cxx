// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SourceParts.h"

#include "PolyData/reading/CoveredFaces.h"
#include "PolyData/reading/LineChains.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/SourceFaces.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace geodesic
{

namespace
{

std::string textOfEmpty(const PartsRequest& from, vtkIdType droppedCells)
{
  if (from.targets)
  {
    return from.targets->atBeginning() +
      " has no target: no point, line or flat face has a value of at least 0 in the array of "
      "TargetIdArrayName. Negative values stand for none.";
  }
  if (droppedCells > 0)
  {
    return "The source (input port 1) has no vertex, line or flat face with points among its " +
      std::to_string(droppedCells) +
      " cells. Apply Extract Surface to it for its faces, Feature Edges after that for its edges, "
      "or take some of its points by Extract Selection.";
  }
  return "The source (input port 1) is empty: it has no points that a line or vertex uses. Connect "
         "a curve with at least one point, or set Source Type to Surface Boundary.";
}

/// The numbers of cells that have a polyline, as all regions have, or no points, ascending.
std::vector<vtkIdType> numbersLeft(const SourceCells& cells)
{
  std::vector<vtkIdType> numbers = cells.withoutPoints;
  std::transform(cells.polylines.begin(), cells.polylines.end(), std::back_inserter(numbers),
    [](const LocatedPolyline& line) { return static_cast<vtkIdType>(line.source); });
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Joins lines of one value, or all, to curves.
void joinLines(SourceCells& cells)
{
  std::vector<vtkIdType> values;
  for (const std::size_t line : cells.lines)
  {
    values.push_back(cells.values.empty() ? 0 : cells.valueOf(cells.polylines[line].source));
  }
  joinLines(cells.polylines, cells.lines, values);
}

/// Makes one part of the cells of one value.
PartIds makeParts(SourceCells& cells)
{
  PartIds parts;
  std::vector<vtkIdType>& ids = parts.ids;
  std::transform(cells.numbers.begin(), cells.numbers.end(), std::back_inserter(ids),
    [&cells](vtkIdType number) { return cells.valueOf(number); });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  parts.areNamed = !cells.values.empty();
  parts.idEnd = parts.areNamed ? ids.back() + 1 : cells.end;
  const auto placeOf = [&](vtkIdType number)
  { return std::lower_bound(ids.begin(), ids.end(), cells.valueOf(number)) - ids.begin(); };
  for (LocatedPolyline& line : cells.polylines)
  {
    line.source = static_cast<Id>(placeOf(line.source));
  }
  for (SourceFace& face : cells.faces)
  {
    face.outline.source = static_cast<Id>(placeOf(face.outline.source));
  }
  parts.names.resize(cells.names.empty() ? 0 : ids.size());
  for (auto i = cells.numbers.rbegin(); !cells.names.empty() && i != cells.numbers.rend(); ++i)
  {
    parts.names[static_cast<std::size_t>(placeOf(*i))] = cells.names[static_cast<std::size_t>(*i)];
  }
  return parts;
}

/// Leaves out the single points that lie in a barrier.
void leaveOutPointsInBarriers(const std::vector<RankAddress>& barriers, SourceCells& read)
{
  std::vector<bool> isRegion(read.parts.ids.size(), false); // a point may stand for all of one
  for (const SourceFace& face : read.faces)
  {
    isRegion[face.outline.source] = true;
  }
  const auto isOut = [&](const LocatedPolyline& line)
  {
    return line.points.size() == 1 && !isRegion[line.source] &&
      barriers[read.located.indexOf(line.points.front())].id != NoId;
  };
  std::vector<LocatedPolyline>& lines = read.polylines;
  lines.erase(std::remove_if(lines.begin(), lines.end(), isOut), lines.end());
}

/// "cell 17 of the surface (input port 0)", as the rank of a barrier calls it. All ranks call this
/// together.
std::string nameOfBarrier(const PartsRequest& from, const RankAddress& face)
{
  const PolyDataSurface& surface = from.surface;
  Exchange& exchange = surface.exchange();
  const std::string own =
    face.rank == exchange.rank() ? surface.nameOfCell(surface.triangleOfBarrier(face.id)) : "";
  const std::vector<char> told = valuesOfRanks(exchange, std::vector<char>(own.begin(), own.end()));
  const std::string name(told.begin(), told.end());
  return surface.partition.isDistributed() ? name + " on rank " + std::to_string(face.rank) : name;
}

/// \throws InputError that names the polyline, the point and the cell of the surface.
void requireOutsideBarriers(
  const PartsRequest& from, const SourceCells& read, const std::vector<RankAddress>& barriers)
{
  for (const LocatedPolyline& line : read.polylines)
  {
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      const RankAddress& face = barriers[read.located.indexOf(line.points[i])];
      if (face.id != NoId)
      {
        const Vec3 place = from.surface.scale.toUser(line.points[i]);
        std::ostringstream text;
        text << line.nameOfPoint(i).atBeginning() << ", at (" << place[0] << ", " << place[1]
             << ", " << place[2] << "), lies in a barrier (BarrierArrayName): it is closest to "
             << nameOfBarrier(from, face)
             << ", which no path may leave. Move it out of the barrier, or onto its rim.";
        throw InputError(text.str());
      }
    }
  }
}

void locate(const PartsRequest& from, const Job& job, SourceCells& read)
{
  constexpr double sought = 0.9;
  LocatedPlaces& located = read.located;
  located = from.locator.locate(read.polylines, read.precision, job.part(0.0, sought));
  if (from.surface.barriers)
  {
    const std::vector<RankAddress> barriers =
      from.surface.barriers->barriersAt(located.places, located.faces, read.precision);
    if (from.targets)
    {
      leaveOutPointsInBarriers(barriers, read);
    }
    requireOutsideBarriers(from, read, barriers);
  }
  from.locator.keepOnOneSide(read.polylines, read.precision, located, job.part(sought, 1.0));
}

}

SourceCells readParts(const PartsRequest& from, const Job& job)
{
  SourceCells read = readSourceCells(from.blocks, from.surface, from.targets != nullptr);
  if (read.isEmpty())
  {
    throw InputError(textOfEmpty(from, read.droppedCells));
  }
  cutAtFacesWithoutArea(read.faces);
  const double facesLocated = from.surface.barriers && !from.targets ? 0.2 : 0.0;
  if (!read.faces.empty())
  {
    placeFaces(from, job.part(0.0, facesLocated), read);
  }
  if (from.areLinesJoined)
  {
    joinLines(read);
  }
  const bool areJoined = from.areLinesJoined && read.values.empty();
  makeRegions(read, areJoined);
  if (areJoined)
  {
    read.numbers = numbersLeft(read);
  }
  read.parts = makeParts(read);
  locate(from, job.part(facesLocated, 1.0), read);
  return read;
}

}
