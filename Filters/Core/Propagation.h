// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Propagation_h
#define geodesic_Propagation_h

#include "DistanceField.h"
#include "Progress.h"
#include "SourceCurve.h"
#include "TriangleMesh.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// Which windows a solve keeps.
enum class KeepWindows
{
  /// None: distances at vertices only, the least memory.
  None,
  /// All: the distance can be evaluated at any surface point, and paths traced.
  All,
  /// Those of faces where the distance is not flat within a tolerance: enough for refine(). In an
  /// approximate solve, as All.
  WhereCurved
};

struct SolveOptions
{
  KeepWindows keepWindows = KeepWindows::None;
  /// With WhereCurved: the refinement's tolerance, in the surface's units.
  double flatTolerance = 0.0;
  /// 0: exact. Otherwise the largest relative error of any distance against the exact one, for
  /// which windows are merged (paper, section 5).
  double relativeError = 0.0;
  /// With a relative error: the most that merging the windows of one side may change the distance
  /// there, in the surface's units. The distances of two faces at a point of their edge then differ
  /// by no more. Where the field is to be refined, mostMergedFor(tolerance) in
  /// AdaptiveRefinement.h.
  double mostMerged = Infinity;
  /// Stop there, in the surface's units. Every face that has a point within the limit is complete:
  /// all its vertices (and its inside, where windows are kept) have exact values.
  double maximumDistance = Infinity;
  /// Runs task(0) to task(count - 1), in any order and at the same time if it likes, and returns
  /// when all are done. Absent: one after another. The result does not depend on it.
  std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)> parallelFor;
  /// Called now and then, at least ten times a second, with the fraction done in [0, 1]; returning
  /// false stops the solve with Aborted.
  ProgressCallback progress;
};

/// Computes the geodesic distance to the curves, exact or within a relative error (paper, sections
/// 3 to 5).
///
/// The mesh must outlive the field.
///
/// \throws SourceError where there is no curve; Error where the relative error is not a number >=
/// 0;
///         Aborted.
DistanceField solve(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const SolveOptions& options = {});

}

#endif
