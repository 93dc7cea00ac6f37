// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowPool_h
#define geodesic_WindowPool_h

#include "window/Window.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

namespace geodesic
{

/// The sorted windows of one halfedge, in a block of a WindowPool.
struct WindowBlock
{
  Window* data = nullptr;
  /// Number of windows; the block holds 2^sizeClass.
  std::uint32_t size = 0;
  std::uint32_t sizeClass = 0;

  WindowRange range() const { return { this->data, this->data + this->size }; }
};

/// A halfedge and its windows.
struct HalfedgeList
{
  Id halfedge;
  WindowBlock windows;
};

/// Blocks of windows, whose sizes are powers of two, cut from large chunks and reused. Not
/// thread-safe: each worker has its own pool, but may free blocks of other pools into it.
class WindowPool
{
public:
  /// Allocates a block with a copy of the windows. The caller frees it.
  WindowBlock copyOf(WindowRange windows)
  {
    if (windows.size() >> 31 != 0)
    {
      throw std::bad_alloc(); // more windows on one halfedge than any memory could hold
    }
    const std::uint32_t sizeClass = sizeClassOf(windows.size());
    const WindowBlock block = { this->allocate(sizeClass),
      static_cast<std::uint32_t>(windows.size()), sizeClass };
    Window* to = block.data;
    for (const Window& window : windows)
    {
      *to++ = window;
    }
    return block;
  }

  /// Replaces the windows of a block by copies of others; the block itself, too, if it is too
  /// small.
  void assign(WindowBlock& block, WindowRange windows)
  {
    if (windows.size() <= (std::size_t(1) << block.sizeClass))
    {
      std::copy(windows.begin(), windows.end(), block.data);
      block.size = static_cast<std::uint32_t>(windows.size());
      return;
    }
    const WindowBlock larger = this->copyOf(windows);
    this->free(block);
    block = larger;
  }

  /// Takes back a block of this pool, or of another pool that lives as long.
  void free(const WindowBlock& block)
  {
    std::memcpy(static_cast<void*>(block.data), &this->free_[block.sizeClass], sizeof(block.data));
    this->free_[block.sizeClass] = block.data;
    ++this->freeBlocks_[block.sizeClass];
  }
  /// Returns the memory of all blocks cut from this pool, whoever uses them. The pool is then
  /// empty.
  std::vector<std::unique_ptr<Window[]>> release()
  {
    std::vector<std::unique_ptr<Window[]>> chunks = std::move(this->chunks_);
    *this = WindowPool();
    return chunks;
  }

  /// The number of blocks of a size that need no new memory.
  std::size_t freeBlocks(std::uint32_t sizeClass) const { return this->freeBlocks_[sizeClass]; }

private:
  static constexpr std::size_t ChunkWindows = std::size_t(1) << 10;

  static std::uint32_t sizeClassOf(std::size_t size)
  {
    std::uint32_t sizeClass = 0;
    while ((std::size_t(1) << sizeClass) < size)
    {
      ++sizeClass;
    }
    return sizeClass;
  }

  Window* allocate(std::uint32_t sizeClass)
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

  /// The first free block of each size; each begins with the address of the next.
  std::array<Window*, 32> free_{};
  std::array<std::size_t, 32> freeBlocks_{};
  std::vector<std::unique_ptr<Window[]>> chunks_;
  std::size_t chunkUsed_ = 0;
  std::size_t chunkSize_ = 0;
};

}

#endif
