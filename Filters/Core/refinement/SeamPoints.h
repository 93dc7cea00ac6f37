// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamPoints_h
#define geodesic_SeamPoints_h

#include "field/DistanceField.h"
#include "refinement/RefinedMesh.h"

#include <cstddef>
#include <vector>

namespace geodesic
{

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

/// Of the ranks that have a point on a shared edge and know a face there, the lowest provides its
/// values. A collective call of all ranks.
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
