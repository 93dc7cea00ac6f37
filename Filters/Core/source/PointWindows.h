// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointWindows_h
#define geodesic_PointWindows_h

#include "source/CurveSectors.h"
#include "source/CurveWedge.h"
#include "source/LeavingWindow.h"

#include <vector>

namespace geodesic
{

/// Adds the circular windows of a source's point, through the halfedges of one face that holds it:
/// rays into the wedge (paper, sections 4.1 and 4.2), a window for each sector.
///
/// Where on a halfedge a ray passes says little of its direction when the point is close to the
/// halfedge (tolerance::NearEdge). All rays go through it then, and windows behind the next faces
/// are added as well, whose rays come straight from the point.
///
/// \param nearVertices gets the vertices at the point (tolerance::NearVertex) that these faces end
///        in.
void addPointWindows(const TriangleMesh& mesh, Id face, const Barycentric& point,
  const CurveWedge& wedge, const CurveSectors& sectors, std::vector<LeavingWindow>& windows,
  std::vector<Id>& nearVertices);

}

#endif
