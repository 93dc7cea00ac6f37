// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_UnmeshedTriangles_h
#define geodesic_UnmeshedTriangles_h

#include "PolyData/reading/PolyDataSurface.h"
#include "refinement/RefinedMesh.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// How many barriers are at the edges of the mesh, for RefinementOptions::trianglesBeside. Each
/// barrier of any rank counts once at each of its edges. All ranks call this together.
std::unordered_map<Id, Id> barriersAtEdges(const PolyDataSurface& surface);

/// Adds the triangles of a surface that are not faces of its mesh.
///
/// The mesh has one of several faces on the same vertices, the surface has all of them: the others
/// get the parts of the first, which any rank may own, so that they still fit to their neighbors.
/// If all ranks together would have more than maximumFaces triangles (0: no limit), they stay
/// whole. Copies by ghost arrays do not count, and always look like their originals.
///
/// Barriers are cut where refinement has split their rims, and are whole elsewhere. No other points
/// are added to a barrier: it has no distances inside.
///
/// All ranks call this together. Afterwards RefinedMesh::faces has numbers of the surface's
/// triangles.
///
/// \param cornerPoints those of the refinement.
/// \returns for each point that this has added behind those of the refinement, in their order,
///          which of RefinedMesh::points of which rank's refinement it is a copy of. The places of
///          the added points are not set.
std::vector<RankAddress> addUnmeshedTriangles(const PolyDataSurface& surface,
  std::uint64_t maximumFaces, const std::vector<Triangle>& cornerPoints, RefinedMesh& refined);

}

#endif
