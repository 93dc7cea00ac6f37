// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedPolyData_h
#define geodesic_RefinedPolyData_h

#include "PolyData/reading/PolyDataSurface.h"
#include "refinement/AdaptiveRefinement.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// Adds the triangles of a surface that are no faces of its mesh.
///
/// The mesh has one of the faces on the same corners, the surface has them all: gives the others
/// the parts of the first, so that they still fit to their neighbours. Where that would make more
/// than maximumFaces triangles (0: no limit) they stay whole. Copies by ghost arrays do not count,
/// and always look like their originals.
///
/// Barriers are cut where refinement has split their rims, and are whole elsewhere.
///
/// After the call RefinedMesh::faces has numbers of the surface's triangles.
void addOtherTriangles(
  const PolyDataSurface& surface, std::uint64_t maximumFaces, RefinedMesh& refined);

/// The block of the surface that each new point of a refined mesh belongs to.
std::vector<std::size_t> blocksOfNewPoints(
  const PolyDataSurface& surface, const RefinedMesh& refined);

/// What of a refined mesh (after addOtherTriangles) belongs to each block of the surface, in
/// numbers of the block: points, and triangles as RefinedMesh::faces has them. Each edge of the
/// surface is an edge between points of one block, so that every new point belongs to one, too.
std::vector<RefinedMesh> partsByBlock(const PolyDataSurface& surface, RefinedMesh refined);

}

#endif
