// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RemoteDuplicates_h
#define geodesic_RemoteDuplicates_h

#include "Exchange.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/Triangulator.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// Finds the triangles of this rank that duplicate a face of another rank: cells that are marked as
/// duplicates and are on the vertices of one that is not marked. Of marked cells without such an
/// original, the first of all ranks is surface itself. All ranks call this together.
///
/// \param labels of the vertices.
/// \param vertexOfPoint which vertex each point is; empty where each is its own.
/// \param isCopy whether each triangle is a copy of another of this rank (findCopies()); those that
///        are copies of another rank's are marked in it.
void findCopiesOfOthers(const RankLabels& labels, const std::vector<Id>& vertexOfPoint,
  const std::vector<SurfaceBlock>& blocks, const TriangleList& triangles,
  std::vector<std::uint8_t>& isCopy, Exchange& exchange);

}

#endif
