// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Cracks_h
#define geodesic_Cracks_h

#include "PolyData/reading/PolyDataSurface.h"
#include "mesh/MeshPartition.h"

namespace geodesic
{

/// Finds what looks like a crack: edges of the boundary that lie beside an edge of another face, by
/// their middles, within tolerance::CrackWidth and CrackFraction. All ranks call this together.
///
/// \param diagonal of the whole surface.
/// \param report gets the number of these edges on this rank, and how far apart they are at most.
void findCracks(const MeshPartition& partition, double diagonal, SurfaceReport& report);

}

#endif
