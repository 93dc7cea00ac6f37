// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointMerger_h
#define geodesic_PointMerger_h

#include "Progress.h"
#include "Tasks.h"
#include "Types.h"

#include <vector>

namespace geodesic
{

/// Merges points that lie at exactly one place, keeping the order of the first ones.
///
/// \param points in: all points; out: one a place.
/// \param vertexOfPoint out: the place of each; left empty where no two points coincide.
/// \param progress its current stretch.
/// \param parallelFor absent: one thread.
void mergeCoincidentPoints(std::vector<Vec3>& points, std::vector<Id>& vertexOfPoint,
  const LoopProgress& progress, const ParallelFor& parallelFor);

}

#endif
