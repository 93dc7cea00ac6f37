// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/SurfaceCache.h"

#include "PolyData/SurfaceReader.h"

#include "vtkDataObject.h"

namespace geodesic
{

void SurfaceCache::update(vtkDataObject* input, const std::vector<PolyDataBlock>& blocks,
  bool mergeCoincidentPoints, const ProgressCallback& progress)
{
  if (this->surface_ && this->input_ == input && this->time_ == input->GetMTime() &&
    this->isMerged_ == mergeCoincidentPoints)
  {
    return;
  }
  this->release();
  this->surface_ =
    std::make_unique<PolyDataSurface>(readSurface(blocks, mergeCoincidentPoints, progress));
  this->locator_ = std::make_unique<SurfaceLocator>(this->surface_->mesh());
  this->isNoteDue_ = true;
  this->input_ = input;
  this->time_ = input->GetMTime();
  this->isMerged_ = mergeCoincidentPoints;
}

void SurfaceCache::release()
{
  this->locator_.reset();
  this->surface_.reset();
}

}
