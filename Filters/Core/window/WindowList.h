// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowList_h
#define geodesic_WindowList_h

#include "window/LowerWindow.h"
#include "window/Window.h"

#include <limits>
#include <vector>

namespace geodesic
{

/// Builds the sorted windows of one halfedge, the lower envelope of all appended windows. Where two
/// windows overlap, each keeps the part where its distance is smaller: a ray that is beaten where
/// it enters the face cannot be part of a shortest path (paper, section 3.3). One builder serves
/// many lists.
class WindowListBuilder
{
public:
  /// Begins an empty list on a halfedge of this length.
  void reset(double edgeLength);
  /// Adds a window. Appending in order of the begins takes linear time; any order gives the same
  /// result.
  void append(const Window& window)
  {
    this->append(window, [](Window&) {});
  }
  /// Adds a changed copy of a window, which is made in place.
  ///
  /// \param change (Window&) -> void.
  template <typename Change>
  void append(const Window& window, const Change& change)
  {
    this->windows_.push_back(window);
    Window& added = this->windows_.back();
    change(added);
    if (this->windows_.size() > 1 && (&added - 1)->end > added.begin)
    {
      this->trimOverlapping();
    }
    else if (!this->isWide(added.begin, added.end))
    {
      this->windows_.pop_back();
    }
  }

  /// Adds a window of another list than the last window's. If it continues the last window's
  /// pencil, which a vertex in a flat part of the surface has split, the two become one.
  void appendOfOther(const Window& window);

  /// Adds the windows of two sorted lists without overlaps. Where a window of one list follows a
  /// window of the other, appendOfOther() adds it.
  void appendLists(WindowRange first, WindowRange second);

  /// Adds the parts of a window where it is lower than sorted windows without overlaps. It must not
  /// begin before what is there ends.
  void appendWhereLower(const Window& window, WindowRange others);

  void dropNarrowerThan(double width);

  const std::vector<Window>& windows() const { return this->windows_; }
  WindowRange range() const
  {
    return { this->windows_.data(), this->windows_.data() + this->windows_.size() };
  }

private:
  void trimOverlapping();
  void trimBehindLast(Window& last, Window& added);
  void trimAgainstLast(Window& last, Window& added);
  bool trimInPlace(Window& last, Window& added, const LowerParts& lower, double hi);
  void dropNarrow(Window& last, Window& added);
  void appendParts(const Window& last, const Window& window, const LowerParts& lower, double hi);
  void appendToSeveral(const Window& window);
  void appendRun(WindowRange run, bool isOfOther);
  void appendPiece(const Window& window, double begin, double end);
  bool isWide(double begin, double end) const { return end - begin >= this->leastWidth_; }
  bool push(const Window& window, double begin, double end)
  {
    if (!this->isWide(begin, end))
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
  /// The window that the last piece was cut from, so that adjacent pieces are joined again.
  const Window* lastOwner_ = nullptr;
  /// Positive, also on an edge without length.
  double leastWidth_ = std::numeric_limits<double>::min();
};

}

#endif
