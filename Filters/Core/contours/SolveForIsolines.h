// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForIsolines_h
#define geodesic_SolveForIsolines_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// Computes a field for drawIsolines(), up to the largest value and with windows only in faces that
/// may contain a value (solveDropping()).
///
/// \param surface whose mesh must outlive the field. All ranks solve together.
/// \param sources the first windows and vertices, see propagate().
/// \param values as IsolineOptions::values.
/// \param options exact: without a relative error.
/// \throws as solve().
DistanceField solveForIsolines(const MeshPartition& surface, const SourceWindows& sources,
  const std::vector<double>& values, const FrontOptions& options = {});

}

#endif
