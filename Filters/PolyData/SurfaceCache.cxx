// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/SurfaceCache.h"

#include "PolyData/reading/SurfaceReader.h"

namespace geodesic
{

void SurfaceCache::update(const std::vector<PolyDataBlock>& blocks, const BarrierArrays& barriers,
  bool mergeCoincidentPoints, Exchange* exchange, const ProgressCallback& progress)
{
  const ContentKey key = contentKey(blocks, barriers);
  bool isKept = this->surface_ && this->key_ == key && this->isMerged_ == mergeCoincidentPoints &&
    this->exchange_ == exchange;
  if (exchange)
  {
    isKept = !exchange->isTrueAnywhere(!isKept);
  }
  if (isKept)
  {
    this->surface_->useCellsOf(blocks);
    return;
  }
  this->release();
  this->surface_ = std::make_unique<PolyDataSurface>(
    readSurface(blocks, barriers, mergeCoincidentPoints, exchange, progress));
  this->locator_ = std::make_unique<PolylineLocator>(this->surface_->mesh());
  this->key_ = key;
  this->isMerged_ = mergeCoincidentPoints;
  this->exchange_ = exchange;
}

LocatorOnRanks& SurfaceCache::locatorOnRanks()
{
  if (!this->locatorOnRanks_)
  {
    this->locatorOnRanks_ = std::make_unique<LocatorOnRanks>(this->surface_->partition());
  }
  return *this->locatorOnRanks_;
}

void SurfaceCache::release()
{
  this->joinedPaths_ = JoinedPaths();
  this->locatorOnRanks_.reset();
  this->locator_.reset();
  this->surface_.reset();
}

}
