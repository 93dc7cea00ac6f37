// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CutSourceFaces_h
#define geodesic_CutSourceFaces_h

#include "source/PolylineOnSurface.h"

#include <vector>

namespace geodesic
{

/// Removes faces without area, unless none has an area, and cuts the others at their points, as
/// those of a surface (removeFacesWithoutArea()).
///
/// \returns for each face that is left its parts: itself unless it is cut.
std::vector<std::vector<LocatedPolyline>> cutAtFacesWithoutArea(
  std::vector<LocatedPolyline>& faces);

}

#endif
