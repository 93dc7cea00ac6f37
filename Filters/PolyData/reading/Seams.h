// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Seams_h
#define geodesic_Seams_h

#include "Exchange.h"
#include "PolyData/ranks/PieceVertices.h"
#include "PolyData/reading/TriangleReader.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// What a rank has of a surface, for mergeSeams(). Points at exactly one place, and those that
/// ranks share, are one vertex already.
struct SeamSurface
{
  PieceVertices& vertices;
  const TriangleList& triangles;
  /// The relative precision of the coordinates, of each block.
  std::vector<double> precisions;
  /// The largest coordinate of a vertex of any rank's triangles.
  double largest = 0.0;
  /// How far apart the user allows vertices on the boundary to be that are one.
  double mergeTolerance = 0.0;
};

/// Where pieces of a surface meet, and along the cracks of one that was stored triangle by
/// triangle, points may differ by roundings, and ghosts may differ from what they duplicate: each
/// piece has computed or rounded the same place on its own. Finds the vertices that are one: two on
/// the boundary, or one that only ghosts have and any other, that are within the precision of the
/// coordinates (tolerance::SeamRoundings, SeamFraction) or, on the boundary, within the user's
/// tolerance. The nearest are joined first, and of those that are one all are as close to each
/// other: no edge has both ends among them. One vertex stands for them: one with faces, of the
/// first block, by its place, so that ranks do not count. All ranks call this together and decide
/// the same from the same list of vertices.
///
/// \param surface gets its vertices joined.
/// \returns how many vertices of all ranks were joined with others, not counting those that only
///          ghosts have.
std::uint64_t mergeSeams(const SeamSurface& surface, Exchange& exchange);

}

#endif
