// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedPolyData_h
#define geodesic_RefinedPolyData_h

#include "PolyData/reading/PolyDataSurface.h"
#include "refinement/AdaptiveRefinement.h"

#include <cstddef>
#include <vector>

namespace geodesic
{

/// For RefinementOptions::cornerPoints: the input's points at the corners of each face, NoId for
/// the faces of other ranks. Empty if points and vertices are the same.
std::vector<Triangle> cornerPointsOf(const PolyDataSurface& surface);

/// The block of the surface that each new point of a refined mesh belongs to.
std::vector<std::size_t> blocksOfNewPoints(
  const PolyDataSurface& surface, const RefinedMesh& refined);

/// What of a refined mesh (after addUnmeshedTriangles()) belongs to each block of the surface, in
/// numbers of the block: points, and triangles as RefinedMesh::faces has them. Each edge of the
/// surface is an edge between points of one block, so that every new point belongs to one, too.
std::vector<RefinedMesh> partsByBlock(const PolyDataSurface& surface, RefinedMesh refined);

}

#endif
