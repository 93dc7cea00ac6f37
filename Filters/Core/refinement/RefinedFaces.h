// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedFaces_h
#define geodesic_RefinedFaces_h

#include "mesh/MeshPartition.h"
#include "refinement/RefinedMesh.h"

#include <vector>

namespace geodesic
{

/// The refinement of one face, whichever rank owns it: another triangle on the same vertices must
/// be split alike to fit its neighbours.
struct RefinedFace
{
  /// The added points, each after its parents. Here and in the triangles, the face's corners are
  /// numbered 0, 1, 2, and these points follow. Their places are not set.
  std::vector<RefinedPoint> points;
  /// The number of each of these points in the owner's RefinedMesh::points.
  std::vector<Id> numbersThere;
  std::vector<Triangle> triangles;
};

/// A collective call of all ranks, which finds out how faces were refined.
///
/// \param faces the faces that this rank needs, by their owners, possibly itself; in any order.
/// \param refined this rank's result of refine().
/// \param cornerPoints those of the refinement's options.
/// \returns one element for each of the faces.
std::vector<RefinedFace> findRefinedFaces(const std::vector<RankAddress>& faces,
  const MeshPartition& part, const RefinedMesh& refined, const std::vector<Triangle>& cornerPoints);

}

#endif
