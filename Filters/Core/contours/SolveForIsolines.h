// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForIsolines_h
#define geodesic_SolveForIsolines_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// Computes a field for drawIsolines(), up to the largest value and with windows only in faces that
/// may hold one. Where windows were dropped that turn out to be needed, it is solved again with
/// these kept; to be sure of an end, the last solve keeps all.
///
/// \param surface whose mesh must outlive the field. Ranks that have it together solve together.
/// \param sources what they give to begin with (propagate()).
/// \param values as IsolineOptions::values.
/// \param options exact: without a relative error.
/// \param maximumDroppingSolves how often it is solved with windows dropped; at most one solve
///        more is made.
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
