// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathsToSource_h
#define geodesic_PathsToSource_h

#include "front/Front.h"
#include "mesh/SurfacePoint.h"
#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// A shortest path from a target to the source.
struct PathToSource
{
  /// The target, a point on every edge that the path crosses, the vertices that it passes, its end
  /// on the source; twice the target where that is on the source. Empty where it is not reached.
  /// Consecutive points have a face in common.
  std::vector<SurfacePoint> points;
  /// SourceCurve::source of a curve that the end lies on.
  Id source = NoId;
  /// Whether tracing lost it, so that it was found again by windows, which takes much longer.
  bool wasLost = false;
};

struct PathsOptions
{
  /// Absent: one task after another. The result does not depend on it.
  ParallelFor parallelFor;
  /// Called now and then with the fraction done in [0, 1]; returning false throws Aborted.
  ProgressCallback progress;
};

/// The shortest paths from points of the surface to the nearest point of the source, one of them
/// for each target.
///
/// One front goes from the source until all targets are settled; it keeps windows only around the
/// targets. Paths are then traced backwards by the directions in which they came to vertices
/// (PathTracer). Where a path runs so close to vertices that rounding leads it astray, it is found
/// again by windows that are kept in a strip around it (pathInWindows()).
///
/// \throws SourceError where there is no source; Aborted.
std::vector<PathToSource> pathsToSource(const TriangleMesh& mesh,
  const std::vector<SourceCurve>& sources, const std::vector<SurfacePoint>& targets,
  const PathsOptions& options = {});

}

#endif
