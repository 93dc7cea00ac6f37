// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowPool.h"

#include <cstring>
#include <new>

namespace geodesic
{

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
  Window* block = this->free_[sizeClass];
  if (block != nullptr)
  {
    --this->freeBlocks_[sizeClass];
    std::memcpy(&this->free_[sizeClass], static_cast<const void*>(block), sizeof(block));
    return block;
  }
  const std::size_t size = std::size_t(1) << sizeClass;
  if (this->chunkUsed_ + size > this->chunkSize_)
  {
    this->chunkSize_ = std::max(ChunkWindows, size);
    this->chunks_.emplace_back(new Window[this->chunkSize_]);
    this->chunkUsed_ = 0;
  }
  block = this->chunks_.back().get() + this->chunkUsed_;
  this->chunkUsed_ += size;
  return block;
}

void WindowPool::free(const WindowBlock& block)
{
  std::memcpy(static_cast<void*>(block.data), &this->free_[block.sizeClass], sizeof(block.data));
  this->free_[block.sizeClass] = block.data;
  ++this->freeBlocks_[block.sizeClass];
}

std::vector<std::unique_ptr<Window[]>> WindowPool::release()
{
  std::vector<std::unique_ptr<Window[]>> chunks = std::move(this->chunks_);
  *this = WindowPool();
  return chunks;
}

WindowBlock WindowPool::copyOf(const WindowRange& windows)
{
  if (windows.size() >> 31 != 0)
  {
    throw std::bad_alloc(); // more windows on one halfedge than any memory could hold
  }
  const std::uint32_t sizeClass = sizeClassOf(windows.size());
  const WindowBlock block = { this->allocate(sizeClass), static_cast<std::uint32_t>(windows.size()),
    sizeClass };
  if (block.size == 1)
  {
    *block.data = *windows.begin(); // most merged lists have one window
  }
  else
  {
    std::copy(windows.begin(), windows.end(), block.data);
  }
  return block;
}

}
