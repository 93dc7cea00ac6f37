// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexSchedule_h
#define geodesic_VertexSchedule_h

#include "front/VertexStates.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace geodesic
{

/// The batch that the front processes, the same in all districts.
struct Batch
{
  Id number = 0;
  /// The key at which the batch begins, and its last one: what lies beyond that waits.
  double key = 0.0;
  double last = Infinity;
};

/// The vertices that wait, in the order of their keys. They are processed in batches of nearly
/// equal distance, the nearest first.
///
/// The keys are in a heap in which each vertex has four children, which are side by side in memory.
/// Each vertex knows its slot in it (VertexState::slot), so that its key can fall where it is.
class VertexSchedule
{
public:
  /// \param batch the current one, which the front moves on.
  VertexSchedule(VertexStates& states, const Batch& batch)
    : states_(states)
    , batch_(batch)
  {
  }

  /// Adds a vertex that has to be processed, or whose lists have to pass. If it waits already, the
  /// smaller distance counts.
  ///
  /// \param distance at which this has to happen.
  void add(Id vertex, double distance)
  {
    // Windows that come to a vertex behind the front continue with the front, in the same batches.
    const double key = std::max(distance, this->batch_.key);
    const VertexState& state = this->states_[vertex];
    if (state.hasPassed && distance >= state.distance)
    {
      return; // it waits at its distance
    }
    if (state.waits == VertexState::Waits::InHeap)
    {
      if (key < this->heap_[state.slot].key)
      {
        this->rise(state.slot, { key, vertex });
      }
    }
    else if (state.waits == VertexState::Waits::No && key > this->batch_.key)
    {
      this->states_[vertex].waits = VertexState::Waits::InHeap;
      this->heap_.emplace_back();
      this->rise(this->heap_.size() - 1, { key, vertex });
    }
    else if (state.waits == VertexState::Waits::No)
    {
      this->states_[vertex].waits = VertexState::Waits::Behind;
      this->behind_.push_back(vertex);
    }
  }

  /// Lets a vertex of the current batch whose lists have passed wait again, until the front comes
  /// to its distance, which may still fall. Its width does not limit that batch.
  void addPassed(Id vertex) { this->passed_.push_back(vertex); }

  /// The next batch: the least key of a waiting vertex, and the last key of its batch, which is at
  /// most the key of any waiting vertex plus its batch width. Both are infinite if no vertex waits.
  struct Outlook
  {
    double least = Infinity;
    double last = Infinity;
  };
  Outlook outlook() const
  {
    Outlook next;
    if (!this->heap_.empty())
    {
      next.least = this->heap_.front().key;
      this->limitByWidths(0, next.last);
    }
    for (const Id vertex : this->passed_)
    {
      next.least = std::min(next.least, std::max(this->batch_.key, this->states_[vertex].distance));
    }
    for (const Id vertex : this->behind_)
    {
      next.least = this->batch_.key;
      next.last = std::min(next.last, this->batch_.key + this->batchWidthOf(vertex));
    }
    return next;
  }

  /// Removes the vertices of the batch.
  void takeBatch(std::vector<Id>& batch)
  {
    const double last = this->batch_.last;
    batch.assign(this->behind_.begin(), this->behind_.end());
    this->takePassed(batch);
    for (const Id vertex : this->behind_)
    {
      this->states_[vertex].waits = VertexState::Waits::No;
    }
    this->behind_.clear();
    while (!this->heap_.empty() && this->heap_.front().key <= last)
    {
      batch.push_back(this->heap_.front().vertex);
      this->states_[batch.back()].waits = VertexState::Waits::No;
      const WaitingVertex moved = this->heap_.back();
      this->heap_.pop_back();
      if (!this->heap_.empty())
      {
        this->sink(0, moved);
      }
    }
  }

  /// Lets all vertices wait in other schedules instead: scheduleOf(vertex).
  template <typename ScheduleOf>
  void handOver(const ScheduleOf& scheduleOf)
  {
    for (const WaitingVertex& waiting : this->heap_)
    {
      VertexSchedule& to = scheduleOf(waiting.vertex);
      to.heap_.emplace_back();
      to.rise(to.heap_.size() - 1, waiting);
    }
    for (const Id vertex : this->behind_)
    {
      scheduleOf(vertex).behind_.push_back(vertex);
    }
    for (const Id vertex : this->passed_)
    {
      scheduleOf(vertex).passed_.push_back(vertex);
    }
    this->heap_.clear();
    this->behind_.clear();
    this->passed_.clear();
  }

  /// Whether some waiting vertex satisfies a condition: (Id vertex) -> bool.
  template <typename Condition>
  bool isAnyWaiting(const Condition& condition) const
  {
    return std::any_of(this->behind_.begin(), this->behind_.end(), condition) ||
      std::any_of(this->passed_.begin(), this->passed_.end(), condition) ||
      std::any_of(this->heap_.begin(), this->heap_.end(),
        [&condition](const WaitingVertex& waiting) { return condition(waiting.vertex); });
  }

private:
  struct WaitingVertex
  {
    double key;
    Id vertex;
  };

  static constexpr std::size_t Children = 4;
  static std::size_t parentOf(std::size_t slot) { return (slot - 1) / Children; }
  static std::size_t firstChildOf(std::size_t slot) { return Children * slot + 1; }

  // Adds the vertices whose lists have passed, but for those that are in the batch anyway.
  void takePassed(std::vector<Id>& batch)
  {
    const double last = this->batch_.last;
    const auto isBeyond = [this, last](Id vertex) { return this->states_[vertex].distance > last; };
    const auto taken = std::partition(this->passed_.begin(), this->passed_.end(), isBeyond);
    std::copy_if(taken, this->passed_.end(), std::back_inserter(batch),
      [this, last](Id vertex)
      {
        const VertexState& state = this->states_[vertex];
        return state.waits == VertexState::Waits::No ||
          (state.waits == VertexState::Waits::InHeap && this->heap_[state.slot].key > last);
      });
    this->passed_.erase(taken, this->passed_.end());
  }

  double batchWidthOf(Id vertex) const
  {
    return static_cast<double>(this->states_[vertex].batchWidth);
  }

  // No vertex below another has a smaller key.
  void limitByWidths(std::size_t slot, double& last) const
  {
    const WaitingVertex& waiting = this->heap_[slot];
    if (waiting.key >= last)
    {
      return;
    }
    last = std::min(last, waiting.key + this->batchWidthOf(waiting.vertex));
    const std::size_t first = firstChildOf(slot);
    for (std::size_t i = first; i < std::min(first + Children, this->heap_.size()); ++i)
    {
      this->limitByWidths(i, last);
    }
  }

  void put(std::size_t slot, const WaitingVertex& waiting)
  {
    this->heap_[slot] = waiting;
    this->states_[waiting.vertex].slot = static_cast<Id>(slot);
  }

  // Puts a vertex into a slot, or higher if its key is less than those above.
  void rise(std::size_t slot, const WaitingVertex& waiting)
  {
    while (slot > 0 && waiting.key < this->heap_[parentOf(slot)].key)
    {
      this->put(slot, this->heap_[parentOf(slot)]);
      slot = parentOf(slot);
    }
    this->put(slot, waiting);
  }

  // Puts a vertex into a slot, or lower if a key below is less.
  void sink(std::size_t slot, const WaitingVertex& waiting)
  {
    const WaitingVertex* const heap = this->heap_.data();
    const std::size_t size = this->heap_.size();
    for (std::size_t first = firstChildOf(slot); first < size; first = firstChildOf(slot))
    {
      const std::size_t least =
        first + Children <= size ? leastOfAll(heap, first) : leastOf(heap, first, size);
      if (!(heap[least].key < waiting.key))
      {
        break;
      }
      this->put(slot, heap[least]);
      slot = least;
    }
    this->put(slot, waiting);
  }

  // The first of the vertices with the least key.
  static std::size_t leastOf(const WaitingVertex* heap, std::size_t first, std::size_t end)
  {
    std::size_t least = first;
    for (std::size_t i = first + 1; i < end; ++i)
    {
      least = heap[i].key < heap[least].key ? i : least;
    }
    return least;
  }
  // The same of all children.
  static std::size_t leastOfAll(const WaitingVertex* heap, std::size_t first)
  {
    const std::size_t a = heap[first + 1].key < heap[first].key ? first + 1 : first;
    const std::size_t b = heap[first + 3].key < heap[first + 2].key ? first + 3 : first + 2;
    return heap[b].key < heap[a].key ? b : a;
  }

  VertexStates& states_;
  const Batch& batch_;
  /// Vertices ahead of the front, and those at or behind it.
  std::vector<WaitingVertex> heap_;
  std::vector<Id> behind_;
  /// Vertices whose lists have passed. They may wait for others, too.
  std::vector<Id> passed_;
};

}

#endif
