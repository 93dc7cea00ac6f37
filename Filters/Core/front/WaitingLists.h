// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaitingLists_h
#define geodesic_WaitingLists_h

#include "window/WindowPool.h"

#include <vector>

namespace geodesic
{

/// The lists that wait on halfedges, at most one on each. The lists of the halfedges opposite one
/// vertex form a chain; the vertex has the number of the first (VertexState::facing). Few lists
/// wait for a vertex at once, so a halfedge's list is found by a search of the chain.
class WaitingLists
{
public:
  /// In an order of members that leaves no gaps: there are very many.
  struct List
  {
    WindowBlock windows;
    /// NoId in a place that is not used.
    Id halfedge = NoId;
    /// The next one of the chain.
    Id next = NoId;
    /// The distance at which the list passes, whether or not the front has reached its vertex;
    /// infinite if the list waits for the vertex.
    double due = Infinity;
  };

  List& operator[](Id list) { return this->lists_[list]; }
  const List& operator[](Id list) const { return this->lists_[list]; }

  /// The number of a halfedge's list in a chain; NoId if there is none.
  Id find(Id first, Id halfedge) const
  {
    Id list = first;
    while (list != NoId && this->lists_[list].halfedge != halfedge)
    {
      list = this->lists_[list].next;
    }
    return list;
  }

  /// Puts a list in front of a chain that has none of its halfedge.
  void add(Id& first, const HalfedgeList& added)
  {
    if (this->unused_ == NoId)
    {
      this->unused_ = static_cast<Id>(this->lists_.size());
      this->lists_.emplace_back();
    }
    const Id list = this->unused_;
    this->unused_ = this->lists_[list].next;
    this->lists_[list] = { added.windows, added.halfedge, first };
    first = list;
  }

  /// Takes lists out of a chain. Their blocks now belong to the caller.
  ///
  /// \param isTaken (const List&) -> bool, asked in the order of the chain.
  /// \param taken replaced, in this order.
  template <typename IsTaken>
  void take(Id& first, const IsTaken& isTaken, std::vector<HalfedgeList>& taken)
  {
    taken.clear();
    Id* link = &first;
    while (*link != NoId)
    {
      const Id number = *link;
      List& list = this->lists_[number];
      if (!isTaken(list))
      {
        link = &list.next;
        continue;
      }
      taken.push_back({ list.halfedge, list.windows });
      *link = list.next;
      list.halfedge = NoId;
      list.next = this->unused_;
      this->unused_ = number;
    }
  }

  /// Calls visit(const List&) for each list, in any order.
  template <typename Visit>
  void forEach(Visit&& visit) const
  {
    for (const List& list : this->lists_)
    {
      if (list.halfedge != NoId)
      {
        visit(list);
      }
    }
  }

private:
  std::vector<List> lists_;
  /// The places that are not used, chained.
  Id unused_ = NoId;
};

}

#endif
