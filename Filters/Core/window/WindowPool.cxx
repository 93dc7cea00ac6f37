// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowPool.h"

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

}
