// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedFaces_h
#define geodesic_RefinedFaces_h

#include "mesh/MeshPartition.h"
#include "refinement/RefinedMesh.h"

#include <vector>

namespace geodesic
{

/// How one face is refined, wherever it is owned: what another triangle on its vertices has to look
/// like, so that it still fits to its neighbours.
struct RefinedFace
{
  /// The points that were added to it, each after its parents. Here and in the triangles the face's
  /// corners have the numbers 0, 1, 2, and these points follow. Their places are not told.
  std::vector<RefinedPoint> points;
  /// Which of the owner's RefinedMesh::points each of these is.
  std::vector<Id> numbersThere;
  std::vector<Triangle> triangles;
};

/// All ranks together tell each other how faces are refined.
///
/// \param faces those that this rank asks for: by their owners, which may be itself; in any order.
/// \param refined this rank's result of refine().
/// \param cornerPoints those of the refinement's options.
/// \returns one for each that was asked for.
std::vector<RefinedFace> findRefinedFaces(const std::vector<RankAddress>& faces,
  const MeshPartition& part, const RefinedMesh& refined, const std::vector<Triangle>& cornerPoints);

}

#endif
