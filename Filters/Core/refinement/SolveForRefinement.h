// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForRefinement_h
#define geodesic_SolveForRefinement_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

/// Computes a field that refine() can refine to a tolerance or a larger one, keeping windows only
/// where the distance is not linear within it. In an approximate solve all are kept, and the windows
/// of one halfedge are merged by no more than a tenth of the tolerance, whatever the relative error.
///
/// \param mesh must outlive the field.
/// \param tolerance in the surface's units, positive.
/// \throws as solve().
DistanceField solveForRefinement(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  double tolerance, const FrontOptions& options = {});

}

#endif
