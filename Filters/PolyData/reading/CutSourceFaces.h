// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CutSourceFaces_h
#define geodesic_CutSourceFaces_h

#include "PolyData/reading/SourceCells.h"

#include <vector>

namespace geodesic
{

/// Removes faces without area, unless none has an area, and cuts the others at their points, as
/// those of a surface (removeFacesWithoutArea()): SourceFace::parts become the parts, or the face
/// itself where it is not cut.
void cutAtFacesWithoutArea(std::vector<SourceFace>& faces);

}

#endif
