// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexQueue_h
#define geodesic_VertexQueue_h

#include "Types.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <vector>

namespace geodesic
{

/// The vertices that wait, ordered by key and taken in batches of similar keys. Entries never
/// change: a vertex is pushed again with its new key, and its owner decides which entry is current.
///
/// Entries within the next few batches are unsorted and scanned, which is faster than a heap.
/// Farther entries, as at the ends of edges much longer than those at the front, wait in a heap.
class VertexQueue
{
public:
  struct Entry
  {
    double key;
    Id vertex;

    bool operator>(const Entry& other) const
    {
      return this->key != other.key ? this->key > other.key : this->vertex > other.vertex;
    }
  };

  void push(double key, Id vertex)
  {
    if (key <= this->horizon_)
    {
      this->near_.push_back({ key, vertex });
    }
    else
    {
      this->far_.push({ key, vertex });
    }
  }

  /// The next batch: the least key of a current entry, and the last key of its batch, which is at
  /// most the end of any current entry's reach. Both are infinite if there is no entry.
  struct Outlook
  {
    double least = Infinity;
    double last = Infinity;
  };

  /// \param isCurrent (const Entry&) -> bool.
  /// \param reachOf (Id vertex) -> how much larger than the vertex's key the keys in its batch may
  ///        be.
  template <typename IsCurrent, typename ReachOf>
  Outlook outlook(const IsCurrent& isCurrent, const ReachOf& reachOf)
  {
    for (;;)
    {
      Outlook next;
      std::size_t kept = 0;
      for (const Entry& entry : this->near_)
      {
        if (isCurrent(entry))
        {
          next.least = std::min(next.least, entry.key);
          if (entry.key <= next.last)
          {
            next.last = std::min(next.last, entry.key + reachOf(entry.vertex));
          }
          this->near_[kept++] = entry;
        }
      }
      this->near_.resize(kept);
      // Beyond the horizon may be an entry whose reach ends before the batch does.
      if (next.last <= this->horizon_ || this->far_.empty())
      {
        return next;
      }
      this->comeNear(reachOf);
    }
  }

  /// Removes the current entries up to a key.
  ///
  /// \param take (Id vertex) is called for each.
  template <typename IsCurrent, typename Take>
  void takeBatch(double last, const IsCurrent& isCurrent, const Take& take)
  {
    std::size_t kept = 0;
    for (const Entry& entry : this->near_)
    {
      if (entry.key > last)
      {
        this->near_[kept++] = entry;
      }
      else if (isCurrent(entry))
      {
        take(entry.vertex);
      }
    }
    this->near_.resize(kept);
  }

  /// Calls visit(const Entry&) for each entry, current or not, in any order.
  template <typename Visit>
  void forEach(const Visit& visit) const
  {
    std::for_each(this->near_.begin(), this->near_.end(), visit);
    std::for_each(this->far_.entries().begin(), this->far_.entries().end(), visit);
  }

private:
  template <typename ReachOf>
  void comeNear(const ReachOf& reachOf)
  {
    constexpr double batches = 16.0; // most vertices wait for two to four
    const Entry& first = this->far_.top();
    this->horizon_ = first.key + batches * reachOf(first.vertex);
    while (!this->far_.empty() && this->far_.top().key <= this->horizon_)
    {
      this->near_.push_back(this->far_.top());
      this->far_.pop();
    }
  }

  /// A priority queue that can be scanned.
  struct Heap : std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>
  {
    const std::vector<Entry>& entries() const { return this->c; }
  };

  std::vector<Entry> near_;
  Heap far_;
  double horizon_ = 0.0;
};

}

#endif
