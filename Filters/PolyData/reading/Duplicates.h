// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Duplicates_h
#define geodesic_Duplicates_h

#include "Exchange.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/reading/TriangleReader.h"

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
/// \returns of each triangle whether it is a copy of another, or else open; empty if no triangle is
/// a
///          copy.
std::vector<TriangleRole> findCopies(const RankLabels& labels, const VertexOfPoint& vertexOf,
  TriangleList& triangles, Exchange& exchange);

}

#endif
