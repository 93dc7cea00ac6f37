// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamPoints_h
#define geodesic_SeamPoints_h

#include "mesh/MeshPartition.h"
#include "refinement/RefinedMesh.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace geodesic
{

/// Points that refinement has added on edges which faces of several ranks share: each of these
/// ranks has its own, at the same place. Here are those of a rank that are better told of by
/// another one, so that all tell the same.
struct SeamPoints
{
  /// Which of this rank's RefinedMesh::points.
  std::vector<Id> here;
  /// For each the other rank and which of its RefinedMesh::points.
  std::vector<RankAddress> there;
};

/// Of the ranks that have a point on a shared edge and know a face there, the lowest is to tell of
/// it. All ranks call this together.
///
/// \param points those of this rank's refinement.
/// \param count of the first points: those whose places on the mesh are known.
/// \param isKnown whether a face that this rank owns is known inside. Near a distance limit a rank
///        may have no such face at an edge that another has split.
SeamPoints findSeamPoints(const std::vector<RefinedPoint>& points, std::size_t count,
  const MeshPartition& part, const std::function<bool(Id face)>& isKnown);

}

#endif
