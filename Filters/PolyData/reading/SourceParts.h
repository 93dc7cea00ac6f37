// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceParts_h
#define geodesic_SourceParts_h

#include "PolyData/reading/SourceCells.h"

#include <vector>

namespace geodesic
{

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
SourceCells readParts(const PartsRequest& from, const Job& job);

}

#endif
