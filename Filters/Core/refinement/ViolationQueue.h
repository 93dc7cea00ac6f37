// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ViolationQueue_h
#define geodesic_ViolationQueue_h

#include "mesh/MeshPartition.h"
#include "refinement/RedGreenMesh.h"

#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

namespace geodesic
{

/// A leaf over the tolerance, with its number of split edges at that time.
struct Violation
{
  double error;
  Id triangle;
  Id splitEdges;
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

  void push(const Violation& violation) { this->waiting_.push(violation); }
  /// Whether the leaf was neither split nor assessed again since.
  bool isOpen(const Violation& violation) const;

  /// A collective call of all ranks, which makes the next batch. \returns false if no rank has any
  /// left.
  bool takeBatch();
  /// This rank's leaves in the batch, the worst first.
  const std::vector<Violation>& batch() const { return this->batch_; }
  /// The largest error in the batch, over all ranks.
  double worst() const { return this->worst_; }

  /// Puts back a batch that was too large, once the mesh is rolled back. \returns whether a smaller
  /// one can be tried.
  bool putBack();

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
  static constexpr std::uint64_t NoLimit = std::numeric_limits<std::uint64_t>::max();

  bool hasLittleRoom() const { return this->mostInBatch_ < NoLimit; }
  bool isAnyOpen();
  void keepShare();

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
