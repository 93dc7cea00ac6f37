// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowList.h"

#include "Tolerance.h"

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
  const bool one = this->windows_[last].begin <= window.begin &&
    (last == 0 || this->windows_[last - 1].end <= window.begin);
  if (!one)
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

namespace
{

/// Which of two windows is lower where both are: `first` up to cut[0], the other up to cut[1],
/// `first` again from there on.
struct Lower
{
  bool firstIsA = true;
  int cuts = 0;
  std::array<double, 2> cut{};
};

// The commonest overlap: with one sigma the squares can be compared, whose difference is linear.
Lower lowerOfSameSigma(const Window& a, const Window& b, double lo, double hi)
{
  const double slope = 2.0 * (b.sourceX - a.sourceX);
  const double middle = 0.5 * (a.sourceX + b.sourceX);
  const double depths = (a.sourceDepth - b.sourceDepth) * (a.sourceDepth + b.sourceDepth);
  const double atLo = slope * (lo - middle) + depths;
  const double atHi = slope * (hi - middle) + depths;
  const bool aAtLo = atLo < 0.0 || (atLo == 0.0 && atHi <= 0.0);
  const bool aAtHi = atHi < 0.0 || (atHi == 0.0 && atLo <= 0.0);
  Lower lower;
  lower.firstIsA = aAtLo;
  if (aAtLo != aAtHi)
  {
    const double dx = std::max(std::abs(lo - middle), std::abs(hi - middle));
    const double least = 2.0 * tolerance::Evaluation * (dx * dx + a.sourceDepth * a.sourceDepth);
    if (std::max(std::abs(atLo), std::abs(atHi)) <= least)
    {
      return {}; // equal throughout
    }
    lower.cuts = 1;
    lower.cut[0] = std::clamp(middle - depths / slope, lo, hi);
  }
  return lower;
}

/// Distances of a window at the ends of an interval.
struct AtEnds
{
  double lo;
  double hi;
};

// Whether the two windows have the same distance throughout, as far as rounding tells. It would
// tell of crossings all over, and the pieces between them of more.
bool isTie(
  const Window& a, const Window& b, const AtEnds& ofA, const AtEnds& ofB, double lo, double hi)
{
  const auto same = [](double first, double second)
  { return std::abs(first - second) <= tolerance::Evaluation * first; };
  const double middle = 0.5 * (lo + hi);
  return same(ofA.lo, ofB.lo) && same(ofA.hi, ofB.hi) &&
    same(a.distance(middle), b.distance(middle));
}

// Between crossings one of the two is smaller throughout; its middle tells which. The older one
// keeps what is equal.
Lower lowerByCrossings(const Window& a, const Window& b, double lo, double hi)
{
  const Crossings cross = crossings(a, b, lo, hi);
  Lower lower;
  bool currentIsA = true;
  double begin = lo;
  for (int i = 0; i <= cross.count; ++i)
  {
    const double end = i < cross.count ? cross.at[static_cast<std::size_t>(i)] : hi;
    const double middle = 0.5 * (begin + end);
    const bool isA = a.distance(middle) <= b.distance(middle);
    if (i == 0)
    {
      lower.firstIsA = isA;
    }
    else if (isA != currentIsA)
    {
      lower.cut[static_cast<std::size_t>(lower.cuts++)] = begin;
    }
    currentIsA = isA;
    begin = end;
  }
  return lower;
}

// Whether the higher of two windows stays above the lower one, told from the ends. Distances are
// convex: the higher one is above its tangent at an end, the lower one below its chord.
bool staysAbove(const Window& above, const AtEnds& high, const AtEnds& low, double lo, double hi)
{
  const double width = hi - lo;
  if (above.isLinear())
  {
    return true; // the tangent is the window
  }
  return (high.lo - above.sigma) * (high.lo - low.hi) + (lo - above.sourceX) * width > 0.0 ||
    (high.hi - above.sigma) * (high.hi - low.lo) - (hi - above.sourceX) * width > 0.0;
}

Lower lowerOf(const Window& a, const Window& b, double lo, double hi)
{
  if (a.sigma == b.sigma && !a.isLinear() && !b.isLinear())
  {
    return lowerOfSameSigma(a, b, lo, hi);
  }
  const AtEnds ofA = { a.distance(lo), a.distance(hi) };
  const AtEnds ofB = { b.distance(lo), b.distance(hi) };
  const double atLo = ofA.lo - ofB.lo;
  const double atHi = ofA.hi - ofB.hi;
  Lower lower;
  lower.firstIsA = atLo < 0.0;
  // Only what is more than rounding is a change of sign, which has a crossing inside.
  const double least = tolerance::Tie * (ofA.lo + ofA.hi);
  if ((atLo < -least && atHi > least) || (atLo > least && atHi < -least))
  {
    const Crossings cross = crossings(a, b, lo, hi);
    for (int i = 0; i < cross.count; ++i) // one may be false from squaring
    {
      const double x = cross.at[static_cast<std::size_t>(i)];
      if (std::abs(a.distance(x) - b.distance(x)) <= least)
      {
        lower.cuts = 1;
        lower.cut[0] = x;
        return lower;
      }
    }
  }
  const bool told = (atLo < 0.0 && atHi < 0.0 && staysAbove(b, ofB, ofA, lo, hi)) ||
    (atLo > 0.0 && atHi > 0.0 && staysAbove(a, ofA, ofB, lo, hi));
  if (told)
  {
    return lower;
  }
  return isTie(a, b, ofA, ofB, lo, hi) ? Lower() : lowerByCrossings(a, b, lo, hi);
}

} // anonymous namespace

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
  const Lower lower = lowerOf(last, window, window.begin, hi);
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
  const Lower lower = lowerOf(a, b, lo, hi);
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

