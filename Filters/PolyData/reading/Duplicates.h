// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Duplicates_h
#define geodesic_Duplicates_h

#include "Exchange.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/reading/Triangulator.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// Finds the originals of triangles that ghost arrays mark as duplicates, among the triangles of
/// all ranks. A marked cell on the vertices of an unmarked cell of this rank gets that cell's
/// triangles (a polygon may be cut in several ways). A marked cell without an original is surface
/// itself; of several such cells on the same vertices, the first. All ranks call this together.
///
/// \param labels of the vertices.
/// \param triangles the corners of marked ones may change.
/// \returns whether each triangle is a copy of another; empty if no triangle is.
std::vector<std::uint8_t> findCopies(const RankLabels& labels, const VertexOfPoint& vertexOf,
  TriangleList& triangles, Exchange& exchange);

}

#endif
