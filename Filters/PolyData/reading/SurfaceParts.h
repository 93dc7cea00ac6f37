// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceParts_h
#define geodesic_SurfaceParts_h

#include "Exchange.h"
#include "Job.h"
#include "PolyData/reading/PieceVertices.h"
#include "PolyData/reading/PolyDataSurface.h"

#include <vector>

namespace geodesic
{

/// What a surface's triangles are as parts: see PolyDataSurface.
struct SurfaceParts
{
  std::vector<Triangle> corners;
  std::vector<Id> triangles;
  std::vector<CutPoint> cutPoints;
  /// Empty if all are open.
  std::vector<TriangleRole> roles;
};

/// Cuts triangles beside faces without area into parts. All ranks call this together.
///
/// A part has points of its triangle's block at its corners: where a block has no point at a
/// vertex, one is added between two of its own.
///
/// \param triangles on vertices.
/// \param roles of the triangles; empty if all are open.
/// \param blocks with their triangles.
/// \param vertices are joined where faces without area join them; cut points are added.
/// \returns no corners if no triangle changes on this rank.
SurfaceParts cutTriangles(const std::vector<Triangle>& triangles, std::vector<TriangleRole> roles,
  const std::vector<SurfaceBlock>& blocks, Id numberOfPoints, PieceVertices& vertices,
  Exchange& exchange, const Job& job);

}

#endif
