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

/// Makes one surface of all blocks of all ranks, which call this together: triangulates polygons
/// and strips, and merges the points that lie at exactly one place.
///
/// \param blocks the vtkPolyData that this rank has of the surface. They are not changed.
/// \param barriers of these blocks.
/// \param mergeCoincidentPoints whether points are merged. Blocks are not connected otherwise.
/// \param exchange must outlive the surface.
/// \param progress called now and then with a fraction done; returning false throws Aborted.
/// \throws MeshError if no face is left that is not a barrier, a coordinate is not finite or a cell
///         names a point that does not exist; MeshTooLarge; Aborted.
PolyDataSurface readSurface(const std::vector<PolyDataBlock>& blocks, const BarrierArrays& barriers,
  bool mergeCoincidentPoints, Exchange& exchange = OneRank::instance(),
  const ProgressCallback& progress = {});

}

#endif
