// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceReader_h
#define geodesic_SurfaceReader_h

#include "Exchange.h"
#include "Job.h"
#include "PolyData/reading/PolyDataSurface.h"

#include <vector>

namespace geodesic
{

/// Which points of a surface are one vertex.
struct PointMerging
{
  /// Those at one place, and those on the boundary that differ by roundings. Blocks are not
  /// connected otherwise.
  bool isWanted = true;
  /// Those on the boundary that are not farther apart than this, too.
  double tolerance = 0.0;

  bool operator==(const PointMerging& other) const
  {
    return this->isWanted == other.isWanted && this->tolerance == other.tolerance;
  }
};

/// Makes one surface of all blocks of all ranks, which call this together: triangulates polygons
/// and strips, and merges points.
///
/// \param blocks the vtkPolyData that this rank has of the surface. They are not changed.
/// \param exchange must outlive the surface.
/// \throws MeshError if no face is left that is not a barrier; InputError if a coordinate is not
///         finite or a cell names a point that does not exist; MeshTooLarge; Aborted.
PolyDataSurface readSurface(const std::vector<PolyDataBlock>& blocks, const PointMerging& merging,
  Exchange& exchange = OneRank::instance(), const Job& job = {});

}

#endif
