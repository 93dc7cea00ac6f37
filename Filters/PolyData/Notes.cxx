// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/Notes.h"

#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/SourceParts.h"
#include "PolyData/reading/Targets.h"
#include "mesh/SurfaceSnap.h"
#include "source/OpposedCurves.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace geodesic
{

namespace
{

// Points, or segments; enough to find the others by.
constexpr std::size_t PointsNamed = 3;

/// The points of an input that are farther from the surface than they should be.
struct FarPoints
{
  std::size_t count = 0;
  std::size_t ofAll = 0;
  /// The first ones, without the input, which the message has named.
  std::vector<std::string> names;
  /// On the mesh's scale.
  double largestDistance = 0.0;
};

double farLimit(const PolyDataSurface& surface)
{
  return FarFraction * surface.diagonal;
}

FarPoints farPointsOf(
  const TriangleMesh& mesh, const std::vector<LocatedPolyline>& polylines, double limit)
{
  FarPoints far;
  constexpr double precision = std::numeric_limits<double>::epsilon();
  for (const LocatedPolyline& line : polylines)
  {
    far.ofAll += line.points.size();
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      // All of its faces are equally close.
      const double distance =
        snapToFace(mesh, line.faces[i].front(), line.points[i], precision).distance;
      if (distance <= limit)
      {
        continue;
      }
      far.largestDistance = std::max(far.largestDistance, distance);
      if (far.count++ < PointsNamed)
      {
        far.names.push_back(line.nameOfPoint(i).withoutInput());
      }
    }
  }
  return far;
}

/// "2 segments of the source run over another: segment 3 of cell 0, segment 8 of cell 0. Leave ..."
///
/// \param one, many what one segment does, or several.
void noteSegments(const char* cause, const SourceCells& source,
  const std::vector<SegmentOfPolyline>& segments, const std::string& one, const std::string& many,
  const std::string& advice, Notes& notes)
{
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(segments.size(), PointsNamed); ++i)
  {
    names.push_back(source.polylines[segments[i].polyline].nameOfSegment(segments[i].segment));
  }
  const std::string text =
    (segments.size() == 1 ? " segment of the source " + one : " segments of the source " + many);
  if (!segments.empty())
  {
    notes.add(NoteOn::Source, cause,
      std::to_string(segments.size()) + text + ": " + listFirst(names, segments.size()) + ". " +
        advice);
  }
}

void noteDetours(const SourceCells& source, const SourceCurves& onSurface, Notes& notes)
{
  std::ostringstream longer;
  longer << " several times as long on the surface as straight (up to " << std::setprecision(2)
         << onSurface.largestDetour << " times)";
  noteSegments("detours", source, onSurface.detours, "is" + longer.str(), "are" + longer.str(),
    "If no detour is meant, the curve goes to another side of the surface there: move its points "
    "closer to the side that it belongs to, or add points.",
    notes);
}

/// "point 3 of block 2 (wing)" of targets, by its number over all blocks.
std::string nameOfTarget(const std::vector<PolyDataBlock>& blocks, std::size_t number)
{
  auto block = blocks.begin();
  auto point = static_cast<vtkIdType>(number);
  for (; point >= block->data->GetNumberOfPoints(); ++block)
  {
    point -= block->data->GetNumberOfPoints();
  }
  return block->name.part("point", point).withoutInput();
}

/// "The source is", or what the subject is else, and how far it is away.
std::string farText(
  const std::string& subject, const FarPoints& far, const PolyDataSurface& surface)
{
  std::ostringstream text;
  text << subject << " up to " << surface.scale.toUser(far.largestDistance)
       << " away from the surface";
  if (surface.diagonal > 0.0)
  {
    text << " (" << std::round(100.0 * far.largestDistance / surface.diagonal) << " % of its size)";
  }
  text << ", at " << far.count << " of " << far.ofAll
       << " points: " << listFirst(far.names, far.count);
  return text.str();
}

void noteFarTargets(
  const FarPoints& far, const PolyDataSurface& surface, NoteOn input, Notes& notes)
{
  notes.add(input, FarNote,
    farText("The targets are", far, surface) +
      ". Do they belong to this surface? They were put onto the surface's closest points.");
}

}

bool Notes::has(NoteOn input, const std::string& cause) const
{
  return std::any_of(this->all.begin(), this->all.end(),
    [&](const Note& note) { return note.input == input && note.cause == cause; });
}

std::string GivenNotes::take(const Notes& notes, vtkAlgorithm* filter)
{
  std::vector<Given> now;
  std::string text;
  for (const Notes::Note& note : notes.all)
  {
    const int port = static_cast<int>(note.input);
    vtkAlgorithmOutput* connection =
      filter->GetNumberOfInputConnections(port) > 0 ? filter->GetInputConnection(port, 0) : nullptr;
    now.emplace_back(note.input, note.cause, connection);
    if (std::find(this->given_.begin(), this->given_.end(), now.back()) == this->given_.end())
    {
      text += (text.empty() ? "" : "\n") + note.text;
    }
  }
  this->given_ = std::move(now);
  return text;
}

