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
  std::uint32_t size : 27;
  std::uint32_t sizeClass : 5;

  WindowRange range() const { return { this->data, this->data + this->size }; }
};

/// Blocks of windows in sizes of powers of two, cut from large chunks and used again. Not
/// thread-safe: each worker has its own, and a block may come from one and be freed into another.
class WindowPool
{
public:
  /// A block with a copy of the windows. The caller frees it.
  WindowBlock copyOf(const WindowRange& windows);
  /// Takes a block back, of this pool or of another one that lives as long.
  void free(const WindowBlock& block);
  /// Hands over the memory of all blocks that were cut from it, whoever has them; empty afterwards.
  std::vector<std::unique_ptr<Window[]>> release();

  /// How many blocks of a size it can hand out without new memory.
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
