// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/SurfaceCache.h"

#include "PolyData/SurfaceReader.h"

namespace geodesic
{

void SurfaceCache::update(const std::vector<PolyDataBlock>& blocks, const BarrierArrays& barriers,
  bool mergeCoincidentPoints, const ProgressCallback& progress)
{
  const ContentKey key = contentKey(blocks, barriers);
  if (this->surface_ && this->key_ == key && this->isMerged_ == mergeCoincidentPoints)
  {
    this->surface_->useCellsOf(blocks);
    return;
  }
  this->release();
  this->surface_ = std::make_unique<PolyDataSurface>(
    readSurface(blocks, barriers, mergeCoincidentPoints, progress));
  this->locator_ = std::make_unique<PolylineLocator>(this->surface_->mesh());
  this->key_ = key;
  this->isMerged_ = mergeCoincidentPoints;
}

void SurfaceCache::release()
{
  this->joinedPaths_ = JoinedPaths();
  this->locator_.reset();
  this->surface_.reset();
}

}
