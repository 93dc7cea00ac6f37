// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedOnRanks_h
#define geodesic_RefinedOnRanks_h

#include "field/DistanceField.h"
#include "refinement/RefinedMesh.h"

#include <cstddef>
#include <vector>

/// What ranks that share a surface tell each other about their refined meshes.
namespace geodesic
{

/// A collective call of all ranks, which finds out how faces were refined: another triangle on the
/// same vertices, or beside a face, must be split alike to fit its neighbours.
///
/// \param faces those that this rank needs, by their owners, possibly itself, in any order; NoId
///        where none is needed.
/// \param refined this rank's result of refine().
/// \param cornerPoints those of the refinement's options.
/// \returns the points and triangles of each of the faces. The face's corners are numbered 0, 1, 2,
///          and the points, all of them copies, follow.
std::vector<RefinedMesh> findRefinedFaces(const std::vector<RankAddress>& faces,
  const MeshPartition& part, const RefinedMesh& refined, const std::vector<Triangle>& cornerPoints);

/// Points that refinement has added on edges shared by faces of several ranks. Each of these ranks
/// has its own point, at the same place. Listed here are those of this rank whose values another
/// rank provides, so that all ranks have the same.
struct SeamPoints
{
  /// Indices into this rank's RefinedMesh::points.
  std::vector<Id> here;
  /// For each, the other rank and the index into its RefinedMesh::points.
  std::vector<RankAddress> there;
};

/// Several ranks may have a point on a shared edge: the lowest one that knows a face there provides
/// the point's values. A collective call of all ranks.
///
/// \param points the points of this rank's refinement.
/// \param count number of the first points, whose places on the mesh are known.
/// \param field, exact the fields that values are of, maybe the same. A rank knows a face if both
///        are known inside. Near a distance limit a rank may have no such face at an edge that
///        another rank has split.
SeamPoints findSeamPoints(const std::vector<RefinedPoint>& points, std::size_t count,
  const DistanceField& field, const DistanceField& exact);

}

#endif
