// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GroupedItems_h
#define geodesic_GroupedItems_h

#include "Tasks.h"
#include "Types.h"
#include "Uninitialized.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geodesic
{

/// Numbered items, grouped by key.
struct GroupedItems
{
  /// The items of key k are those from start[k] to before start[k + 1].
  std::vector<Id> start;
  /// Ascending within a key.
  UninitializedVector<Id> items;

  IdRange at(Id key) const
  {
    return { this->items.data() + this->start[key], this->items.data() + this->start[key + 1] };
  }
};

/// Groups items by key in parallel: a counting sort, first from blocks of consecutive items into
/// coarse ranges of keys, then within each range. So writes that are close in time are close in
/// memory.
///
/// \tparam KeyOf returns the key of an item; called by several threads and several times.
template <typename KeyOf>
class ItemGrouping
{
public:
  ItemGrouping(Id count, Id numberOfKeys, const ParallelFor& parallelFor, const KeyOf& keyOf)
    : count_(count)
    , numberOfKeys_(numberOfKeys)
    , blocks_(std::clamp<std::size_t>(count / ItemsInBlock, 1, MostBlocks))
    , parallelFor_(parallelFor)
    , keyOf_(keyOf)
  {
    while (this->rangeOf(numberOfKeys) >= this->blocks_)
    {
      ++this->shift_;
    }
  }

  GroupedItems run(const LoopProgress& progress)
  {
    const auto tell = [&progress](double done) { progress.between(done, 1.0).at(0, 1); };
    tell(0.0);
    this->findPlaces();
    tell(0.2);
    this->byRange_.resize(this->count_);
    forAll(this->parallelFor_, this->blocks_,
      [this](std::size_t block)
      {
        std::vector<Id>& places = this->places_[block];
        this->forEachItem(
          block, [&](Id item, std::size_t range) { this->byRange_[places[range]++] = item; });
      });
    tell(0.5);
    GroupedItems grouped;
    grouped.start.resize(static_cast<std::size_t>(this->numberOfKeys_) + 1);
    grouped.start[this->numberOfKeys_] = this->count_;
    grouped.items.resize(this->count_);
    forAll(this->parallelFor_, this->blocks_,
      [&](std::size_t range) { this->sortRange(range, grouped); });
    return grouped;
  }

private:
  static constexpr std::size_t ItemsInBlock = std::size_t(1) << 14;
  static constexpr std::size_t MostBlocks = 64;

  // There are as many ranges as blocks.
  std::size_t rangeOf(Id key) const { return static_cast<std::size_t>(key) >> this->shift_; }
  std::size_t firstKeyOf(std::size_t range) const
  {
    return std::min(range << this->shift_, static_cast<std::size_t>(this->numberOfKeys_));
  }

  template <typename Visit>
  void forEachItem(std::size_t block, Visit&& visit) const
  {
    const std::size_t end = (block + 1) * this->count_ / this->blocks_;
    for (std::size_t i = block * this->count_ / this->blocks_; i < end; ++i)
    {
      const Id item = static_cast<Id>(i);
      visit(item, this->rangeOf(this->keyOf_(item)));
    }
  }

  // For each block and range, where the block's items go.
  void findPlaces()
  {
    this->places_.assign(this->blocks_, std::vector<Id>(this->blocks_, 0));
    forAll(this->parallelFor_, this->blocks_,
      [this](std::size_t block)
      {
        std::vector<Id>& counts = this->places_[block];
        this->forEachItem(block, [&counts](Id, std::size_t range) { ++counts[range]; });
      });
    this->firstOfRange_.assign(this->blocks_ + 1, this->count_);
    Id next = 0;
    for (std::size_t range = 0; range < this->blocks_; ++range)
    {
      this->firstOfRange_[range] = next;
      for (std::vector<Id>& places : this->places_)
      {
        next += std::exchange(places[range], next);
      }
    }
  }

  void sortRange(std::size_t range, GroupedItems& grouped) const
  {
    const std::size_t firstKey = this->firstKeyOf(range);
    const Id first = this->firstOfRange_[range];
    const Id last = this->firstOfRange_[range + 1];
    std::vector<Id> places(this->firstKeyOf(range + 1) - firstKey + 1, 0);
    for (Id i = first; i < last; ++i)
    {
      ++places[this->keyOf_(this->byRange_[i]) - firstKey + 1];
    }
    places[0] = first;
    for (std::size_t k = 1; k < places.size(); ++k)
    {
      places[k] += places[k - 1];
    }
    std::copy(places.begin(), places.end() - 1,
      grouped.start.begin() + static_cast<std::ptrdiff_t>(firstKey));
    for (Id i = first; i < last; ++i)
    {
      const Id item = this->byRange_[i];
      grouped.items[places[this->keyOf_(item) - firstKey]++] = item;
    }
  }

  Id count_;
  Id numberOfKeys_;
  std::size_t blocks_;
  const ParallelFor& parallelFor_;
  const KeyOf& keyOf_;
  int shift_ = 0;
  std::vector<std::vector<Id>> places_;
  std::vector<Id> firstOfRange_;
  UninitializedVector<Id> byRange_;
};

/// \param progress called by the calling thread.
/// \param keyOf returns the key, below numberOfKeys, of an item below the count.
/// \throws Aborted
template <typename KeyOf>
GroupedItems groupItems(Id count, Id numberOfKeys, const ParallelFor& parallelFor,
  const LoopProgress& progress, const KeyOf& keyOf)
{
  return ItemGrouping<KeyOf>(count, numberOfKeys, parallelFor, keyOf).run(progress);
}

}

#endif
