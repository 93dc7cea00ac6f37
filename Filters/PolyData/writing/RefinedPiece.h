// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedPiece_h
#define geodesic_RefinedPiece_h

#include "PolyData/reading/PolyDataSurface.h"
#include "refinement/AdaptiveRefinement.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// For RefinementOptions::cornerPoints: the points of a piece at the corners of the faces that it
/// owns.
std::vector<Triangle> cornerPointsOfPiece(const PolyDataSurface& surface);

/// How many triangles are surface, of a piece on all ranks, which call this together.
std::uint64_t countOwnTriangles(const PolyDataSurface& surface);

/// The same as addOtherTriangles() for a piece of a surface: gives triangles that are no faces here
/// the parts of the faces on their vertices, which other ranks may own. Copies by ghost arrays look
/// like their originals on other ranks. All ranks call this together.
///
/// \param maximumFaces over all ranks.
/// \param cornerPoints those of the refinement.
/// \returns for each point that this has added behind those of the refinement, in their order,
///          which of RefinedMesh::points it is a copy of, of another rank's refinement or of this
///          one's; the places of the added points are not set.
std::vector<RankAddress> addOtherTrianglesOfPiece(const PolyDataSurface& surface,
  std::uint64_t maximumFaces, const std::vector<Triangle>& cornerPoints, RefinedMesh& refined);

}

#endif
