// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowArchive.h"

#include <algorithm>

namespace geodesic
{

namespace
{
constexpr std::size_t ChunkWindows = std::size_t(1) << 12;
}

void WindowArchive::add(Id halfedge, const WindowRange& list, Id time)
{
  const std::size_t size = list.size();
  if (size == 0)
  {
    return;
  }
  if (size > this->left_)
  {
    this->left_ = std::max(ChunkWindows, size);
    this->chunks_.emplace_back(new Window[this->left_]);
    this->free_ = this->chunks_.back().get();
  }
  std::copy(list.begin(), list.end(), this->free_);
  this->adopt(halfedge, { this->free_, this->free_ + size }, time);
  this->free_ += size;
  this->left_ -= size;
}

void WindowArchive::adopt(Id halfedge, const WindowRange& list, Id time)
{
  this->added_.push_back({ halfedge, time, list });
}

void WindowArchive::own(std::vector<std::unique_ptr<Window[]>> chunks)
{
  std::move(chunks.begin(), chunks.end(), std::back_inserter(this->chunks_));
}

void WindowArchive::take(WindowArchive& other)
{
  this->own(std::move(other.chunks_));
  this->added_.insert(this->added_.end(), other.added_.begin(), other.added_.end());
  this->left_ = 0;
  other = WindowArchive();
}

void WindowArchive::index(Id numberOfHalfedges)
{
  const auto earlier = [](const Run& a, const Run& b) { return a.time < b.time; };
  if (!std::is_sorted(this->added_.begin(), this->added_.end(), earlier))
  {
    std::stable_sort(this->added_.begin(), this->added_.end(), earlier);
  }
  this->blocks_.assign(static_cast<std::size_t>(numberOfHalfedges) / 64 + 1, {});
  for (const Run& run : this->added_)
  {
    this->blocks_[run.halfedge / 64].used |= std::uint64_t(1) << run.halfedge % 64;
  }
  std::size_t used = 0;
  for (Block& block : this->blocks_)
  {
    block.usedBefore = used;
    used += std::bitset<64>(block.used).count();
  }
  this->start_.assign(used + 1, 0);
  for (const Run& run : this->added_)
  {
    ++this->start_[this->placeOf(run.halfedge)];
  }
  for (std::size_t s = 1; s < this->start_.size(); ++s)
  {
    this->start_[s] += this->start_[s - 1];
  }
  // fills each halfedge's runs from the last to the first
  this->runs_.resize(this->added_.size());
  for (auto run = this->added_.rbegin(); run != this->added_.rend(); ++run)
  {
    this->runs_[--this->start_[this->placeOf(run->halfedge)]] = run->windows;
  }
  this->added_ = {};
}

}
