// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceParts_h
#define geodesic_SurfaceParts_h

#include "Exchange.h"
#include "Job.h"
#include "PolyData/ranks/PieceVertices.h"
#include "PolyData/reading/PolyDataSurface.h"

#include <vector>

namespace geodesic
{

/// Cuts triangles beside faces without area into parts. All ranks call this together.
///
/// A part has points of its triangle's block at its corners: where a block has no point at a
/// vertex, one is added between two of its own.
///
/// \param triangles on vertices.
/// \param exchange with the other ranks.
/// \param vertices are joined where faces without area join them; cut points are added.
/// \param surface with its blocks, their triangles, and the roles of the triangles. Gets the parts
///        and their roles, if a triangle changes on this rank.
void cutTriangles(const std::vector<Triangle>& triangles, Exchange& exchange,
  PieceVertices& vertices, PolyDataSurface& surface, const Job& job);

}

#endif
