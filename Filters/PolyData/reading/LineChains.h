// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LineChains_h
#define geodesic_LineChains_h

#include "source/PolylineOnSurface.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace geodesic
{

/// Joins lines of two points, such as a section of a surface has in each face, to curves. A curve
/// is a maximal chain of lines through places where exactly two lines meet. Lines meet where their
/// ends have equal coordinates and are one vertex, if they belong to one part of the source. The
/// time is linear in the number of lines.
///
/// A curve has the name and the source of its lowest line, and takes that line's position among the
/// polylines. It runs in the direction of most of its lines; if as many run the other way, in the
/// direction of the lowest one. A loop that nothing else meets is closed and begins with its lowest
/// line. LocatedPolyline::pointNames tells of which cell each point is.
///
/// If several lines join the same two places, the lowest one counts. A line whose ends are at one
/// place stays only if no other line has an end there.
///
/// \param polylines that are not located yet. Other polylines keep their order.
/// \param lines the numbers of the polylines to join, ascending; each has two points and a source
///        of its own.
/// \param parts of each line.
void joinLines(std::vector<LocatedPolyline>& polylines, const std::vector<std::size_t>& lines,
  const std::vector<vtkIdType>& parts);

}

#endif
