// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Solve_h
#define geodesic_Solve_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// Which windows a solve keeps.
enum class KeepWindows
{
  /// Distances at vertices only, in the least memory.
  None,
  /// The distance can be evaluated at any surface point, and paths traced.
  All
};

/// Computes the field of the geodesic distance to the curves (paper, sections 3 to 5). For a field
/// that is to be refined solveForRefinement() needs less memory.
///
/// \param mesh must outlive the field.
/// \throws SourceError where there is no curve; Error where the relative error is not a number >=
/// 0;
///         Aborted.
DistanceField solve(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options = {}, KeepWindows keep = KeepWindows::None);

/// The same from what the sources give to begin with; on a part of a surface see propagate().
DistanceField solve(const TriangleMesh& mesh, SourceWindows sources,
  const FrontOptions& options = {}, KeepWindows keep = KeepWindows::None);

}

#endif
