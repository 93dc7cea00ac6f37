// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolyDataSource_h
#define geodesic_PolyDataSource_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/PowerOfTwoScale.h"
#include "source/PolylineLocator.h"

#include "vtkType.h"

#include <string>
#include <vector>

namespace geodesic
{

class PolyDataSurface;

/// What was read of a source.
struct SourcePolylines
{
  std::vector<LocatedPolyline> polylines;
  /// LocatedPolyline::source of all that are sources, ascending. A cell of a vtkPolyData without
  /// points is one, and has no polyline; a point that no vertex cell of a set of points has is
  /// none.
  std::vector<Id> ids;
  /// All of these are below.
  Id numberOfSources = 0;
  /// Cells that are neither lines nor vertices and were left out.
  vtkIdType droppedCells = 0;
};

/// Reads the curves of all blocks, whose points are yet to be located: every line and polyline is a
/// curve, every point of a vertex cell a point source, polygons and strips stand for their
/// outlines. A block of vertex cells only is a set of points, as is one without any cell, all of
/// whose points are sources. A polyline's `source` is the number of its cell, or of its point in a
/// set of points, over all blocks in their order.
///
/// \param scale of the surface that they belong to; the polylines have it too.
/// \throws SourceError where there is no point or one is not finite.
SourcePolylines readSource(const std::vector<PolyDataBlock>& source, const PowerOfTwoScale& scale);

/// For each place the barrier that it lies in, a face of surface.barriers->surface(); the id is
/// NoId if it lies in none. All ranks call this together.
///
/// \param coordinatePrecision relative precision of the points' coordinates.
std::vector<RankAddress> barriersAt(
  const PolyDataSurface& surface, const LocatedPlaces& located, double coordinatePrecision);

/// Makes sure that no point of a source lies in a barrier: no path could leave it. All ranks call
/// this together, and all throw.
///
/// \param surfaceBlocks what the surface was made of, for the message.
/// \param located the points of the polylines.
/// \param coordinatePrecision relative precision of the points' coordinates.
/// \throws SourceError that names the polyline, the point and the cell.
void requireOutsideBarriers(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& surfaceBlocks, const std::vector<LocatedPolyline>& polylines,
  const LocatedPlaces& located, double coordinatePrecision);

/// "point 3 of cell 2 of the source", "point 5 of the source" where it is a curve of its own.
std::string nameOfPoint(const LocatedPolyline& line, std::size_t point);

/// What the coordinates' type allows: that of the least precise block.
SnapOptions snapOptionsFor(const std::vector<PolyDataBlock>& source);

}

#endif
