// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourcesAndTargets_h
#define geodesic_SourcesAndTargets_h

#include "PolyData/PolyDataBlocks.h"
#include "mesh/SurfacePoint.h"
#include "source/PolylineLocator.h"

#include "vtkType.h"

#include <string>
#include <vector>

namespace geodesic
{

struct PolyDataSurface;

/// What was read of a source.
struct SourcePolylines
{
  std::vector<LocatedPolyline> polylines;
  /// The numbers of those that are cells of two points.
  std::vector<std::size_t> lines;
  /// The faces of regions, whose outlines are among the polylines; see SourceFaces.h.
  std::vector<LocatedPolyline> faces;
  /// Each of these, cut at the points of faces without area.
  std::vector<std::vector<LocatedPolyline>> partsOfFaces;
  /// The ids of the sources, ascending; LocatedPolyline::source is the place of one here. A cell of
  /// a vtkPolyData without points is a source, and has no polyline; a point that no vertex cell of
  /// a set of points has is none.
  std::vector<vtkIdType> ids;
  /// What each of these is called: as the first of its parts. Empty unless arrays say so.
  std::vector<std::string> names;
  /// All of these are below.
  vtkIdType idEnd = 0;
  /// Cells that are neither vertices, lines nor flat faces and were left out.
  vtkIdType droppedCells = 0;
};

/// Reads the curves of all blocks, whose points are yet to be located: every line and polyline is a
/// curve, every point of a vertex cell a point source; polygons and strips make regions. A block of
/// vertex cells only is a set of points, as is one without any cell, all of whose points are
/// sources. The id of a source is the number of its cell, or of its point in a set of points, over
/// all blocks in their order. If blocks have PolyDataBlock::sourceIds, all that has one value is a
/// source with this id. Faces that lie in barriers are left out. All ranks call this together.
///
/// \param surface that they belong to; the polylines have its scale. Points that name one of its
///        points and lie there are this vertex.
/// \param areLinesJoined whether cells of two points that meet are one curve (LineChains.h), and
///        faces with a common edge one region, where no values tell what is one source.
/// \throws SourceError where there is no point, one is not finite, or a value is no id, or if all
///         lies in barriers; Aborted.
SourcePolylines readSource(const std::vector<PolyDataBlock>& source, const PolyDataSurface& surface,
  bool areLinesJoined, PolylineLocator& locator, const Job& job);

/// Reads sets of targets in the same way: all that has one value of PolyDataBlock::sourceIds is
/// one, and what has a negative one is none.
///
/// \param name as messages call the input.
/// \throws SourceError as readSource(); InputError if there is no target.
SourcePolylines readTargetSets(
  const std::vector<PolyDataBlock>& blocks, const PartName& name, const PolyDataSurface& surface);

/// For each place the barrier that it lies in, a face of surface.barriers->surface(); the id is
/// NoId if it lies in none. All ranks call this together.
///
/// \param coordinatePrecision relative precision of the points' coordinates.
std::vector<RankAddress> barriersAt(
  const PolyDataSurface& surface, const LocatedPlaces& located, double coordinatePrecision);

/// Leaves out the single points of polylines that lie in a barrier, where no path comes to.
///
/// \param located the points of the polylines, and barriers where these lie.
void leaveOutPointsInBarriers(
  const LocatedPlaces& located, const std::vector<RankAddress>& barriers, SourcePolylines& read);

/// Makes sure that no point of a source lies in a barrier: no path could leave it. All ranks call
/// this together, and all throw.
///
/// \param surfaceBlocks what the surface was made of, for the message.
/// \param located the points of the polylines, and barriers where these lie.
/// \throws SourceError that names the polyline, the point and the cell.
void requireOutsideBarriers(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& surfaceBlocks, const std::vector<LocatedPolyline>& polylines,
  const LocatedPlaces& located, const std::vector<RankAddress>& barriers);

/// Whether values (PolyDataBlock::sourceIds) tell what is one source.
bool arePartsNamed(const std::vector<PolyDataBlock>& source);

/// The relative precision that the coordinates' type allows: that of the least precise block.
double coordinatePrecisionOf(const std::vector<PolyDataBlock>& source);

/// Points of an input, put onto the surface. They are numbered over all blocks in their order.
struct Targets
{
  /// How many there are.
  std::size_t count = 0;
  /// The numbers of those that paths may reach and whose faces this rank owns. Points that lie in a
  /// barrier are left out.
  std::vector<std::size_t> numbers;
  /// Where these points are on the surface.
  std::vector<SurfacePoint> places;
  /// From each of these in space to its place, on the mesh's scale.
  std::vector<double> snapDistances;
};

/// Puts every point of all blocks onto the closest point of the surface, and onto a vertex or an
/// edge if one is within the precision of the coordinates: the same place as for a source that is
/// one point. All ranks call this together, with the same points; each target goes to one rank.
///
/// \param name as messages call the input: "the set of targets (input port 2)".
/// \throws InputError if there is no point, or one is not finite or too far away; Aborted.
Targets readTargets(const std::vector<PolyDataBlock>& blocks, const PartName& name,
  const PolyDataSurface& surface, PolylineLocator& locator, const Job& job);

}

#endif
