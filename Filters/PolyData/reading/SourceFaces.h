// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceFaces_h
#define geodesic_SourceFaces_h

#include "PolyData/reading/SourceCells.h"

#include <vector>

namespace geodesic
{

/// Removes faces without area, unless none has an area, and cuts the others at their points, as
/// those of a surface (removeFacesWithoutArea()): SourceFace::parts become the parts, or the face
/// itself where it is not cut.
void cutAtFacesWithoutArea(std::vector<SourceFace>& faces);

/// Makes regions of the faces of a source. Its outline are the edges that one of its faces uses,
/// joined to polylines; each runs in the direction of most of its edges in their faces, so that the
/// region lies to its left. A face that is given twice counts once. A closed region has no outline:
/// its first point stands for it. The outlines follow the polylines of the source; each has
/// LocatedPolyline::source of the region's first face, as have all its faces.
///
/// Faces with one value are one region. If faces are joined, so are those with a common edge. Edges
/// are the same if the coordinates of their ends are equal and are one vertex.
void makeRegions(SourceCells& cells, bool areJoined);

}

#endif
