// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceCache_h
#define geodesic_SurfaceCache_h

#include "Job.h"
#include "PolyData/Hash.h"
#include "PolyData/PolyDataBlocks.h"
#include "PolyData/reading/SurfaceReader.h"
#include "paths/JoinPoints.h"
#include "source/PolylineLocator.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// A fingerprint of all that the structure of a surface depends on: the coordinates, the cells, and
/// the arrays of ghost cells, global ids and barriers of each block. Two surfaces with one key are
/// taken to be the same.
///
/// Values are read, not times of modification: values changed in place, followed by Modified() on
/// the data set, change no time of its points or cells. Reading takes a few percent of what
/// building the structure takes.
Fingerprint contentKey(const std::vector<PolyDataBlock>& blocks);

/// Keeps the surface of the last execution for the next one, with its locator and the paths that
/// joined far points of curves.
class SurfaceCache
{
public:
  /// Reads the surface, unless the one that is kept is the same, by contentKey().
  ///
  /// \param exchange see readSurface(). All ranks keep theirs or none does.
  /// \throws what readSurface() throws; nothing is kept then.
  void update(const std::vector<PolyDataBlock>& blocks, const PointMerging& merging,
    Exchange& exchange, const Job& job);

  /// What update() has read. Valid until the next update() or release().
  const PolyDataSurface& surface() const { return *this->surface_; }
  PolylineLocator& locator() const { return *this->locator_; }
  /// The paths between far points of curves on it.
  JoinedPaths& joinedPaths() { return this->joinedPaths_; }

  /// Keeps a surface of as many blocks, without points.
  const PolyDataSurface& keepNothing(std::size_t numberOfBlocks);
  /// Frees the memory.
  void release();

private:
  std::unique_ptr<PolyDataSurface> surface_;
  std::unique_ptr<PolylineLocator> locator_;
  JoinedPaths joinedPaths_;
  /// What the surface was made from.
  Fingerprint key_{};
  PointMerging merging_;
  const Exchange* exchange_ = nullptr;
};

}

#endif
