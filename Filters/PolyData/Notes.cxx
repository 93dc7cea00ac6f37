// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/Notes.h"

#include "PolyData/PolyDataSource.h"
#include "PolyData/PolyDataSurface.h"
#include "mesh/SurfaceSnap.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"

#include <cmath>
#include <iterator>
#include <sstream>

namespace geodesic
{

namespace
{

// A source farther from the surface than this fraction of the diagonal of its bounding box was
// hardly meant for it: the user is told. What comes from sections, resampled curves and clicks on
// the surface is much closer.
constexpr double FarSourceFraction = 0.01;

// Enough to find the others by.
constexpr std::size_t PointsNamed = 3;

/// "point 3 of cell 2", as the message has named the source.
std::string shortNameOfPoint(const LocatedPolyline& line, std::size_t point)
{
  const std::string name = nameOfPoint(line, point);
  return name.substr(0, name.rfind(" of the source"));
}

/// The points of a source that are farther from the surface than they should be.
struct FarPoints
{
  std::size_t count = 0;
  std::size_t ofAll = 0;
  /// The first ones, as a list.
  std::string names;
};

FarPoints farPointsOf(
  const TriangleMesh& mesh, const std::vector<LocatedPolyline>& polylines, double limit)
{
  FarPoints far;
  const double precision = SnapOptions().coordinatePrecision;
  for (const LocatedPolyline& line : polylines)
  {
    far.ofAll += line.points.size();
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      // All of its faces are equally close.
      if (snapToFace(mesh, line.faces[i].front(), line.points[i], precision).distance <= limit)
      {
        continue;
      }
      if (far.count++ < PointsNamed)
      {
        far.names += (far.names.empty() ? "" : ", ") + shortNameOfPoint(line, i);
      }
    }
  }
  if (far.count > PointsNamed)
  {
    far.names += " and " + std::to_string(far.count - PointsNamed) + " more";
  }
  return far;
}

}

void GivenNotes::forgetNewInputs(vtkAlgorithm* filter)
{
  const int ports = filter->GetNumberOfInputPorts();
  this->connections_.resize(static_cast<std::size_t>(ports));
  for (int port = 0; port < ports; ++port)
  {
    vtkAlgorithmOutput* now =
      filter->GetNumberOfInputConnections(port) > 0 ? filter->GetInputConnection(port, 0) : nullptr;
    vtkWeakPointer<vtkAlgorithmOutput>& before = this->connections_[static_cast<std::size_t>(port)];
    if (now == before)
    {
      continue;
    }
    before = now;
    for (auto note = this->given_.begin(); note != this->given_.end();)
    {
      note = static_cast<int>(note->first) == port ? this->given_.erase(note) : std::next(note);
    }
  }
}

std::string GivenNotes::take(const Notes& notes, vtkAlgorithm* filter)
{
  this->forgetNewInputs(filter);
  std::set<std::pair<NoteOn, std::string>> now;
  std::string text;
  for (const Notes::Note& note : notes.all())
  {
    now.emplace(note.input, note.cause);
    if (this->given_.count({ note.input, note.cause }) == 0)
    {
      text += (text.empty() ? "" : "\n") + note.text;
    }
  }
  this->given_ = std::move(now);
  return text;
}

void noteSurface(const PolyDataSurface& surface, Notes& notes)
{
  const PolyDataSurface::Report& read = surface.report();
  notes.add(
    NoteOn::Surface, read.droppedLineCells, "line", "lines", "among the surface's cells dropped.");
  notes.add(NoteOn::Surface, read.droppedVertexCells, "vertex cell", "vertex cells",
    "among the surface's cells dropped.");
  notes.add(NoteOn::Surface, read.facesWithRepeatedPoint, "face", "faces",
    "with two corners at one point left out.");
}

void noteSource(const PolyDataSurface& surface, const TriangleMesh& mesh,
  const SourcePolylines& source, const SourceCurves& onSurface, Notes& notes)
{
  const double limit = FarSourceFraction * surface.diagonal();
  if (!(onSurface.snapDistance > limit))
  {
    return;
  }
  const FarPoints far = farPointsOf(mesh, source.polylines, limit);
  std::ostringstream text;
  text << "The source is up to " << surface.scale().toUser(onSurface.snapDistance)
       << " away from the surface";
  if (surface.diagonal() > 0.0)
  {
    text << " (" << std::round(100.0 * onSurface.snapDistance / surface.diagonal())
         << " % of its size)";
  }
  text << ", at " << far.count << " of " << far.ofAll << " points: " << far.names
       << ". Does it belong to this surface? It was put onto the surface's closest points.";
  notes.addFirst(NoteOn::Source, "far", text.str());
}

}
