// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceReaderOnRanks_h
#define geodesic_SurfaceReaderOnRanks_h

#include "PolyData/reading/PieceVertices.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "mesh/Box.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// Labels the vertices: vertices of different ranks that are one get the same label. If several
/// vertices of this rank get the same, they are one, too. All ranks call this together; one process
/// needs no labels.
///
/// \param byPlace whether vertices at one place are one.
void joinRanks(const std::vector<PolyDataBlock>& inputs, const std::vector<SurfaceBlock>& blocks,
  bool byPlace, Exchange& exchange, PieceVertices& vertices);

/// If ranks share the surface, leaves only the vertices that faces use, in the order of use. One
/// process keeps the others, too: points need no table then.
///
/// \param faces on all vertices; then on those that are left.
/// \param keys gets the labels of the vertices left; none in one process.
/// \returns for each vertex its new number, NoId if it is not left; empty in one process.
std::vector<Id> keepUsedVertices(std::vector<Triangle>& faces, const Exchange& exchange,
  PieceVertices& vertices, std::vector<std::uint64_t>& keys);

/// The box around the boxes of all ranks.
Box boxOfRanks(const Box& own, Exchange& exchange);

/// What all ranks report together of a mesh.
SurfaceReport reportOfRanks(SurfaceReport own, const MeshPartition& partition);

}

#endif
