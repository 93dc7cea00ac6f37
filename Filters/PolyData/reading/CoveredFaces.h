// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CoveredFaces_h
#define geodesic_CoveredFaces_h

#include "Job.h"
#include "PolyData/reading/SourceParts.h"

namespace geodesic
{

/// Finds the faces of a surface, of all ranks, that each face of a source consists of within the
/// precision of coordinates (SourceFace::covered). If it is a cell of the surface, which may have
/// been cut, these are the cell's own faces, whatever else lies on it; otherwise all that lie in
/// it, if they fill it. A source's face that also lies in parts of other faces has none. All ranks
/// call this together, and get the same.
///
/// \param cells with faces, which have triangles. A source's faces that lie in barriers, which are
///        no faces of the surface, are left out: a face that the surface has is what it is there;
///        any other is what is closest to a point inside of it.
/// \throws InputError if they are all of the source; Aborted.
void placeFaces(const PartsRequest& from, const Job& job, SourceCells& cells);

}

#endif
