// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowList.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Calls visit(bool isA, double begin, double end) for the parts of [lo, hi], which both windows
/// cover, and tells which of the two is lower there.
template <typename Visit>
void forEachLowerPart(const Window& a, const Window& b, double lo, double hi, const Visit& visit)
{
  const LowerParts lower = lowerOf(a, b, lo, hi);
  double begin = lo;
  bool isA = lower.firstIsA;
  for (int i = 0; i <= lower.cuts; ++i, isA = !isA)
  {
    const double end = i < lower.cuts ? lower.cut[static_cast<std::size_t>(i)] : hi;
    visit(isA, begin, end);
    begin = end;
  }
}

} // anonymous namespace

void WindowListBuilder::reset(double edgeLength)
{
  this->windows_.clear();
  this->leastWidth_ =
    std::max(tolerance::LeastWidth * edgeLength, std::numeric_limits<double>::min());
}

// The added window overlaps the window before it.
void WindowListBuilder::trimOverlapping()
{
  const std::size_t size = this->windows_.size();
  Window& added = this->windows_[size - 1];
  Window& last = this->windows_[size - 2];
  const bool onlyLast =
    last.begin <= added.begin && (size == 2 || this->windows_[size - 3].end <= added.begin);
  if (!onlyLast)
  {
    const Window window = added;
    this->windows_.pop_back();
    this->appendToSeveral(window);
  }
  else if (last.end - added.begin <= 2.0 * this->leastWidth_)
  {
    this->trimBehindLast(last, added);
  }
  else
  {
    this->trimAgainstLast(last, added);
  }
}

// The windows overlap by a few roundings. A cut there would be meaningless, so the lower window
// gets the whole overlap.
void WindowListBuilder::trimBehindLast(Window& last, Window& added)
{
  const double middle = 0.5 * (added.begin + last.end);
  if (last.distance(middle) <= added.distance(middle))
  {
    added.begin = last.end;
  }
  else
  {
    last.end = added.begin;
  }
  this->dropNarrow(last, added);
}

// Drops those of the list's last two windows that are too narrow.
void WindowListBuilder::dropNarrow(Window& last, Window& added)
{
  const bool keepsAdded = this->isWide(added.begin, added.end);
  if (last.width() < this->leastWidth_)
  {
    last = added;
    this->windows_.pop_back();
  }
  if (!keepsAdded)
  {
    this->windows_.pop_back();
  }
}

// The added window overlaps only the list's last window, and begins inside it.
void WindowListBuilder::trimAgainstLast(Window& last, Window& added)
{
  const double hi = std::min(last.end, added.end);
  const LowerParts lower = lowerOf(last, added, added.begin, hi);
  if (!this->trimInPlace(last, added, lower, hi))
  {
    const Window old = last;
    const Window window = added;
    this->windows_.resize(this->windows_.size() - 2);
    this->appendParts(old, window, lower, hi);
  }
}

// The frequent cases: each of the two windows keeps one part of its interval. Returns false,
// without any change, in all other cases.
bool WindowListBuilder::trimInPlace(Window& last, Window& added, const LowerParts& lower, double hi)
{
  if (lower.firstIsA && lower.cuts == 0)
  {
    added.begin = hi;
    if (!this->isWide(hi, added.end))
    {
      this->windows_.pop_back();
    }
    return true;
  }
  if (last.end > hi || lower.cuts != (lower.firstIsA ? 1 : 0))
  {
    return false;
  }
  last.end = lower.firstIsA ? lower.cut[0] : added.begin;
  added.begin = last.end;
  this->dropNarrow(last, added);
  return true;
}

// Appends the part of the last window up to the first cut, then parts of the two windows by turns,
// each up to the next cut, and what one of them has behind the other.
void WindowListBuilder::appendParts(
  const Window& last, const Window& window, const LowerParts& lower, double hi)
{
  const auto cutAt = [&](int i)
  { return i < lower.cuts ? lower.cut[static_cast<std::size_t>(i)] : hi; };
  double begin = lower.firstIsA ? cutAt(0) : window.begin;
  if (!(begin - last.begin < this->leastWidth_))
  {
    this->windows_.push_back(last);
    this->windows_.back().end = begin;
  }
  const Window* part = &window;
  const Window* other = &last;
  for (int i = lower.firstIsA ? 1 : 0; i < lower.cuts; ++i)
  {
    this->push(*part, begin, cutAt(i));
    begin = cutAt(i);
    std::swap(part, other);
  }
  this->push(*part, begin, part->end);
  this->push(*other, hi, other->end);
}

