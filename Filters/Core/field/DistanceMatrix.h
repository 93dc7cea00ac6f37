// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceMatrix_h
#define geodesic_DistanceMatrix_h

#include "Job.h"
#include "mesh/SurfacePoint.h"
#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// Curves, points and regions in sets, each of which is one source, or one target.
using CurveSets = std::vector<std::vector<SourceCurve>>;

/// Computes the distance from each of several sources, each source alone, to each target: the least
/// one of its points, along its lines and along the outlines of its regions; 0 if the source has a
/// point in one of these. Sources are solved side by side on one mesh structure, each in one
/// thread; a solve stops when its targets are settled. The distances are those of the source's
/// field, to the last bit.
///
/// If targets are fewer than sources, and fronts from the targets have less work by an estimate,
/// each target is solved instead until the sources are settled: the same distances up to rounding,
/// with the bits of the target's field.
///
/// \param maximumDistance larger distances count as infinite, in the surface's units.
/// \returns for each source the distances of the targets; infinite if no path leads to the target
///          or one of the two has no curve.
/// \throws Aborted
std::vector<std::vector<double>> distanceMatrix(const TriangleMesh& mesh, const CurveSets& sources,
  const CurveSets& targets, double maximumDistance = Infinity, const Job& job = {});

/// Computes the distance between each two of some sets. The table is symmetric to the last bit:
/// one set of each two is solved.
std::vector<std::vector<double>> distancesBetween(const TriangleMesh& mesh, const CurveSets& sets,
  double maximumDistance = Infinity, const Job& job = {});

/// \param curves SourceCurve::source, below the count, is the set of each.
CurveSets setsOf(const std::vector<SourceCurve>& curves, std::size_t count);
/// A set of each point.
CurveSets setsOf(const std::vector<SurfacePoint>& points);

}

#endif
