// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleRoles_h
#define geodesic_TriangleRoles_h

#include "Exchange.h"
#include "PolyData/ranks/PieceVertices.h"
#include "PolyData/reading/TriangleReader.h"

#include <vector>

namespace geodesic
{

/// Finds the roles of the triangles of all ranks, which call this together.
///
/// The originals of triangles that ghost arrays mark as duplicates are looked for on all ranks. A
/// marked cell on the vertices of an unmarked cell of this rank gets that cell's triangles (a
/// polygon may be cut in several ways). A marked cell without an original is surface itself; of
/// several such cells on the same vertices, the first.
///
/// \param inputs which triangles are barriers.
/// \param triangles the corners of marked ones may change.
/// \returns of each triangle; empty if all are open.
/// \throws MeshError if no open triangle is left on any rank, where this one has barriers.
std::vector<TriangleRole> findRoles(const std::vector<PolyDataBlock>& inputs,
  const PieceVertices& vertices, TriangleList& triangles, Exchange& exchange);

}

#endif
