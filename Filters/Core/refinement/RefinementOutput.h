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

/// The points of a caller, where these are not the mesh's vertices.
struct CallersPoints
{
  /// For each face the ids of the points at its corners; empty: the mesh's vertices.
  const std::vector<Triangle>& atCorners;
  /// How many points there are: fewer than vertices where the last of these are other ranks'.
  Id count;
};

/// Writes the triangles of a refined mesh, closed, and the points that were added.
///
/// \param parallelFor absent: one thread. The result does not depend on it.
/// \param progress called with the fraction written.
void writeOutput(const RedGreenMesh& triangles, const CallersPoints& points,
  const ParallelFor& parallelFor, const ProgressCallback& progress, RefinedMesh& result);

}

#endif
