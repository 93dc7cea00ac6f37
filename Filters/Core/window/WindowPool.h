// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowPool_h
#define geodesic_WindowPool_h

#include "window/Window.h"

#include <array>
#include <cstdint>
#include <memory>
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

/// Blocks of windows, whose sizes are powers of two, cut from large chunks and reused. Not
/// thread-safe: each worker has its own pool, but may free blocks of other pools into it.
class WindowPool
{
public:
  /// Allocates a block with a copy of the windows. The caller frees it.
  WindowBlock copyOf(const WindowRange& windows);
  /// Takes back a block of this pool, or of another pool that lives as long.
  void free(const WindowBlock& block);
  /// Returns the memory of all blocks cut from this pool, whoever uses them. The pool is then
  /// empty.
  std::vector<std::unique_ptr<Window[]>> release();

  /// The number of blocks of a size that need no new memory.
  std::size_t freeBlocks(std::uint32_t sizeClass) const { return this->freeBlocks_[sizeClass]; }

private:
  Window* allocate(std::uint32_t sizeClass);

  /// The first free block of each size; each begins with the address of the next.
  std::array<Window*, 32> free_{};
  std::array<std::size_t, 32> freeBlocks_{};
  std::vector<std::unique_ptr<Window[]>> chunks_;
  std::size_t chunkUsed_ = 0;
  std::size_t chunkSize_ = 0;
};

}

#endif
