// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/SurfaceCache.h"

namespace geodesic
{

void SurfaceCache::update(const std::vector<PolyDataBlock>& blocks, const BarrierArrays& barriers,
  bool mergeCoincidentPoints, Exchange& exchange, const ProgressCallback& progress)
{
  const ContentKey key = contentKey(blocks, barriers);
  const bool isKept = this->surface_ && this->key_ == key &&
    this->isMerged_ == mergeCoincidentPoints && this->exchange_ == &exchange;
  if (!exchange.isTrueAnywhere(!isKept))
  {
    this->surface_->useCellsOf(blocks);
    return;
  }
  this->release();
  this->surface_ = std::make_unique<PolyDataSurface>(
    readSurface(blocks, barriers, mergeCoincidentPoints, exchange, progress));
  this->locator_ = std::make_unique<PolylineLocator>(this->surface_->partition());
  this->key_ = key;
  this->isMerged_ = mergeCoincidentPoints;
  this->exchange_ = &exchange;
}

void SurfaceCache::release()
{
  this->joinedPaths_ = JoinedPaths();
  this->locator_.reset();
  this->surface_.reset();
}

}
