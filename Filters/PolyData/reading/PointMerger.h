// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointMerger_h
#define geodesic_PointMerger_h

#include "PolyData/reading/VertexOfPoint.h"
#include "Progress.h"
#include "Tasks.h"

#include <vector>

namespace geodesic
{

/// Merges points that lie at exactly one place, keeping the order of the first ones.
///
/// \param points in: all points; out: one a place, the vertices.
/// \param progress its current stretch.
/// \param parallelFor absent: one thread.
VertexOfPoint mergeCoincidentPoints(
  std::vector<Vec3>& points, const LoopProgress& progress, const ParallelFor& parallelFor);

}

#endif
