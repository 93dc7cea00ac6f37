// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexSchedule_h
#define geodesic_VertexSchedule_h

#include "front/VertexQueue.h"
#include "front/VertexStates.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// Orders the processing of vertices: in batches of nearly equal distance, the nearest first.
class VertexSchedule
{
  auto isCurrent() const
  {
    return [this](const VertexQueue::Entry& entry)
    { return entry.key == this->states_[entry.vertex].key; };
  }
  auto reachOf() const
  {
    return [this](Id vertex) { return static_cast<double>(this->states_[vertex].reach); };
  }

public:
  explicit VertexSchedule(VertexStates& states)
    : states_(states)
  {
  }

  /// The key at which the last batch began: no path yet to be found is shorter.
  double key() const { return this->key_; }

  /// The last key of the current batch: what lies beyond it waits.
  double last() const { return this->last_; }

  /// Adds a vertex that has to be processed, or whose lists have to pass.
  ///
  /// \param distance at which this has to happen.
  void add(Id vertex, double distance)
  {
    // Windows that come to a vertex behind the front continue with the front, in the same batches.
    VertexState& state = this->states_[vertex];
    const double key = std::max(distance, this->key_);
    if (key < state.key)
    {
      state.key = key;
      if (key > this->key_)
      {
        this->queue_.push(key, vertex);
      }
      else
      {
        this->behind_.push_back(vertex);
      }
    }
  }

  /// The next batch: the least key of a waiting vertex, and the last key of its batch.
  using Outlook = VertexQueue::Outlook;
  Outlook outlook()
  {
    const auto reachOf = this->reachOf();
    Outlook next = this->queue_.outlook(this->isCurrent(), reachOf);
    for (const Id vertex : this->behind_)
    {
      next.least = this->key_;
      next.last = std::min(next.last, this->key_ + reachOf(vertex));
    }
    return next;
  }

  /// Moves on to the batch that begins at a key.
  void moveOn(double least) { this->key_ = std::max(this->key_, least); }

  /// Removes the vertices of the current batch, up to the last key.
  void takeBatch(double last, std::vector<Id>& batch)
  {
    batch.clear();
    this->last_ = last;
    const auto take = [this, &batch](Id vertex)
    {
      this->states_[vertex].key = Infinity;
      batch.push_back(vertex);
    };
    std::for_each(this->behind_.begin(), this->behind_.end(), take);
    this->behind_.clear();
    this->queue_.takeBatch(last, this->isCurrent(), take);
  }

  /// In the current batch, lets everything pass.
  void passAll() { this->last_ = Infinity; }

  /// Whether some waiting vertex satisfies a condition: (Id vertex) -> bool.
  template <typename Condition>
  bool isAnyWaiting(const Condition& condition) const
  {
    bool found = std::any_of(this->behind_.begin(), this->behind_.end(), condition);
    const auto isCurrent = this->isCurrent();
    this->queue_.forEach([&](const VertexQueue::Entry& entry)
      { found = found || (isCurrent(entry) && condition(entry.vertex)); });
    return found;
  }

private:
  VertexStates& states_;
  double key_ = 0.0;
  double last_ = Infinity;
  /// Vertices ahead of the front, and those at or behind it.
  VertexQueue queue_;
  std::vector<Id> behind_;
};

}

#endif
