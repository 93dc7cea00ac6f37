// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaitingLists_h
#define geodesic_WaitingLists_h

#include "window/WindowPool.h"

#include <vector>

namespace geodesic
{

/// The windows that wait on halfedges: at most one sorted list a halfedge, each in one block, and a
/// link from halfedge to halfedge with which the caller chains those that belong together.
/// Different halfedges may be used from different threads, each with its own pool.
class WaitingLists
{
public:
  explicit WaitingLists(Id numberOfHalfedges)
    : lists_(numberOfHalfedges)
  {
  }

  void prefetch(Id halfedge) const { geodesic::prefetch(this->lists_.data() + halfedge); }
  bool has(Id halfedge) const { return this->lists_[halfedge].data != nullptr; }
  WindowRange at(Id halfedge) const
  {
    return { this->lists_[halfedge].data,
      this->lists_[halfedge].data + this->lists_[halfedge].size };
  }
  /// The list that the halfedge has, to change in place; shorten() when it has become shorter.
  WindowBlock blockAt(Id halfedge) const;
  void shorten(Id halfedge, std::size_t size)
  {
    this->lists_[halfedge].size = static_cast<std::uint32_t>(size) & 0x7ffffffu;
  }
  /// Gives the halfedge, which has no list, this block as its list.
  void adopt(Id halfedge, const WindowBlock& block);
  /// Replaces the list that the halfedge has by a copy of the windows, which must not be its own.
  void assign(Id halfedge, const WindowRange& windows, WindowPool& pool);
  /// Frees the list of the halfedge.
  void clear(Id halfedge, WindowPool& pool);
  /// Takes the list of the halfedge away; its block is the caller's.
  WindowBlock release(Id halfedge);

  /// The halfedge that the caller has linked this one to.
  Id next(Id halfedge) const { return this->lists_[halfedge].next; }
  void setNext(Id halfedge, Id next) { this->lists_[halfedge].next = next; }

  /// The halfedges that have a list, ascending.
  std::vector<Id> halfedges() const;

private:
  /// A block, packed together with the chain: there is one for every halfedge.
  struct List
  {
    Window* data = nullptr;
    std::uint32_t size : 27;
    std::uint32_t sizeClass : 5;
    Id next = NoId;

    List()
      : size(0)
      , sizeClass(0)
    {
    }
  };

  std::vector<List> lists_;
};

}

#endif
