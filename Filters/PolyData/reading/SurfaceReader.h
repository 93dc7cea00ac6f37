// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceReader_h
#define geodesic_SurfaceReader_h

#include "Exchange.h"
#include "PolyData/PolyDataBlocks.h"
#include "PolyData/reading/BarrierArrays.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "Progress.h"

namespace geodesic
{

/// Makes one surface of all blocks: triangulates polygons and strips, and merges the points that
/// lie at exactly one place.
///
/// \param blocks the vtkPolyData of the surface, which stay as they are.
/// \param barriers of these blocks.
/// \param mergeCoincidentPoints whether points are merged; blocks are not connected without that.
/// \param progress called now and then with a fraction done; returning false throws Aborted.
/// \param exchange where the blocks are one rank's piece of a surface that several ranks have
///        together, which all read it now; else null. It must outlive the surface.
/// \throws MeshError where there is no face that is no barrier, a coordinate is not finite or a
/// cell names a point that
///         does not exist; MeshTooLarge; Aborted.
PolyDataSurface readSurface(const std::vector<PolyDataBlock>& blocks, const BarrierArrays& barriers,
  bool mergeCoincidentPoints, Exchange* exchange, const ProgressCallback& progress = {});

}

#endif
