// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathInWindows_h
#define geodesic_PathInWindows_h

#include "front/Front.h"
#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic
{

/// What a front has found, for pathInWindows().
struct KnownDistances
{
  /// At each vertex, not below the distance; and the distance where it is within the reach.
  const std::vector<double>& atVertices;
  double reach = Infinity;
};

/// Where a path of a length from the source can be, for a front from its other end.
Corridor corridorTo(double length, const KnownDistances& known);

/// A shortest path by the windows of the faces that it goes through: slower than tracing it by
/// arrivals (PathTracer), but rounding cannot lead it astray.
///
/// A front from the target goes only where a path can still be as short as it is, by the distances
/// that are known, which is a strip of few faces. A second one from the source goes through that
/// strip only and keeps its windows.
///
/// \param distance of the target, finite and within the reach.
/// \returns see DistanceField::path().
std::vector<SurfacePoint> pathInWindows(const TriangleMesh& mesh,
  const std::vector<SourceCurve>& sources, const SurfacePoint& target, double distance,
  const KnownDistances& known, const ParallelFor& parallelFor, const ProgressCallback& progress);

}

#endif
