// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FarthestPoints_h
#define geodesic_FarthestPoints_h

#include "Job.h"
#include "mesh/TriangleMesh.h"
#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

struct FarthestPoint
{
  Id vertex;
  /// To the source and to all points before.
  double distance;
};

struct FarthestPoints
{
  std::vector<FarthestPoint> points;
  /// Of each vertex to the source and to all points.
  std::vector<double> vertexDistances;
};

/// Spreads points evenly: each next one is the vertex that is farthest from the source and from all
/// points before, of those at equal distance (but for a tie) the first. One front computes all
/// distances: each point goes no farther than it is nearest (FrontOptions::laterSources).
///
/// Vertices that no path reaches from the source are left out.
///
/// \returns so many; fewer if no vertex is left at a distance over 0.
/// \throws SourceError if there is no curve; Aborted.
FarthestPoints farthestPoints(const TriangleMesh& mesh, const std::vector<SourceCurve>& source,
  std::size_t count, const Job& job = {});

}

#endif
