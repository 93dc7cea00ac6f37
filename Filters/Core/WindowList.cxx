// SPDX-License-Identifier: BSD-3-Clause
#include "WindowList.h"

#include "Tolerance.h"

namespace geodesic
{

void WindowListBuilder::reset(double sideLength)
{
  this->windows_.clear();
  this->lastOwner_ = nullptr;
  this->leastWidth_ = tolerance::LeastWidth * sideLength;
}

void WindowListBuilder::append(const Window& window)
{
  std::size_t first = this->windows_.size();
  while (first > 0 && this->windows_[first - 1].end > window.begin)
  {
    --first;
  }
  this->lastOwner_ = nullptr;
  if (first == this->windows_.size())
  {
    this->appendPiece(window, window.begin, window.end, &window);
    return;
  }
  this->overlapped_.assign(
    this->windows_.begin() + static_cast<std::ptrdiff_t>(first), this->windows_.end());
  this->windows_.resize(first);

  double begin = window.begin; // what is left of the window
  for (const Window& old : this->overlapped_)
  {
    const double lo = std::max(begin, old.begin);
    const double hi = std::min(window.end, old.end);
    if (begin < std::min(old.begin, window.end))
    {
      this->appendPiece(window, begin, std::min(old.begin, window.end), &window);
    }
    if (lo >= hi)
    {
      this->appendPiece(old, old.begin, old.end, &old);
      begin = std::max(begin, std::min(old.begin, window.end));
      continue;
    }
    this->appendPiece(old, old.begin, lo, &old);
    this->appendOverlap(old, window, lo, hi);
    this->appendPiece(old, hi, old.end, &old);
    begin = hi;
  }
  this->appendPiece(window, begin, window.end, &window);
}

// Pieces come in order. A window cut in two by a narrower one appears twice.
void WindowListBuilder::appendPiece(
  const Window& window, double begin, double end, const void* owner)
{
  if (!(end > begin))
  {
    return;
  }
  if (owner == this->lastOwner_ && !this->windows_.empty())
  {
    this->windows_.back().end = end;
    return;
  }
  if (end - begin < this->leastWidth_)
  {
    return;
  }
  this->windows_.push_back(window);
  this->windows_.back().begin = begin;
  this->windows_.back().end = end;
  this->lastOwner_ = owner;
}

// Where one window is smaller at both ends, it is so throughout, unless they cross twice, which
// they cannot where the sum of the differences is more than the slopes, 1 at most each, can make up
// for.
void WindowListBuilder::appendOverlap(const Window& a, const Window& b, double lo, double hi)
{
  if (a.sigma == b.sigma && !a.isLinear() && !b.isLinear())
  {
    this->appendSameSigma(a, b, lo, hi);
    return;
  }
  const double atLo = a.distance(lo) - b.distance(lo);
  const double atHi = a.distance(hi) - b.distance(hi);
  const bool sameSide = (atLo < 0.0 && atHi < 0.0) || (atLo > 0.0 && atHi > 0.0);
  if (sameSide && std::abs(atLo + atHi) > 2.0 * (hi - lo))
  {
    const Window& lower = atLo < 0.0 ? a : b;
    this->appendPiece(lower, lo, hi, &lower);
    return;
  }
  this->appendLower(a, b, lo, hi);
}

// The commonest overlap: with one sigma the squares can be compared, whose difference is linear.
void WindowListBuilder::appendSameSigma(const Window& a, const Window& b, double lo, double hi)
{
  const double slope = 2.0 * (b.sourceX - a.sourceX);
  const double middle = 0.5 * (a.sourceX + b.sourceX);
  const double depths = (a.sourceDepth - b.sourceDepth) * (a.sourceDepth + b.sourceDepth);
  const double atLo = slope * (lo - middle) + depths;
  const double atHi = slope * (hi - middle) + depths;
  const Window& first = atLo < 0.0 || (atLo == 0.0 && atHi <= 0.0) ? a : b;
  const Window& second = atHi < 0.0 || (atHi == 0.0 && atLo <= 0.0) ? a : b;
  if (&first == &second)
  {
    this->appendPiece(first, lo, hi, &first);
    return;
  }
  const double cross = std::clamp(middle - depths / slope, lo, hi);
  this->appendPiece(first, lo, cross, &first);
  this->appendPiece(second, cross, hi, &second);
}

// Between crossings one of the two is smaller throughout; its middle tells which. The older one
// keeps what is equal.
void WindowListBuilder::appendLower(const Window& a, const Window& b, double lo, double hi)
{
  const Crossings cross = crossings(a, b, lo, hi);
  double begin = lo;
  for (int i = 0; i <= cross.count; ++i)
  {
    const double end = i < cross.count ? cross.at[static_cast<std::size_t>(i)] : hi;
    const double middle = 0.5 * (begin + end);
    const Window& lower = b.distance(middle) < a.distance(middle) ? b : a;
    this->appendPiece(lower, begin, end, &lower);
    begin = end;
  }
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

void WindowPool::free(Window* block, std::uint32_t sizeClass)
{
  if (this->freeBlocks_.size() <= sizeClass)
  {
    this->freeBlocks_.resize(sizeClass + 1);
  }
  this->freeBlocks_[sizeClass].push_back(block);
}

void WaitingLists::assign(Id side, const WindowRange& windows, WindowPool& pool)
{
  List& list = this->lists_[side];
  const std::uint32_t sizeClass = sizeClassOf(windows.size());
  if (list.data == nullptr || list.sizeClass < sizeClass || windows.size() == 0)
  {
    this->clear(side, pool);
    if (windows.size() == 0)
    {
      return;
    }
    list.data = pool.allocate(sizeClass);
    list.sizeClass = sizeClass;
  }
  list.size = static_cast<Id>(windows.size());
  std::copy(windows.begin(), windows.end(), list.data);
}

void WaitingLists::clear(Id side, WindowPool& pool)
{
  List& list = this->lists_[side];
  if (list.data != nullptr)
  {
    pool.free(list.data, list.sizeClass);
    list = List();
  }
}

std::vector<Id> WaitingLists::sides() const
{
  std::vector<Id> result;
  for (std::size_t side = 0; side < this->lists_.size(); ++side)
  {
    if (this->lists_[side].size > 0)
    {
      result.push_back(static_cast<Id>(side));
    }
  }
  return result;
}

}