void noteSurface(const PolyDataSurface& surface, Notes& notes)
{
  const SurfaceReport& read = surface.report;
  notes.add(
    NoteOn::Surface, read.droppedLineCells, "line", "lines", "among the surface's cells dropped.");
  notes.add(NoteOn::Surface, read.droppedVertexCells, "vertex cell", "vertex cells",
    "among the surface's cells dropped.");
  notes.add(NoteOn::Surface, read.facesWithRepeatedPoint, "face", "faces",
    "with two corners at one point left out.");
  if (read.crossingOutlines > 0)
  {
    std::string text = std::to_string(read.crossingOutlines) +
      (read.crossingOutlines == 1 ? " polygon" : " polygons") +
      " of the surface with an outline that crosses itself";
    if (read.cellOfFirstCrossing >= 0)
    {
      text += ", first " +
        surface.blocks[read.blockOfFirstCrossing]
          .name.part("cell", read.cellOfFirstCrossing)
          .withoutInput();
    }
    notes.add(NoteOn::Surface, "crossing outlines",
      text +
        ": cut into triangles that overlap, so that distances there are too short or too long. "
        "Repair the polygons upstream.");
  }
  if (read.crackEdges > 0)
  {
    std::ostringstream text;
    text
      << read.crackEdges << " boundary edges of the surface lie beside others, at most "
      << surface.scale.toUser(read.crackWidth)
      << " apart, and are not joined: paths go around these cracks. If they are not meant to be "
         "slits, set MergeTolerance to more than that; where points of one side have no partners "
         "on the other, repair the mesh upstream.";
    notes.add(NoteOn::Surface, "cracks", text.str());
  }
}

void noteSource(const PolyDataSurface& surface, const TriangleMesh& mesh, const SourceCells& source,
  const SourceCurves& onSurface, double beyond, Notes& notes)
{
  notes.add(NoteOn::Source, source.droppedCells, "cell", "cells",
    "of the source left out: neither vertices, lines nor flat faces.");
  noteDetours(source, onSurface, notes);
  if (!(onSurface.snapDistance > beyond * surface.diagonal))
  {
    return;
  }
  FarPoints far = farPointsOf(mesh, source.polylines, farLimit(surface));
  far.largestDistance = onSurface.snapDistance;
  // Before all others.
  notes.all.insert(notes.all.begin(),
    { NoteOn::Source, FarNote,
      farText("The source is", far, surface) +
        ". Does it belong to this surface? It was put onto the surface's closest points." });
}

void noteSides(
  const TriangleMesh& mesh, const SourceCells& source, const SourceCurves& onSurface, Notes& notes)
{
  std::vector<SegmentOfPolyline> segments;
  for (const SegmentOfCurve& at : opposedSegments(mesh, onSurface.curves))
  {
    const SegmentOfPolyline& given = onSurface.given[at.curve][at.segment];
    if (segments.empty() || segments.back().polyline != given.polyline ||
      segments.back().segment != given.segment)
    {
      segments.push_back(given);
    }
  }
  const std::string over = " over another in the opposite direction";
  noteSegments("opposed curves", source, segments, "runs" + over, "run" + over,
    "Signs need one direction: what is left of one is right of the other, and rounding decides the "
    "sign there. Leave one of them out.",
    notes);
}

void noteTargets(const PolyDataSurface& surface, const std::vector<PolyDataBlock>& blocks,
  const Targets& targets, NoteOn input, Notes& notes)
{
  FarPoints far;
  far.ofAll = targets.count;
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < targets.numbers.size(); ++i)
  {
    if (targets.snapDistances[i] > farLimit(surface))
    {
      far.largestDistance = std::max(far.largestDistance, targets.snapDistances[i]);
      if (far.count++ < PointsNamed)
      {
        own.push_back(targets.numbers[i]);
      }
    }
  }
  Exchange& exchange = surface.exchange();
  far.count = static_cast<std::size_t>(sumOverRanks(exchange, far.count).all);
  far.largestDistance = exchange.largestOf(far.largestDistance);
  std::vector<std::size_t> numbers = valuesOfRanks(exchange, own);
  if (far.count == 0)
  {
    return;
  }
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 0; i < std::min(numbers.size(), PointsNamed); ++i)
  {
    far.names.push_back(nameOfTarget(blocks, numbers[i]));
  }
  noteFarTargets(far, surface, input, notes);
}

void noteTargetSets(const PolyDataSurface& surface, const TriangleMesh& mesh,
  const SourceCells& targets, NoteOn input, Notes& notes)
{
  notes.add(input, targets.droppedCells, "cell", "cells",
    "of the targets left out: neither vertices, lines nor flat faces.");
  const FarPoints far = farPointsOf(mesh, targets.polylines, farLimit(surface));
  if (far.count > 0 && !notes.has(NoteOn::Source, FarNote))
  {
    noteFarTargets(far, surface, input, notes);
  }
}

}
