// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/Notes.h"

#include "PolyData/PolyDataSurface.h"
#include "source/PolylineOnSurface.h"

namespace geodesic
{

namespace
{

// A source farther from the surface than this fraction of the diagonal of its bounding box was
// hardly meant for it: the user is told.
constexpr double FarSourceFraction = 0.01;

}

void noteSurface(const PolyDataSurface& surface, Notes& notes)
{
  const PolyDataSurface::Report& read = surface.report();
  notes.add(read.polygons, "polygon", "polygons", "of the surface triangulated.");
  notes.add(read.strips, "triangle strip", "triangle strips", "of the surface triangulated.");
  notes.add(read.droppedLineCells, "line", "lines", "among the surface's cells dropped.");
  notes.add(
    read.droppedVertexCells, "vertex cell", "vertex cells", "among the surface's cells dropped.");
  notes.add(
    read.facesWithRepeatedPoint, "face", "faces", "with two corners at one point left out.");
  notes.add(read.duplicateFaces, "duplicate face", "duplicate faces",
    "(on the points of another face), without effect on the distance.");
  notes.add(read.zeroAreaFaces, "face", "faces", "without area, kept.");
  notes.add(read.isolatedPoints, "point", "points",
    "of the surface used by no face: infinitely far.");
}

void noteSource(
  const PolyDataSurface& surface, const SourceCurves& sources, bool isShown, Notes& notes)
{
  notes.add(sources.repeatedPoints, "point", "points",
    "of the source at the place of the one before, left out.");
  if (sources.snapDistance > FarSourceFraction * surface.diagonal())
  {
    std::ostringstream sentence;
    sentence << "The source is up to " << surface.scale().toUser(sources.snapDistance)
             << " away from the surface; it was put onto the surface's closest points."
             << (isShown ? " See output port 1 for the result." : "");
    notes.add(sentence.str());
  }
}

}
