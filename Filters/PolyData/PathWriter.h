// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathWriter_h
#define geodesic_PathWriter_h

#include "PolyData/PolyDataTargets.h"
#include "PolyData/PowerOfTwoScale.h"
#include "field/PathsToSource.h"

class vtkPolyData;

namespace geodesic
{

/// Gives an output a polyline for each path that is not empty, with the cell arrays TargetId,
/// SourceId, GeodesicDistance (its length) and TargetSnapDistance, and the point array
/// GeodesicDistance, which is what is left to go.
///
/// \param paths of the targets, in their order.
/// \param progress called now and then; returning false throws Aborted.
/// \throws MeshError where a length is larger than numbers can be.
void writePaths(const TriangleMesh& mesh, const PowerOfTwoScale& scale, const Targets& targets,
  const std::vector<PathToSource>& paths, vtkPolyData* output, const ProgressCallback& progress);

}

#endif
