// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForRefinement_h
#define geodesic_SolveForRefinement_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// Computes a field that refine() can refine to a tolerance or a larger one, keeping windows only
/// where the distance is not linear within it. In an approximate solve all are kept, and the
/// windows of one halfedge are merged by no more than maximumMergedFor(tolerance), whatever the
/// relative error.
///
/// Where windows were dropped that turn out to be needed, it is solved again with these kept; after
/// some such solves once more with all windows kept, so that there are at most five.
///
/// \param mesh must outlive the field.
/// \param tolerance in the surface's units, positive.
/// \throws as solve().
DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double tolerance, const FrontOptions& options = {});

/// What merging may change on one halfedge of an approximate field that is refined to a tolerance:
/// a tenth of it (window/Merging.md).
double maximumMergedFor(double tolerance);

}

#endif