void WindowListBuilder::appendToSeveral(const Window& window)
{
  std::size_t first = this->windows_.size();
  while (first > 0 && this->windows_[first - 1].end > window.begin)
  {
    --first;
  }
  this->overlapped_.assign(
    this->windows_.begin() + static_cast<std::ptrdiff_t>(first), this->windows_.end());
  this->windows_.resize(first);
  this->lastOwner_ = nullptr;
  double begin = window.begin; // where the remaining part of the window begins
  for (const Window& old : this->overlapped_)
  {
    const double lo = std::max(begin, old.begin);
    const double hi = std::min(window.end, old.end);
    if (begin < std::min(old.begin, window.end))
    {
      this->appendPiece(window, begin, std::min(old.begin, window.end));
    }
    if (lo >= hi)
    {
      this->appendPiece(old, old.begin, old.end);
      begin = std::max(begin, std::min(old.begin, window.end));
      continue;
    }
    this->appendPiece(old, old.begin, lo);
    forEachLowerPart(old, window, lo, hi,
      [&](bool isOld, double partBegin, double partEnd)
      { this->appendPiece(isOld ? old : window, partBegin, partEnd); });
    this->appendPiece(old, hi, old.end);
    begin = hi;
  }
  this->appendPiece(window, begin, window.end);
}

// Pieces come in order. Adjacent pieces of one window are joined.
void WindowListBuilder::appendPiece(const Window& window, double begin, double end)
{
  if (!(end > begin))
  {
    return;
  }
  if (&window == this->lastOwner_ && !this->windows_.empty())
  {
    this->windows_.back().end = end;
  }
  else if (this->push(window, begin, end))
  {
    this->lastOwner_ = &window;
  }
}

void WindowListBuilder::appendOfOther(const Window& window)
{
  if (this->windows_.empty() || !isSameSource(this->windows_.back(), window) ||
    window.begin - this->windows_.back().end > this->leastWidth_)
  {
    this->append(window);
    return;
  }
  Window& last = this->windows_.back();
  last.end = std::max(last.end, window.end);
  last.error = std::max(last.error, window.error);
  last.forgetUnlessCrossedBy(window);
  // If the pencil has returned on another way, the shorter path counts.
  last.facesCrossed = std::min<Id>(last.facesCrossed, window.facesCrossed) & MaximumFacesCrossed;
}

// Behind the windows that overlap existing ones, the rest of a run is appended unchanged.
void WindowListBuilder::appendRun(WindowRange run, bool isOfOther)
{
  const Window* w = run.begin();
  if (isOfOther)
  {
    this->appendOfOther(*w++);
  }
  constexpr std::ptrdiff_t fewest = 4; // fewer are not worth another loop
  while (w != run.end() &&
    (run.end() - w < fewest || this->windows_.empty() || this->windows_.back().end > w->begin))
  {
    this->append(*w++);
  }
  while (w != run.end())
  {
    const Window* narrow = w;
    while (narrow != run.end() && this->isWide(narrow->begin, narrow->end))
    {
      ++narrow;
    }
    this->windows_.insert(this->windows_.end(), w, narrow);
    w = narrow == run.end() ? narrow : narrow + 1;
  }
}

void WindowListBuilder::appendLists(WindowRange first, WindowRange second)
{
  const Window* a = first.begin();
  const Window* b = second.begin();
  bool lastIsFirst = true;
  while (a != first.end() && b != second.end())
  {
    const bool isFirst = a->begin <= b->begin;
    const Window*& next = isFirst ? a : b;
    const Window* const begin = next;
    if (isFirst)
    {
      for (++a; a != first.end() && a->begin <= b->begin;)
      {
        ++a;
      }
    }
    else
    {
      for (++b; b != second.end() && b->begin < a->begin;)
      {
        ++b;
      }
    }
    const bool isOfOther = isFirst != lastIsFirst;
    if (next - begin > 1)
    {
      this->appendRun({ begin, next }, isOfOther);
    }
    else if (isOfOther)
    {
      this->appendOfOther(*begin);
    }
    else
    {
      this->append(*begin);
    }
    lastIsFirst = isFirst;
  }
  if (a != first.end())
  {
    this->appendRun({ a, first.end() }, !lastIsFirst);
  }
  else if (b != second.end())
  {
    this->appendRun({ b, second.end() }, lastIsFirst);
  }
}

void WindowListBuilder::appendWhereLower(const Window& window, WindowRange others)
{
  this->lastOwner_ = nullptr;
  double begin = window.begin; // of what is left of the window
  const Window* other = std::partition_point(
    others.begin(), others.end(), [&window](const Window& o) { return o.end <= window.begin; });
  for (; other != others.end() && other->begin < window.end; ++other)
  {
    this->appendPiece(window, begin, other->begin);
    const double hi = std::min(window.end, other->end);
    forEachLowerPart(*other, window, std::max(begin, other->begin), hi,
      [&](bool isOther, double partBegin, double partEnd)
      {
        if (isOther)
        {
          this->lastOwner_ = nullptr;
        }
        else
        {
          this->appendPiece(window, partBegin, partEnd);
        }
      });
    begin = hi;
  }
  this->appendPiece(window, begin, window.end);
}

void WindowListBuilder::dropNarrowerThan(double width)
{
  this->windows_.erase(std::remove_if(this->windows_.begin(), this->windows_.end(),
                         [width](const Window& w) { return w.width() < width; }),
    this->windows_.end());
}

}
