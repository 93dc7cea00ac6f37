// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/ViolationQueue.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

// The least error in a batch as a fraction of the worst. A leaf that is refined too early might
// have been mended by a split beside it; with a larger fraction there are more steps between ranks.
constexpr double NearWorst = 0.5;

// The fraction if there is not room for all, so that it goes to the worst leaves.
constexpr double NearWorstWithLittleRoom = 0.9;

} // anonymous namespace

bool ViolationQueue::isOpen(const Violation& violation) const
{
  return this->triangles_.isLeaf(violation.triangle) &&
    this->triangles_.splitEdges(violation.triangle) == violation.splitEdges;
}

bool ViolationQueue::isAnyOpen()
{
  while (!this->waiting_.empty() && !this->isOpen(this->waiting_.top()))
  {
    this->waiting_.pop();
  }
  return !this->waiting_.empty();
}

bool ViolationQueue::takeBatch()
{
  this->batch_.clear();
  this->worst_ = this->isAnyOpen() ? this->waiting_.top().error : 0.0;
  this->worst_ = this->surface_.exchange().largestOf(this->worst_);
  const double least = this->worst_ * (this->hasLittleRoom() ? NearWorstWithLittleRoom : NearWorst);
  const std::size_t most = this->surface_.isDistributed() ? NoLimit : 1;
  while (this->batch_.size() < most && this->isAnyOpen() && this->waiting_.top().error >= least)
  {
    this->batch_.push_back(this->waiting_.top());
    this->waiting_.pop();
  }
  this->keepShare();
  return this->worst_ > 0.0;
}

// Each rank keeps a share in proportion to its number of leaves.
void ViolationQueue::keepShare()
{
  const SumsOverRanks found = sumOverRanks(this->surface_.exchange(), this->batch_.size());
  this->batchOfAll_ = std::min(found.all, this->mostInBatch_);
  if (found.all <= this->mostInBatch_)
  {
    return;
  }
  const auto upTo = [&](std::uint64_t count)
  {
    const double fraction = static_cast<double>(count) / static_cast<double>(found.all);
    return static_cast<std::size_t>(std::floor(fraction * static_cast<double>(this->mostInBatch_)));
  };
  const std::size_t share = upTo(found.before + this->batch_.size()) - upTo(found.before);
  for (std::size_t i = share; i < this->batch_.size(); ++i)
  {
    this->waiting_.push(this->batch_[i]);
  }
  this->batch_.resize(share);
}

bool ViolationQueue::putBack()
{
  for (const Violation& violation : this->batch_)
  {
    this->waiting_.push(violation);
  }
  this->batch_.clear();
  this->mostInBatch_ = this->batchOfAll_ / 2;
  return this->mostInBatch_ > 0;
}

}
