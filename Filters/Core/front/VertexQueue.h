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
    Outlook next;
    const auto include = [&](const Entry& entry)
    {
      next.least = std::min(next.least, entry.key);
      if (entry.key <= next.last)
      {
        next.last = std::min(next.last, entry.key + reachOf(entry.vertex));
      }
    };
    std::size_t kept = 0;
    for (const Entry& entry : this->near_)
    {
      if (isCurrent(entry))
      {
        include(entry);
        this->near_[kept++] = entry;
      }
    }
    this->near_.resize(kept);
    if (!this->far_.empty() && this->far_.top().key <= next.last)
    {
      this->comeNear(next, isCurrent, include);
    }
    return next;
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
  // Farther entries up to the end of the batch may have a reach that ends before it. Those of the
  // next few batches come along.
  template <typename IsCurrent, typename Include>
  void comeNear(const Outlook& next, const IsCurrent& isCurrent, const Include& include)
  {
    constexpr double batches = 4.0; // most vertices wait for two to four
    double horizon = next.last;
    while (!this->far_.empty() && this->far_.top().key <= horizon)
    {
      const Entry entry = this->far_.top();
      this->far_.pop();
      if (isCurrent(entry))
      {
        this->near_.push_back(entry);
        include(entry);
        horizon = next.last + batches * (next.last - next.least);
      }
    }
    // Without a current entry no batch tells how far to look.
    this->horizon_ = horizon < Infinity ? horizon : this->horizon_;
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
