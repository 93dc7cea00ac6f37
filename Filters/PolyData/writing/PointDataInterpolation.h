// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointDataInterpolation_h
#define geodesic_PointDataInterpolation_h

#include "Progress.h"
#include "refinement/AdaptiveRefinement.h"

class vtkPointData;

namespace geodesic
{

/// Copies the data of a mesh's input points and gives its new points interpolated data: numbers
/// linearly in the face, strings, ids and bits those of the nearest corner. A new point is a ghost
/// in the ways that all corners around it are. Global ids are dropped.
///
/// \param end where this ends as a fraction of the whole.
void interpolatePointData(const RefinedMesh& refined, vtkPointData* from, vtkPointData* to,
  double end, LoopProgress& progress);

}

#endif
