// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceFaces_h
#define geodesic_SourceFaces_h

#include "source/PolylineOnSurface.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// The numbers of each face's corners: points at one place have one number, in the order of their
/// first corners.
std::vector<std::vector<std::uint64_t>> numberCorners(const std::vector<LocatedPolyline>& faces);

/// The first point of a face, as a polyline of one point.
LocatedPolyline firstPointOf(const LocatedPolyline& face);

/// Makes regions of the faces of a source. Its outline are the edges that one of its faces uses,
/// joined to polylines; each runs in the direction of most of its edges in their faces, so that the
/// region lies to its left. A face that is given twice counts once. A closed region has no outline:
/// its first point stands for it.
///
/// Faces with one value are one region. If faces are joined, so are those with a common edge. Edges
/// are the same if the coordinates of their ends are equal and are one vertex.
///
/// \param faces closed polylines that are not located yet. LocatedPolyline::source
///        becomes that of the region's first face.
/// \param values of each face.
/// \param polylines the outlines follow these.
void makeRegions(std::vector<LocatedPolyline>& faces, const std::vector<vtkIdType>& values,
  bool areJoined, std::vector<LocatedPolyline>& polylines);

}

#endif
