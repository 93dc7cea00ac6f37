// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GroupedItems_h
#define geodesic_GroupedItems_h

#include "Job.h"
#include "Types.h"

#include <algorithm>
#include <numeric>
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

/// Sorts some items by their keys, which are a range of all keys: a counting sort.
///
/// \param offset of the first item among the grouped ones.
template <typename KeyOf>
void groupRange(const IdRange& items, std::size_t firstKey, std::size_t endOfKeys, Id offset,
  const KeyOf& keyOf, GroupedItems& grouped)
{
  std::vector<Id> offsets(endOfKeys - firstKey + 1, 0);
  for (const Id item : items)
  {
    ++offsets[keyOf(item) - firstKey + 1];
  }
  offsets[0] = offset;
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::copy(offsets.begin(), offsets.end() - 1,
    grouped.start.begin() + static_cast<std::ptrdiff_t>(firstKey));
  for (const Id item : items)
  {
    grouped.items[offsets[keyOf(item) - firstKey]++] = item;
  }
}

/// Groups items by key in parallel: a counting sort, first from blocks of consecutive items into as
/// many coarse ranges of keys, then within each range. So writes that are close in time are close
/// in memory.
///
/// \param keyOf returns the key, below numberOfKeys, of an item below the count; called by several
///        threads and several times.
/// \throws Aborted
template <typename KeyOf>
GroupedItems groupItems(Id count, Id numberOfKeys, const Job& job, const KeyOf& keyOf)
{
  constexpr std::size_t itemsInBlock = std::size_t(1) << 14;
  constexpr std::size_t mostBlocks = 64;
  const std::size_t blocks = std::clamp<std::size_t>(count / itemsInBlock, 1, mostBlocks);
  int shift = 0; // of a key to its range
  while ((static_cast<std::size_t>(numberOfKeys) >> shift) >= blocks)
  {
    ++shift;
  }
  // Calls visit(item, offset) for each item of a block: where the item goes, as the block counts
  // it.
  std::vector<std::vector<Id>> offsets(blocks, std::vector<Id>(blocks, 0));
  const auto forEachItem = [&](std::size_t block, const auto& visit)
  {
    std::vector<Id>& ofRange = offsets[block];
    const std::size_t end = (block + 1) * count / blocks;
    for (std::size_t i = block * count / blocks; i < end; ++i)
    {
      const Id item = static_cast<Id>(i);
      visit(item, ofRange[keyOf(item) >> shift]++);
    }
  };
  job.reach(0.0);
  job.tasks(blocks, [&](std::size_t block) { forEachItem(block, [](Id, Id) {}); });
  std::vector<Id> firstOfRange(blocks + 1, count);
  Id next = 0;
  for (std::size_t range = 0; range < blocks; ++range)
  {
    firstOfRange[range] = next;
    for (std::vector<Id>& ofBlock : offsets)
    {
      next += std::exchange(ofBlock[range], next);
    }
  }
  job.reach(0.2);
  UninitializedVector<Id> byRange(count);
  job.tasks(blocks,
    [&](std::size_t block)
    { forEachItem(block, [&byRange](Id item, Id offset) { byRange[offset] = item; }); });
  job.reach(0.5);
  GroupedItems grouped;
  grouped.start.resize(static_cast<std::size_t>(numberOfKeys) + 1);
  grouped.start[numberOfKeys] = count;
  grouped.items.resize(count);
  job.tasks(blocks,
    [&](std::size_t range)
    {
      const auto firstKey = [&](std::size_t of)
      { return std::min(of << shift, static_cast<std::size_t>(numberOfKeys)); };
      const Id* items = byRange.data();
      groupRange({ items + firstOfRange[range], items + firstOfRange[range + 1] }, firstKey(range),
        firstKey(range + 1), firstOfRange[range], keyOf, grouped);
    });
  return grouped;
}

}

#endif
