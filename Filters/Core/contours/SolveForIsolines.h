// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForIsolines_h
#define geodesic_SolveForIsolines_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// Computes a field for drawIsolines(), up to the largest value and with windows only in faces that
/// may contain a value. If windows were dropped that turn out to be needed, it solves again and
/// keeps these. The last solve keeps all windows, so that there is an end.
///
/// \param surface whose mesh must outlive the field. All ranks solve together.
/// \param sources the first windows and vertices, see propagate().
/// \param values as IsolineOptions::values.
/// \param options exact: without a relative error.
/// \param maximumDroppingSolves the largest number of solves that drop windows; at most one more
///        solve is made.
/// \throws as solve().
DistanceField solveForIsolines(const MeshPartition& surface, const SourceWindows& sources,
  const std::vector<double>& values, const FrontOptions& options = {},
  int maximumDroppingSolves = 3);

/// The same in one process, from the curves themselves.
DistanceField solveForIsolines(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const std::vector<double>& values, const FrontOptions& options = {},
  int maximumDroppingSolves = 3);

}

#endif
