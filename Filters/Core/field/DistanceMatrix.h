// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceMatrix_h
#define geodesic_DistanceMatrix_h

#include "front/Front.h"
#include "mesh/SurfacePoint.h"
#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// Computes the distance from each of several sources, each source alone, to each target. Sources
/// are solved side by side on one mesh structure, each in one thread; a solve stops when its
/// targets are settled. The distances are those of the source's field, to the last bit.
///
/// If all sources are sets of points, targets are fewer than sources, and fronts from the targets
/// have less work by an estimate, each target is solved instead until the sources are settled: the
/// same distances up to rounding, with the bits of the target's field.
///
/// \param curves of all sources. Curves with the same SourceCurve::source, below numberOfSources,
///        are one source.
/// \param maximumDistance larger distances count as infinite, in the surface's units.
/// \returns for each source the distances of the targets; infinite if no path leads to the target
///          or the source has no curve.
/// \throws Aborted
std::vector<std::vector<double>> distanceMatrix(const TriangleMesh& mesh,
  const std::vector<SourceCurve>& curves, Id numberOfSources,
  const std::vector<SurfacePoint>& targets, double maximumDistance = Infinity, const Job& job = {});

}

#endif
