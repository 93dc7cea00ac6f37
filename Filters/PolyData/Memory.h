// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Memory_h
#define geodesic_Memory_h

#include "vtkNew.h"
#include "vtkType.h"

#include <cstdint>
#include <new>

class vtkFieldData;

namespace geodesic
{

/// There is too little memory for what is about to be taken. Thrown before memory is taken, because
/// the system hands out more than it has, and ends a process that uses what it was given.
struct NotEnoughMemory : std::bad_alloc
{
  NotEnoughMemory(std::uint64_t bytesNeeded, std::uint64_t bytesAvailable)
    : needed(bytesNeeded)
    , available(bytesAvailable)
  {
  }
  const char* what() const noexcept override { return "not enough memory"; }

  /// How many bytes more; 0 where that is not known.
  std::uint64_t needed;
  /// How many bytes there are.
  std::uint64_t available;
};

/// How many bytes this process can still have, as the system says: what is free or can be freed
/// with what is left of swap, and the limits of the control groups that the process is in (a
/// container's). Limits of address space are not in it. Where the system says nothing, the largest
/// number.
std::uint64_t availableMemory();

/// Asks for the memory that VTK's arrays are about to take. If an array gets no memory, VTK ends
/// the process, unless VTK was compiled with NDEBUG, which distributions do not do.
///
/// \throws NotEnoughMemory where less is available; std::bad_alloc where there is not so much
///         address space.
void requireMemory(vtkIdType tuples, vtkIdType bytesATuple);

/// A named array of so many values, for which there is memory.
///
/// \throws what requireMemory() throws.
template <typename Array>
vtkNew<Array> makeArray(const char* name, vtkIdType count)
{
  requireMemory(count, sizeof(typename Array::ValueType));
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(count);
  return array;
}

/// Ends a computation before the system ends the process.
///
/// \throws NotEnoughMemory where hardly any is left.
void requireAnyMemory();

/// What one tuple of all arrays takes.
vtkIdType bytesATuple(vtkFieldData* data);

}

#endif
