// SPDX-License-Identifier: BSD-3-Clause
#include "front/WaitingLists.h"

#include <algorithm>

namespace geodesic
{

std::size_t WaitingLists::homeOf(Id halfedge) const
{
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15U; // Fibonacci hashing (Knuth, 6.4)
  return (halfedge * golden) >> (64 - this->bits_);
}

Id WaitingLists::find(Id halfedge) const
{
  if (this->count_ == 0)
  {
    return NoId;
  }
  std::size_t place = this->homeOf(halfedge);
  while (this->table_[place] != NoId && this->lists_[this->table_[place]].halfedge != halfedge)
  {
    place = (place + 1) & this->mask();
  }
  return this->table_[place];
}

Id WaitingLists::add(Id halfedge, const WindowBlock& block)
{
  if (2 * (this->count_ + 1) > this->table_.size())
  {
    this->grow();
  }
  if (this->unused_ == NoId)
  {
    this->unused_ = static_cast<Id>(this->lists_.size());
    this->lists_.emplace_back();
  }
  const Id list = this->unused_;
  this->unused_ = this->lists_[list].next;
  this->lists_[list] = { block, halfedge };
  this->enter(list);
  ++this->count_;
  return list;
}

void WaitingLists::enter(Id list)
{
  std::size_t place = this->homeOf(this->lists_[list].halfedge);
  while (this->table_[place] != NoId)
  {
    place = (place + 1) & this->mask();
  }
  this->table_[place] = list;
}

void WaitingLists::grow()
{
  constexpr unsigned leastBits = 5;
  this->bits_ = std::max(leastBits, this->bits_ + 1);
  std::vector<Id> old(std::size_t(1) << this->bits_, NoId);
  old.swap(this->table_);
  for (const Id list : old)
  {
    if (list != NoId)
    {
      this->enter(list);
    }
  }
}

// Lists behind the gap move forward if their probe sequences allow it, so that find() never stops
// at a gap before them (Knuth, 6.4, algorithm R).
WindowBlock WaitingLists::remove(Id list)
{
  std::size_t gap = this->homeOf(this->lists_[list].halfedge);
  while (this->table_[gap] != list)
  {
    gap = (gap + 1) & this->mask();
  }
  for (std::size_t place = (gap + 1) & this->mask(); this->table_[place] != NoId;
       place = (place + 1) & this->mask())
  {
    const std::size_t home = this->homeOf(this->lists_[this->table_[place]].halfedge);
    if (((place - home) & this->mask()) >= ((place - gap) & this->mask()))
    {
      this->table_[gap] = this->table_[place];
      gap = place;
    }
  }
  this->table_[gap] = NoId;
  --this->count_;
  this->lists_[list].next = this->unused_;
  this->unused_ = list;
  return this->lists_[list].windows;
}

void WaitingLists::assign(Id list, const WindowRange& windows, WindowPool& pool)
{
  WindowBlock& block = this->lists_[list].windows;
  if (windows.size() <= (std::size_t(1) << block.sizeClass))
  {
    std::copy(windows.begin(), windows.end(), block.data);
    block.size = static_cast<std::uint32_t>(windows.size());
    return;
  }
  const WindowBlock larger = pool.copyOf(windows);
  pool.free(block);
  block = larger;
}

}
