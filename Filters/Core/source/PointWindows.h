// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointWindows_h
#define geodesic_PointWindows_h

#include "source/CurveWedge.h"
#include "source/FanAround.h"
#include "source/SourceWindows.h"

namespace geodesic
{

/// Adds the circular windows of a source's point through the halfedges of one face that contains
/// it: rays into the wedge (paper, sections 4.1 and 4.2), one window per sector.
///
/// If the point is close to a halfedge (tolerance::NearEdge), the place where a ray crosses it
/// determines the ray's direction badly. All rays then pass through that halfedge, and windows
/// behind the next faces are added as well, whose rays come straight from the point. If the point
/// lies on that halfedge but for rounding, and has sectors there, the next faces contain it, too:
/// they are added to the faces of the source, and nothing passes through the halfedge.
///
/// If the point is near a vertex whose faces are far larger, rays through the edges at the vertex
/// are laid out by their turn around it, which the place of the point beside the vertex determines
/// to the last digits: each of them passes the vertex on the side of the shorter turn, of at most
/// pi. The windows of these rays leave the fan of the vertex's faces; those at the edges inside it
/// go no further.
///
/// \param source the point: both ends are equal.
/// \param wedge into which it emits.
/// \param fan around it, with the side and the angle of each ray.
/// \param result also receives the vertices of these faces that are near the point
///        (tolerance::NearVertex).
void addPointWindows(const TriangleMesh& mesh, const SourceInFace& source, const CurveWedge& wedge,
  const FanAround& fan, SourceWindows& result);

}

#endif
