// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementOutput_h
#define geodesic_RefinementOutput_h

#include "Progress.h"
#include "Tasks.h"
#include "refinement/RedGreenMesh.h"
#include "refinement/RefinedMesh.h"

#include <vector>

namespace geodesic
{

/// The caller's points, if these are not the mesh's vertices.
struct CallersPoints
{
  /// For each face the ids of the points at its corners; empty: the mesh's vertices.
  const std::vector<Triangle>& atCorners;
  /// The number of points: fewer than vertices if the last vertices are only other ranks'.
  Id count;
};

/// Writes the triangles of a refined mesh, closed, and the added points.
///
/// \param parallelFor if empty, one thread. The result does not depend on it.
/// \param progress called with the fraction written.
void writeOutput(const RedGreenMesh& triangles, const CallersPoints& points,
  const ParallelFor& parallelFor, const ProgressCallback& progress, RefinedMesh& result);

}

#endif
