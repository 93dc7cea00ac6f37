// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowList_h
#define geodesic_WindowList_h

#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// Builds the sorted windows of one halfedge: the lower envelope of what is appended. Where two
/// windows overlap, each keeps the part where its distance is smaller; a ray that is beaten where
/// it enters cannot be part of a shortest path (paper, section 3.3). One builder is reused for many
/// lists.
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

  /// Adds a window that comes from another list than the last one did. Where it goes on with the
  /// last one's pencil, which a vertex in a flat part of the surface has split, they become one.
  void appendOfOther(const Window& window);

  const std::vector<Window>& windows() const { return this->windows_; }
  WindowRange range() const
  {
    return { this->windows_.data(), this->windows_.data() + this->windows_.size() };
  }

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

}

#endif
