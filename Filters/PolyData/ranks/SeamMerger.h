// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamMerger_h
#define geodesic_SeamMerger_h

#include "Exchange.h"
#include "PolyData/ranks/RankSeams.h"
#include "Types.h"

#include <cstdint>
#include <map>
#include <vector>

namespace geodesic
{

/// One block of a surface, for mergeSeams().
struct SeamBlock
{
  /// Its triangles, as vertices.
  std::vector<Triangle> triangles;
  /// Those that a ghost array marks as duplicates.
  std::vector<Triangle> ghosts;
  /// The relative precision of its coordinates.
  double precision = 0.0;
};

/// Vertices that are one.
struct JoinedVertices
{
  /// The label of each vertex that is one with others, and the label of the one that stands for it:
  /// the lowest of those that are no corners of ghosts only, if there are any.
  std::map<RankLabels::Label, RankLabels::Label> same;
  /// How many were joined with others, not counting those that only ghosts have.
  std::uint64_t count = 0;
};

/// Where blocks of one surface meet, their points may differ by roundings, and ghosts may differ
/// from what they duplicate: each block may have computed or stored them on its own. Finds the
/// vertices that are one within the precision of the coordinates (tolerance::SeamRoundings,
/// SeamFraction), the nearest first: two on boundaries, or one at a ghost and any other. Two with
/// triangles of one block are never made one.
///
/// \param vertices points at exactly one place are one vertex already.
/// \param labels of the vertices.
/// \param blocks those of one process; of several ranks, which call this together, one each.
/// \param largest the largest coordinate of a vertex of any rank's triangles.
/// \returns the same on all ranks.
JoinedVertices mergeSeams(const std::vector<Vec3>& vertices, const RankLabels& labels,
  std::vector<SeamBlock> blocks, double largest, Exchange& exchange);

}

#endif
