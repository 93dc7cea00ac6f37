// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowArchive_h
#define geodesic_WindowArchive_h

#include "window/Window.h"

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

namespace geodesic
{

/// The windows of one halfedge in a WindowArchive: several lists, one after another.
class WindowRuns
{
public:
  class Iterator
  {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Window;
    using difference_type = std::ptrdiff_t;
    using pointer = const Window*;
    using reference = const Window&;

    explicit Iterator(const WindowRange* run)
      : run_(run)
    {
    }
    reference operator*() const { return this->run_->first[this->index_]; }
    pointer operator->() const { return &**this; }
    Iterator& operator++()
    {
      if (++this->index_ == this->run_->size())
      {
        ++this->run_;
        this->index_ = 0;
      }
      return *this;
    }
    bool operator==(const Iterator& other) const
    {
      return this->run_ == other.run_ && this->index_ == other.index_;
    }
    bool operator!=(const Iterator& other) const { return !(*this == other); }

  private:
    const WindowRange* run_;
    std::size_t index_ = 0;
  };

  WindowRuns() = default;
  WindowRuns(const WindowRange* first, const WindowRange* last)
    : first_(first)
    , last_(last)
  {
  }
  Iterator begin() const { return Iterator(this->first_); }
  Iterator end() const { return Iterator(this->last_); }
  bool empty() const { return this->first_ == this->last_; }

private:
  const WindowRange* first_ = nullptr;
  const WindowRange* last_ = nullptr;
};

/// Windows at the time when they passed through their halfedges.
class WindowArchive
{
public:
  /// Copies a list that is about to pass through a halfedge.
  ///
  /// \param time must not decrease within an archive; it orders the lists of a halfedge, even from
  ///        several archives.
  void add(Id halfedge, const WindowRange& list, Id time = 0)
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

  /// Refers to a list without copying it. own() then takes over the list's memory.
  void adopt(Id halfedge, const WindowRange& list, Id time = 0)
  {
    this->added_.push_back({ halfedge, time, list });
  }

  void own(std::vector<std::unique_ptr<Window[]>> chunks)
  {
    std::move(chunks.begin(), chunks.end(), std::back_inserter(this->chunks_));
  }

  /// Takes over all contents of another archive, which becomes empty.
  void take(WindowArchive& other)
  {
    this->own(std::move(other.chunks_));
    this->added_.insert(this->added_.end(), other.added_.begin(), other.added_.end());
    this->left_ = 0;
    other = WindowArchive();
  }

  /// Must be called before at(); nothing may be added after it.
  void index(Id numberOfHalfedges)
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
      ++this->start_[this->slotOf(run.halfedge)];
    }
    for (std::size_t s = 1; s < this->start_.size(); ++s)
    {
      this->start_[s] += this->start_[s - 1];
    }
    // fills each halfedge's runs from the last to the first
    this->runs_.resize(this->added_.size());
    for (auto run = this->added_.rbegin(); run != this->added_.rend(); ++run)
    {
      this->runs_[--this->start_[this->slotOf(run->halfedge)]] = run->windows;
    }
    this->added_ = {};
  }

  bool isIndexed() const { return !this->blocks_.empty(); }
  /// The windows of a halfedge, in the order in which they were added.
  WindowRuns at(Id halfedge) const
  {
    if ((this->blocks_[halfedge / 64].used >> halfedge % 64 & 1U) == 0)
    {
      return {};
    }
    const std::size_t i = this->slotOf(halfedge);
    return { this->runs_.data() + this->start_[i], this->runs_.data() + this->start_[i + 1] };
  }

private:
  static constexpr std::size_t ChunkWindows = std::size_t(1) << 12;

  /// A bit for each of 64 halfedges tells whether it has windows; and how many of the halfedges
  /// before these have some.
  struct Block
  {
    std::uint64_t used = 0;
    std::size_t usedBefore = 0;
  };

  /// How many halfedges before one have windows.
  std::size_t slotOf(Id halfedge) const
  {
    const Block& block = this->blocks_[halfedge / 64];
    const std::uint64_t before = (std::uint64_t(1) << halfedge % 64) - 1;
    return block.usedBefore + std::bitset<64>(block.used & before).count();
  }

  struct Run
  {
    Id halfedge;
    Id time;
    WindowRange windows;
  };

  std::vector<std::unique_ptr<Window[]>> chunks_;
  Window* free_ = nullptr;
  std::size_t left_ = 0;
  std::vector<Run> added_;
  std::vector<WindowRange> runs_;
  /// Most archives have windows of few halfedges: an index of all would outweigh them.
  std::vector<Block> blocks_;
  /// The first run of each halfedge that has windows, and the end of the last.
  std::vector<std::size_t> start_;
};

}

#endif
