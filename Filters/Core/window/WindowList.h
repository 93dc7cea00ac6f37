// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowList_h
#define geodesic_WindowList_h

#include "window/Window.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// Builds the sorted windows of one halfedge: the lower envelope of what is appended. Where two windows
/// overlap, each keeps the part where its distance is smaller; a ray that is beaten where it enters
/// cannot be part of a shortest path (paper, section 3.3). One builder is reused for many lists.
class WindowListBuilder
{
public:
  /// Begins an empty list on a halfedge of this length.
  void reset(double edgeLength);
  /// Adds a window. Appending in the order of the interval's begin is linear; any order is right.
  void append(const Window& window)
  {
    if (this->windows_.empty() || this->windows_.back().end <= window.begin)
    {
      this->push(window, window.begin, window.end);
    }
    else
    {
      this->appendOverlapping(window);
    }
  }

  /// Adds a window of another list than the last one: where it goes on with that one's pencil, they
  /// become one.
  void appendOfOther(const Window& window);

  const std::vector<Window>& windows() const { return this->windows_; }
  WindowRange range() const
  {
    return { this->windows_.data(), this->windows_.data() + this->windows_.size() };
  }
  bool empty() const { return this->windows_.empty(); }

private:
  void appendOverlapping(const Window& window);
  void appendToLast(const Window& window);
  void appendBehindLast(const Window& window);
  void appendToSeveral(const Window& window);
  void appendOverlap(const Window& a, const Window& b, double lo, double hi);
  void appendPiece(const Window& window, double begin, double end);
  bool push(const Window& window, double begin, double end)
  {
    if (!(end - begin >= this->leastWidth_ && end > begin))
    {
      return false;
    }
    this->windows_.push_back(window);
    this->windows_.back().begin = begin;
    this->windows_.back().end = end;
    return true;
  }

  std::vector<Window> windows_;
  std::vector<Window> overlapped_;
  /// The window that the last piece was cut from, so that pieces that meet are joined again.
  const Window* lastOwner_ = nullptr;
  double leastWidth_ = 0.0;
};

/// Windows of one halfedge in a block of a pool, sorted.
struct WindowBlock
{
  Window* data = nullptr;
  /// Number of windows; the block holds 2^sizeClass.
  std::uint32_t size : 27;
  std::uint32_t sizeClass : 5;

  WindowRange range() const { return { this->data, this->data + this->size }; }
};

/// Blocks of windows in sizes of powers of two, cut from large chunks and used again. Not
/// thread-safe: each worker has its own, and a block may come from one and be freed into another.
class WindowPool
{
public:
  WindowBlock copyOf(const WindowRange& windows);
  void free(const WindowBlock& block);
  /// Hands over the memory of all blocks cut from it.
  std::vector<std::unique_ptr<Window[]>> release();

private:
  Window* allocate(std::uint32_t sizeClass);

  std::vector<std::vector<Window*>> freeBlocks_;
  std::vector<std::unique_ptr<Window[]>> chunks_;
  std::size_t chunkUsed_ = 0;
  std::size_t chunkSize_ = 0;
};

/// The windows that wait on halfedges: a sorted list a halfedge, each in one block, and the halfedges in chains
/// that their user begins. Different halfedges may be used from different threads, each with its own
/// pool.
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
    return { this->lists_[halfedge].data, this->lists_[halfedge].data + this->lists_[halfedge].size };
  }
  /// Gives the halfedge, which has no list, a block for its own.
  void adopt(Id halfedge, const WindowBlock& block);
  /// Replaces the list of the halfedge; the windows must not be those of the halfedge.
  void assign(Id halfedge, const WindowRange& windows, WindowPool& pool);
  void clear(Id halfedge, WindowPool& pool);
  /// Takes the list of the halfedge away; its block is the caller's.
  WindowBlock release(Id halfedge);

  /// The next halfedge of the chain the halfedge is in.
  Id next(Id halfedge) const { return this->lists_[halfedge].next; }
  void setNext(Id halfedge, Id next) { this->lists_[halfedge].next = next; }

  /// Sides that have a list, ascending.
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

  WindowBlock blockOf(Id halfedge) const;

  std::vector<List> lists_;
};

}

#endif
