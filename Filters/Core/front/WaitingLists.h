// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaitingLists_h
#define geodesic_WaitingLists_h

#include "window/WindowPool.h"

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
  Id find(Id halfedge) const;
  /// Adds a list to a halfedge that has none. \returns the list's number.
  Id add(Id halfedge, const WindowBlock& block);
  /// Removes a list. Its block now belongs to the caller.
  WindowBlock remove(Id list);

  std::size_t size() const { return this->count_; }
  const List& operator[](Id list) const { return this->lists_[list]; }
  List& operator[](Id list) { return this->lists_[list]; }
  /// Replaces the list by a copy of other windows.
  void assign(Id list, const WindowRange& windows, WindowPool& pool);

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
  std::size_t homeOf(Id halfedge) const;
  void enter(Id list);
  void grow();

  std::vector<List> lists_;
  /// Removed lists, chained.
  Id unused_ = NoId;
  /// The numbers of the lists, hashed by halfedge with linear probing. At most half full; the size
  /// is a power of two.
  std::vector<Id> table_;
  unsigned bits_ = 0;
  std::size_t count_ = 0;
};

}

#endif
