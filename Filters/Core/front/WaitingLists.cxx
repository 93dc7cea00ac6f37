// SPDX-License-Identifier: BSD-3-Clause
#include "front/WaitingLists.h"

namespace geodesic
{

WindowBlock WaitingLists::blockAt(Id halfedge) const
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
  pool.free(this->blockAt(halfedge));
  this->adopt(halfedge, block);
}

void WaitingLists::clear(Id halfedge, WindowPool& pool)
{
  pool.free(this->release(halfedge));
}

WindowBlock WaitingLists::release(Id halfedge)
{
  const WindowBlock block = this->blockAt(halfedge);
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
