// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolineJoin_h
#define geodesic_IsolineJoin_h

#include "contours/FaceIsolines.h"
#include "contours/Isolines.h"

#include <vector>

namespace geodesic
{

/// Joins the pieces of isolines where exactly two of them meet, whatever faces they are in. The
/// lines have no chords of hardly any length.
///
/// \param levels the values.
/// \param onEdges the points on edges; their ids are the first ones.
/// \param atSeams the ids of those where the lines of other ranks continue, ascending: lines end
///        there.
/// \param drawn the pieces of some faces each, those of lower faces first.
/// \throws Error if there are too many points.
Isolines joinPieces(const TriangleMesh& mesh, const std::vector<double>& levels,
  std::vector<SurfacePoint> onEdges, const std::vector<Id>& atSeams,
  std::vector<IsolinePieces> drawn);

}

#endif
