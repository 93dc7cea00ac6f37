// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathWriter_h
#define geodesic_PathWriter_h

#include "PolyData/PowerOfTwoScale.h"
#include "Progress.h"
#include "paths/PathsToSource.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace geodesic
{

/// A path of a target, by places in space on the mesh's scale.
struct PathOfTarget
{
  /// Number of the target.
  std::size_t target = 0;
  double snapDistance = 0.0;
  std::vector<Vec3> points;
  PathEnd end;
};

/// Which arrays about the ends of paths are asked for.
struct PathEndChoice
{
  bool arcLengths = false;
  bool angles = false;
};

/// Gives an output a polyline for each path, with the cell arrays TargetId, SourceId,
/// GeodesicDistance (its length), TargetSnapDistance and, if they are asked for, SourceArcLength
/// and SourceAngle, and the point array GeodesicDistance, which is what is left to go.
///
/// \param paths in the order of their targets.
/// \param progress called now and then; returning false throws Aborted.
/// \throws MeshError where a length is larger than numbers can be.
void writePaths(const PowerOfTwoScale& scale, const std::vector<PathOfTarget>& paths,
  const PathEndChoice& choice, vtkPolyData* output, const ProgressCallback& progress);

}

#endif
