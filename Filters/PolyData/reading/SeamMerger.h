// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamMerger_h
#define geodesic_SeamMerger_h

#include "Exchange.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/reading/SeamVertices.h"
#include "Types.h"

#include <cstdint>
#include <map>

namespace geodesic
{

/// The vertex that stands for several.
struct JoinedVertex
{
  RankLabels::Label label;
  Vec3 position;
};

/// Vertices that are one.
struct JoinedVertices
{
  /// For the label of each vertex that is one with others, the vertex that stands for all of them:
  /// one with faces, of the first block, by its place, so that ranks do not count.
  std::map<RankLabels::Label, JoinedVertex> same;
  /// How many were joined with others, not counting those that only ghosts have.
  std::uint64_t count = 0;
};

/// Where pieces of a surface meet, and along the cracks of one that was stored triangle by
/// triangle, points may differ by roundings, and ghosts may differ from what they duplicate: each
/// piece has computed or rounded the same place on its own. Finds the vertices that are one: two on
/// the boundary, or one that only ghosts have and any other, that are within the precision of the
/// coordinates (tolerance::SeamRoundings, SeamFraction) or, on the boundary, within the user's
/// tolerance. The nearest are joined first, and of those that are one all are as close to each
/// other: no edge has both ends among them. All ranks call this together.
///
/// \returns the same on all ranks.
JoinedVertices mergeSeams(const SeamSurface& surface, Exchange& exchange);

}

#endif
