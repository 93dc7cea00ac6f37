// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaitingLists_h
#define geodesic_WaitingLists_h

#include "window/WindowPool.h"

#include <vector>

namespace geodesic
{

/// The windows that wait on halfedges: at most one sorted list a halfedge, each in one block, and a
/// link from list to list with which the caller chains those that belong together. Only a front's
/// width of them waits at a time, so that they are kept in a hash table, not one a halfedge.
class WaitingLists
{
public:
  /// The number of a halfedge's list; NoId where it has none.
  Id find(Id halfedge) const;
  /// Gives the halfedge, which has no list, this block as its list. \returns the list's number.
  Id add(Id halfedge, const WindowBlock& block);
  /// Takes the list away; its block is the caller's.
  WindowBlock remove(Id list);

  Id halfedge(Id list) const { return this->lists_[list].halfedge; }
  WindowRange at(Id list) const
  {
    const List& found = this->lists_[list];
    return { found.data, found.data + found.size };
  }
  /// Replaces the list by a copy of the windows, which must not be its own.
  void assign(Id list, const WindowRange& windows, WindowPool& pool);

  /// The list that the caller has linked this one to.
  Id next(Id list) const { return this->lists_[list].next; }
  void setNext(Id list, Id next) { this->lists_[list].next = next; }

  /// Calls visit(Id halfedge, const WindowBlock&) for each list, in no order.
  template <typename Visit>
  void forEach(Visit&& visit) const
  {
    for (const Id list : this->table_)
    {
      if (list != NoId)
      {
        visit(this->halfedge(list), this->blockOf(list));
      }
    }
  }

private:
  /// A block, packed together with the chain.
  struct List
  {
    Window* data = nullptr;
    std::uint32_t size : 27;
    std::uint32_t sizeClass : 5;
    Id halfedge = NoId;
    Id next = NoId;

    List()
      : size(0)
      , sizeClass(0)
    {
    }
  };

  WindowBlock blockOf(Id list) const;
  void setBlock(Id list, const WindowBlock& block);
  Id newList();
  std::size_t mask() const { return this->table_.size() - 1; }
  std::size_t homeOf(Id halfedge) const;
  void enter(Id list);
  void grow();

  std::vector<List> lists_;
  /// Lists that were removed, chained.
  Id unused_ = NoId;
  /// The lists by their halfedges: each at its home or, where others are, at the next free place.
  /// At most half full; its size is a power of two.
  std::vector<Id> table_;
  unsigned bits_ = 0;
  std::size_t count_ = 0;
};

}

#endif
