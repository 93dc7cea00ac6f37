// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaitingLists_h
#define geodesic_WaitingLists_h

#include "window/WindowPool.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// The lists that wait on halfedges, at most one on each. Those on the halfedges opposite one
/// vertex form a group, whose number the vertex has (VertexState::facing); a vertex without lists
/// has NoId. Few lists wait for a vertex at once, and they are side by side in memory, so a search
/// of its group finds a halfedge's list.
class WaitingLists
{
public:
  struct List
  {
    Id halfedge;
    WindowBlock windows;
    /// The distance at which the list passes, whether or not the front has reached its vertex;
    /// infinite if the list waits for the vertex.
    double due = Infinity;
  };
  using Group = std::vector<List>;

  /// The lists of a group, which there is, the newest last.
  const Group& operator[](Id group) const { return this->groups_[group]; }

  /// A halfedge's list in the group of the vertex opposite; null if there is none.
  List* find(Id group, Id halfedge)
  {
    if (group != NoId)
    {
      for (List& list : this->groups_[group])
      {
        if (list.halfedge == halfedge)
        {
          return &list;
        }
      }
    }
    return nullptr;
  }

  /// Whether a condition holds for some list of a group: (const List&) -> bool.
  template <typename Condition>
  bool isAny(Id group, const Condition& condition) const
  {
    return group != NoId &&
      std::any_of(this->groups_[group].begin(), this->groups_[group].end(), condition);
  }

  /// Adds a list to a group that has none of its halfedge.
  List& add(Id& group, const HalfedgeList& added)
  {
    if (group == NoId)
    {
      group = this->takeUnused();
    }
    Group& lists = this->groups_[group];
    lists.push_back({ added.halfedge, added.windows });
    return lists.back();
  }

  /// Takes lists out of a group, which there may be. Their blocks now belong to the caller.
  ///
  /// \param isTaken (const List&) -> bool.
  /// \param taken replaced; the newest first.
  template <typename IsTaken>
  void take(Id& group, const IsTaken& isTaken, std::vector<HalfedgeList>& taken)
  {
    taken.clear();
    if (group == NoId)
    {
      return;
    }
    Group& lists = this->groups_[group];
    const auto takes = [&](const List& list)
    {
      const bool isOne = isTaken(list);
      if (isOne)
      {
        taken.push_back({ list.halfedge, list.windows });
      }
      return isOne;
    };
    lists.erase(std::remove_if(lists.begin(), lists.end(), takes), lists.end());
    std::reverse(taken.begin(), taken.end());
    if (lists.empty())
    {
      this->unused_.push_back(group);
      group = NoId;
    }
  }

  /// Adds the lists of a vertex that has none here. \returns the number of their group.
  Id addGroup(Group&& lists)
  {
    const Id group = this->takeUnused();
    this->groups_[group] = std::move(lists);
    return group;
  }

  /// Calls visit(Group&) for the lists of each vertex, in any order.
  template <typename Visit>
  void forEachGroup(Visit&& visit)
  {
    for (Group& lists : this->groups_)
    {
      if (!lists.empty())
      {
        visit(lists);
      }
    }
  }

  /// Calls visit(const List&) for each list, in any order.
  template <typename Visit>
  void forEach(Visit&& visit) const
  {
    for (const Group& lists : this->groups_)
    {
      std::for_each(lists.begin(), lists.end(), visit);
    }
  }

private:
  Id takeUnused()
  {
    if (this->unused_.empty())
    {
      constexpr std::size_t usual = 4;
      this->groups_.emplace_back().reserve(usual);
      return static_cast<Id>(this->groups_.size()) - 1;
    }
    const Id group = this->unused_.back();
    this->unused_.pop_back();
    return group;
  }

  std::vector<Group> groups_;
  /// The numbers of empty groups.
  std::vector<Id> unused_;
};

}

#endif
