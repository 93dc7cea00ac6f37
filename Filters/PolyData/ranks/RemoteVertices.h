// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RemoteVertices_h
#define geodesic_RemoteVertices_h

#include "Exchange.h"
#include "PolyData/ranks/BorrowedValues.h"
#include "PolyData/ranks/RankSeams.h"

#include <vector>

namespace geodesic
{

/// Finds values for the vertices of a rank's points that no own face has: corners of duplicates of
/// other ranks' faces, and points that no face uses here. The values come from the lowest rank that
/// has a face there. All ranks call this together.
///
/// \param labels of all vertices of this rank.
/// \param ownNumbers of each vertex its number among those with faces; NoId without faces. Empty in
///        one process.
/// \returns one value for each vertex without faces, in their order.
BorrowedValues remoteVertices(
  const RankLabels& labels, const std::vector<Id>& ownNumbers, Exchange& exchange);

}

#endif
