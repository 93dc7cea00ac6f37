// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointMerger_h
#define geodesic_PointMerger_h

#include "Progress.h"
#include "Tasks.h"
#include "Types.h"

#include <vector>

namespace geodesic
{

/// For each point the first one at exactly its place.
///
/// \param progress its current stretch.
/// \param parallelFor absent: one thread.
std::vector<Id> firstAtPlaces(
  const std::vector<Vec3>& points, const LoopProgress& progress, const ParallelFor& parallelFor);

}

#endif
