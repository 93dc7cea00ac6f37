// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ViolationQueue_h
#define geodesic_ViolationQueue_h

#include "mesh/MeshPartition.h"
#include "refinement/RedGreenMesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

namespace geodesic
{

/// A leaf over the tolerance, with the number of points on its edges at that time.
struct Violation
{
  double error;
  Id triangle;
  Id pointsOnEdges;
  double limit;
  bool operator<(const Violation& other) const
  {
    return this->error != other.error ? this->error < other.error : this->triangle > other.triangle;
  }
};

/// The leaves over the tolerance, and the selection of those to refine next: the worst one. If
/// ranks refine together, it is a batch of leaves that are nearly as bad as the worst of all ranks,
/// so that there are few steps; a batch that was too large is tried again with half as many leaves.
class ViolationQueue
{
public:
  /// Both arguments must outlive this.
  ViolationQueue(const RedGreenMesh& triangles, const MeshPartition& surface)
    : triangles_(triangles)
    , surface_(surface)
  {
  }

  void push(double error, Id leaf, double limit)
  {
    this->waiting_.push({ error, leaf, this->triangles_.pointsOnEdges(leaf), limit });
  }
  /// Whether the leaf was neither split nor assessed again since.
  bool isOpen(const Violation& violation) const
  {
    return this->triangles_.isLeaf(violation.triangle) &&
      this->triangles_.pointsOnEdges(violation.triangle) == violation.pointsOnEdges;
  }

  /// A collective call of all ranks, which makes the next batch. \returns false if no rank has any
  /// left.
  bool takeBatch()
  {
    this->batch_.clear();
    this->worst_ = this->isAnyOpen() ? this->waiting_.top().error : 0.0;
    this->worst_ = this->surface_.exchange().largestOf(this->worst_);
    const bool hasRoom = this->mostInBatch_ == NoLimit;
    const double least = this->worst_ * (hasRoom ? NearWorst : NearWorstWithLittleRoom);
    const std::size_t most = this->surface_.isDistributed() ? NoLimit : 1;
    while (this->batch_.size() < most && this->isAnyOpen() && this->waiting_.top().error >= least)
    {
      this->batch_.push_back(this->waiting_.top());
      this->waiting_.pop();
    }
    this->keepShare();
    return this->worst_ > 0.0;
  }

  /// This rank's leaves in the batch, the worst first.
  const std::vector<Violation>& batch() const { return this->batch_; }
  /// The largest error in the batch, over all ranks.
  double worst() const { return this->worst_; }

  /// Puts back a batch that was too large, once the mesh is rolled back. \returns whether a smaller
  /// one can be tried.
  bool putBack()
  {
    for (const Violation& violation : this->batch_)
    {
      this->waiting_.push(violation);
    }
    this->batch_.clear();
    this->mostInBatch_ = this->batchOfAll_ / 2;
    return this->mostInBatch_ > 0;
  }

  /// Calls visit(violation) for each open one, and clears the queue.
  template <typename Visit>
  void takeAll(Visit&& visit)
  {
    for (; !this->waiting_.empty(); this->waiting_.pop())
    {
      if (this->isOpen(this->waiting_.top()))
      {
        visit(this->waiting_.top());
      }
    }
  }

private:
  /// The least error in a batch as a fraction of the worst. A leaf that is refined too early might
  /// have been mended by a split beside it; with a larger fraction there are more steps between
  /// ranks.
  static constexpr double NearWorst = 0.5;
  /// The fraction if there is not room for all, so that it goes to the worst leaves.
  static constexpr double NearWorstWithLittleRoom = 0.9;
  static constexpr std::uint64_t NoLimit = std::numeric_limits<std::uint64_t>::max();

  bool isAnyOpen()
  {
    while (!this->waiting_.empty() && !this->isOpen(this->waiting_.top()))
    {
      this->waiting_.pop();
    }
    return !this->waiting_.empty();
  }

  /// Each rank keeps a share in proportion to its number of leaves.
  void keepShare()
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
      return static_cast<std::size_t>(
        std::floor(fraction * static_cast<double>(this->mostInBatch_)));
    };
    const std::size_t share = upTo(found.before + this->batch_.size()) - upTo(found.before);
    for (std::size_t i = share; i < this->batch_.size(); ++i)
    {
      this->waiting_.push(this->batch_[i]);
    }
    this->batch_.resize(share);
  }

  const RedGreenMesh& triangles_;
  const MeshPartition& surface_;
  std::priority_queue<Violation> waiting_;
  std::vector<Violation> batch_;
  double worst_ = 0.0;
  /// The number of leaves in the batch on all ranks, and its maximum.
  std::uint64_t batchOfAll_ = 0;
  std::uint64_t mostInBatch_ = NoLimit;
};

}

#endif
