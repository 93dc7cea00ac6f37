// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathInWindows_h
#define geodesic_PathInWindows_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// Finds the shortest path from a point back to the source by the windows of the faces that it goes
/// through: the point, a point on every edge that the path crosses, the vertices that it passes,
/// its end on the source. One of the paths where there are several. Empty where the point was not
/// reached, or where by rounding no path as long as the distance (tolerance::BoundMargin) is found.
///
/// \throws Error where not all windows were kept.
std::vector<SurfacePoint> pathInWindows(const DistanceField& field, const SurfacePoint& from);

/// Takes out of a path what tracing adds by rounding: crossings of edges at their ends, and
/// repeated points. Consecutive points still have a face in common. The path keeps its ends; one of
/// a single point gets it twice, and one of none stays so.
///
/// \param length of the path, or a bound of it: a crossing nearer to a vertex than a fraction of it
///        is at the vertex.
std::vector<SurfacePoint> cleanedPath(
  const TriangleMesh& mesh, const std::vector<SurfacePoint>& path, double length);

}

#endif