// A linear window's source is a direction: its distance changes with the place on the halfedge.
bool isSameSource(const Window& a, const Window& b)
{
  const double source = std::abs(a.sourceX) + a.sourceDepth;
  const double length = a.isLinear() ? b.end : source;
  return a.kind == b.kind && a.origin == b.origin &&
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
  last.depth = std::max<Id>(last.depth, window.depth) & MaximumDepth;
}

namespace
{

constexpr std::size_t ChunkWindows = std::size_t(1) << 10;

std::uint32_t sizeClassOf(std::size_t size)
{
  std::uint32_t sizeClass = 0;
  while ((std::size_t(1) << sizeClass) < size)
  {
    ++sizeClass;
  }
  return sizeClass;
}

} // anonymous namespace

Window* WindowPool::allocate(std::uint32_t sizeClass)
{
  if (sizeClass < this->freeBlocks_.size() && !this->freeBlocks_[sizeClass].empty())
  {
    Window* block = this->freeBlocks_[sizeClass].back();
    this->freeBlocks_[sizeClass].pop_back();
    return block;
  }
  const std::size_t size = std::size_t(1) << sizeClass;
  if (this->chunkUsed_ + size > this->chunkSize_)
  {
    this->chunkSize_ = std::max(ChunkWindows, size);
    this->chunks_.emplace_back(new Window[this->chunkSize_]);
    this->chunkUsed_ = 0;
  }
  Window* block = this->chunks_.back().get() + this->chunkUsed_;
  this->chunkUsed_ += size;
  return block;
}

void WindowPool::free(const WindowBlock& block)
{
  const std::uint32_t sizeClass = block.sizeClass;
  if (this->freeBlocks_.size() <= sizeClass)
  {
    this->freeBlocks_.resize(sizeClass + 1);
  }
  this->freeBlocks_[sizeClass].push_back(block.data);
}

std::vector<std::unique_ptr<Window[]>> WindowPool::release()
{
  std::vector<std::unique_ptr<Window[]>> chunks = std::move(this->chunks_);
  *this = WindowPool();
  return chunks;
}

WindowBlock WindowPool::copyOf(const WindowRange& windows)
{
  if (windows.size() >> 27 != 0)
  {
    throw std::bad_alloc(); // more windows on one halfedge than memory could hold for the others
  }
  WindowBlock block;
  block.size = static_cast<std::uint32_t>(windows.size()) & 0x7ffffffu;
  block.sizeClass = sizeClassOf(windows.size()) & 31u;
  block.data = this->allocate(block.sizeClass);
  std::copy(windows.begin(), windows.end(), block.data);
  return block;
}

WindowBlock WaitingLists::blockOf(Id halfedge) const
{
  const List& list = this->lists_[halfedge];
  WindowBlock block;
  block.data = list.data;
  block.size = list.size;
  block.sizeClass = list.sizeClass;
  return block;
}

void WaitingLists::adopt(Id halfedge, const WindowBlock& block)
{
  List& list = this->lists_[halfedge];
  list.data = block.data;
  list.size = block.size;
  list.sizeClass = block.sizeClass;
}

void WaitingLists::assign(Id halfedge, const WindowRange& windows, WindowPool& pool)
{
  List& list = this->lists_[halfedge];
  if (windows.size() <= (std::size_t(1) << list.sizeClass))
  {
    std::copy(windows.begin(), windows.end(), list.data);
    list.size = static_cast<std::uint32_t>(windows.size()) & 0x7ffffffu;
    return;
  }
  const WindowBlock block = pool.copyOf(windows);
  pool.free(this->blockOf(halfedge));
  this->adopt(halfedge, block);
}

void WaitingLists::clear(Id halfedge, WindowPool& pool)
{
  pool.free(this->release(halfedge));
}

WindowBlock WaitingLists::release(Id halfedge)
{
  const WindowBlock block = this->blockOf(halfedge);
  this->lists_[halfedge] = List();
  return block;
}

std::vector<Id> WaitingLists::halfedges() const
{
  std::vector<Id> result;
  for (std::size_t halfedge = 0; halfedge < this->lists_.size(); ++halfedge)
  {
    if (this->lists_[halfedge].data != nullptr)
    {
      result.push_back(static_cast<Id>(halfedge));
    }
  }
  return result;
}

}
