// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaitingLists_h
#define geodesic_WaitingLists_h

#include "window/WindowPool.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// The windows that wait on halfedges: at most one sorted list per halfedge, each in one block,
/// with links by which the caller chains lists. Only halfedges along the front have lists, so a
/// hash table holds them, not an array of all halfedges.
class WaitingLists
{
public:
  /// In an order of members that leaves no gaps: there are very many.
  struct List
  {
    WindowBlock windows;
    Id halfedge;
    /// The caller's link to another list.
    Id next = NoId;
    /// The distance at which the list passes, whether or not the front has reached its vertex;
    /// infinite if the list waits for the vertex.
    double due = Infinity;
  };

  /// The number of a halfedge's list; NoId if it has none.
  Id find(Id halfedge) const
  {
    if (this->count_ == 0)
    {
      return NoId;
    }
    std::size_t slot = this->homeOf(halfedge);
    while (this->table_[slot] != NoId && this->lists_[this->table_[slot]].halfedge != halfedge)
    {
      slot = (slot + 1) & this->mask();
    }
    return this->table_[slot];
  }

  /// Adds a list to a halfedge that has none, in front of another list of the caller's chain.
  /// \returns the list's number.
  Id add(Id halfedge, const WindowBlock& block, Id next = NoId)
  {
    if (2 * (this->count_ + 1) > this->table_.size())
    {
      this->grow();
    }
    if (this->unused_ == NoId)
    {
      this->unused_ = static_cast<Id>(this->lists_.size());
      this->lists_.emplace_back();
    }
    const Id list = this->unused_;
    this->unused_ = this->lists_[list].next;
    this->lists_[list] = { block, halfedge, next };
    this->enter(list);
    ++this->count_;
    return list;
  }

  /// Removes a list. Its block now belongs to the caller.
  WindowBlock remove(Id list)
  {
    std::size_t gap = this->homeOf(this->lists_[list].halfedge);
    while (this->table_[gap] != list)
    {
      gap = (gap + 1) & this->mask();
    }
    // Lists behind the gap move forward if their probe sequences allow it, so that find() never
    // stops at a gap before them (Knuth, 6.4, algorithm R).
    for (std::size_t slot = (gap + 1) & this->mask(); this->table_[slot] != NoId;
         slot = (slot + 1) & this->mask())
    {
      const std::size_t home = this->homeOf(this->lists_[this->table_[slot]].halfedge);
      if (((slot - home) & this->mask()) >= ((slot - gap) & this->mask()))
      {
        this->table_[gap] = this->table_[slot];
        gap = slot;
      }
    }
    this->table_[gap] = NoId;
    --this->count_;
    this->lists_[list].next = this->unused_;
    this->unused_ = list;
    return this->lists_[list].windows;
  }

  std::size_t size() const { return this->count_; }
  const List& operator[](Id list) const { return this->lists_[list]; }
  List& operator[](Id list) { return this->lists_[list]; }
  /// Replaces the list by a copy of other windows.
  void assign(Id list, WindowRange windows, WindowPool& pool)
  {
    WindowBlock& block = this->lists_[list].windows;
    if (windows.size() <= (std::size_t(1) << block.sizeClass))
    {
      std::copy(windows.begin(), windows.end(), block.data);
      block.size = static_cast<std::uint32_t>(windows.size());
      return;
    }
    const WindowBlock larger = pool.copyOf(windows);
    pool.free(block);
    block = larger;
  }

  /// Calls visit(const List&) for each list, in any order.
  template <typename Visit>
  void forEach(Visit&& visit) const
  {
    for (const Id list : this->table_)
    {
      if (list != NoId)
      {
        visit(this->lists_[list]);
      }
    }
  }

private:
  std::size_t mask() const { return this->table_.size() - 1; }
  std::size_t homeOf(Id halfedge) const
  {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15U; // Fibonacci hashing (Knuth, 6.4)
    return (halfedge * golden) >> this->shift_;
  }

  void enter(Id list)
  {
    std::size_t slot = this->homeOf(this->lists_[list].halfedge);
    while (this->table_[slot] != NoId)
    {
      slot = (slot + 1) & this->mask();
    }
    this->table_[slot] = list;
  }

  void grow()
  {
    --this->shift_;
    std::vector<Id> old(std::size_t(1) << (64 - this->shift_), NoId);
    old.swap(this->table_);
    for (const Id list : old)
    {
      if (list != NoId)
      {
        this->enter(list);
      }
    }
  }

  std::vector<List> lists_;
  /// Removed lists, chained.
  Id unused_ = NoId;
  /// The numbers of the lists, hashed by halfedge with linear probing. At most half full; the size
  /// is a power of two: the hash's bits from this one on are a place. The first table has 32
  /// places.
  std::vector<Id> table_;
  unsigned shift_ = 60;
  std::size_t count_ = 0;
};

}

#endif
