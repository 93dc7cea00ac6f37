// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceParts_h
#define geodesic_SourceParts_h

#include "PolyData/reading/SourceCells.h"
#include "source/PolylineLocator.h"

#include "vtkType.h"

#include <string>
#include <vector>

namespace geodesic
{

/// The sources, or sets of targets, that an input has.
struct PartIds
{
  /// Ascending; the `source` of a curve is the place of an id here. The number of a cell (of a
  /// point in a set of points) over all blocks, unless an array names them.
  std::vector<vtkIdType> ids;
  /// What each of these is called: as the first of its cells. Empty unless an array says so.
  std::vector<std::string> names;
  /// Whether an array has named them.
  bool areNamed = false;
  /// All ids are below.
  vtkIdType idEnd = 0;
};

/// The curves and regions of an input, and where their points are. LocatedPolyline::source is the
/// place of an id.
struct SourceParts : SourceCells
{
  PartIds parts;
  LocatedPlaces located;
};

/// What parts are read from, and onto which surface.
struct PartsRequest
{
  const std::vector<PolyDataBlock>& blocks;
  /// As messages call the input if the parts are sets of targets; null if they are sources.
  const PartName* targets;
  /// Whether cells of two points that meet are one curve (LineChains.h), and faces with a common
  /// edge one region, where no values tell what is one source.
  bool areLinesJoined;
  const PolyDataSurface& surface;
  /// What the surface was made of, for messages.
  const std::vector<PolyDataBlock>& surfaceBlocks;
  PolylineLocator& locator;
};

/// Reads the curves of all blocks and locates them: every line and polyline is a curve, every point
/// of a vertex cell a point source; polygons and strips make regions. A block of vertex cells only
/// is a set of points, as is one without any cell, all of whose points are sources. If blocks have
/// PolyDataBlock::sourceIds, all that has one value is one part; of targets, what has a negative
/// one is none. All ranks call this together, and all throw.
///
/// Faces of a source that lie in barriers are left out, and so are single points of targets there,
/// where no path comes to.
///
/// \throws InputError where there is no point, one is not finite, or a value is no id, or if a
///         point of a curve lies in a barrier: no path could leave it; Aborted.
SourceParts readParts(const PartsRequest& from, const Job& job);

}

#endif
