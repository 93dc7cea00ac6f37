// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowList.h"

#include "Tolerance.h"
#include "window/LowerWindow.h"

#include <algorithm>

namespace geodesic
{

void WindowListBuilder::reset(double edgeLength)
{
  this->windows_.clear();
  this->leastWidth_ = tolerance::LeastWidth * edgeLength;
}

void WindowListBuilder::appendOverlapping(const Window& window)
{
  const std::size_t last = this->windows_.size() - 1;
  const bool onlyLast = this->windows_[last].begin <= window.begin &&
    (last == 0 || this->windows_[last - 1].end <= window.begin);
  if (!onlyLast)
  {
    this->appendToSeveral(window);
  }
  else if (this->windows_[last].end - window.begin <= 2.0 * this->leastWidth_)
  {
    this->appendBehindLast(window);
  }
  else
  {
    this->appendToLast(window);
  }
}

// The window overlaps the list's last one by some roundings: no cut in there would mean anything,
// and the lower one has it all.
void WindowListBuilder::appendBehindLast(const Window& window)
{
  Window& last = this->windows_.back();
  const double middle = 0.5 * (window.begin + last.end);
  if (last.distance(middle) <= window.distance(middle))
  {
    this->push(window, last.end, window.end);
    return;
  }
  last.end = window.begin;
  if (last.width() < this->leastWidth_)
  {
    this->windows_.pop_back();
  }
  this->push(window, window.begin, window.end);
}

// The window overlaps the list's last one only, and begins inside it.
void WindowListBuilder::appendToLast(const Window& window)
{
  Window& last = this->windows_.back();
  const double hi = std::min(last.end, window.end);
  const LowerParts lower = lowerOf(last, window, window.begin, hi);
  if (lower.firstIsA && lower.cuts == 0)
  {
    this->push(window, hi, window.end);
    return;
  }
  const Window old = last;
  const auto cutAt = [&](int i)
  { return i < lower.cuts ? lower.cut[static_cast<std::size_t>(i)] : hi; };
  last.end = lower.firstIsA ? cutAt(0) : window.begin;
  if (last.width() < this->leastWidth_)
  {
    this->windows_.pop_back();
  }
  // parts in turn, each to the next cut, the last to the end of the overlap and what is behind it
  double begin = lower.firstIsA ? cutAt(0) : window.begin;
  for (int i = lower.firstIsA ? 1 : 0; i <= lower.cuts; ++i)
  {
    const bool isOld = (i % 2 == 0) == lower.firstIsA;
    const Window& part = isOld ? old : window;
    this->push(part, begin, i < lower.cuts ? cutAt(i) : part.end);
    begin = cutAt(i);
    if (i == lower.cuts)
    {
      const Window& other = isOld ? window : old;
      this->push(other, hi, other.end);
    }
  }
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
  double begin = window.begin; // what is left of the window
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
    this->appendOverlap(old, window, lo, hi);
    this->appendPiece(old, hi, old.end);
    begin = hi;
  }
  this->appendPiece(window, begin, window.end);
}

void WindowListBuilder::appendOverlap(const Window& a, const Window& b, double lo, double hi)
{
  const LowerParts lower = lowerOf(a, b, lo, hi);
  double begin = lo;
  bool isA = lower.firstIsA;
  for (int i = 0; i <= lower.cuts; ++i, isA = !isA)
  {
    const double end = i < lower.cuts ? lower.cut[static_cast<std::size_t>(i)] : hi;
    this->appendPiece(isA ? a : b, begin, end);
    begin = end;
  }
}

// Pieces come in order; those of one window that meet are joined.
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

namespace
{

// A linear window's source is a direction: its distance changes with the place on the halfedge. The
// surface may bring different sources, or different places of one, to one point of the plane.
bool isSameSource(const Window& a, const Window& b)
{
  const double source = std::abs(a.sourceX) + a.sourceDepth;
  const double length = a.isLinear() ? b.end : source;
  return a.kind == b.kind && a.origin == b.origin &&
    std::abs(a.place - b.place) <= tolerance::SameSource * (std::abs(a.place) + length) &&
    std::abs(a.sourceX - b.sourceX) <= tolerance::SameSource * source &&
    std::abs(a.sourceDepth - b.sourceDepth) <= tolerance::SameSource * source &&
    std::abs(a.sigma - b.sigma) <= tolerance::SameSource * (std::abs(a.sigma) + length);
}

} // anonymous namespace

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
  last.facesCrossed = std::max<Id>(last.facesCrossed, window.facesCrossed) & MaximumFacesCrossed;
}

}
