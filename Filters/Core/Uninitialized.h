// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Uninitialized_h
#define geodesic_Uninitialized_h

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace geodesic
{

/// Leaves the elements that resize() adds as they are in memory.
template <typename Value>
struct UninitializedAllocator : std::allocator<Value>
{
  template <typename Other>
  struct rebind
  {
    using other = UninitializedAllocator<Other>;
  };

  template <typename Element>
  void construct(Element* place) noexcept
  {
    ::new (static_cast<void*>(place)) Element;
  }
  template <typename Element, typename... Arguments>
  void construct(Element* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) Element{ std::forward<Arguments>(arguments)... };
  }
};

/// A vector for elements that tasks are about to write. resize() does not write them first: one
/// thread would do so alone, whereas each thread gets the memory that it writes first near itself.
template <typename Value>
using UninitializedVector = std::vector<Value, UninitializedAllocator<Value>>;

}

#endif
