// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NearestSourceOnRanks_h
#define geodesic_NearestSourceOnRanks_h

#include "field/NearestSource.h"

#include <unordered_map>
#include <vector>

namespace geodesic
{

/// Origins on the source of paths to vertices.
using Origins = std::unordered_map<GlobalId, PathOrigin>;

/// Finds the origins of paths that come from vertices counted by other ranks: of the vertices of
/// this rank's part that are not counted here, and of those that its windows name. A chain of
/// pseudo-sources may lead through many ranks. In each round, every rank asks for the origin of the
/// vertex that it has followed a chain to. As the ranks asked follow their own chains at the same
/// time, each round doubles the known length of the chains.
///
/// All ranks call this together. In one process there are no such vertices.
///
/// \param field on this rank's part, with arrivals.
/// \param atVertices the origin of the path to each vertex of the part. For vertices counted here
///        it is a point of the source, or, still open, a vertex counted elsewhere. Open origins are
///        replaced, and origins of vertices counted elsewhere are set.
/// \returns the origins; paths may have none.
Origins originsElsewhere(const DistanceField& field, std::vector<PathOrigin>& atVertices);

}

#endif
