// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ArrayMemory.h"

#include "vtkAbstractArray.h"
#include "vtkFieldData.h"

#include <new>

namespace geodesic
{

void requireMemory(vtkIdType tuples, vtkIdType bytesATuple)
{
  constexpr std::size_t forSmallThings = 1 << 20;
  const auto bytes = static_cast<std::size_t>(tuples) * static_cast<std::size_t>(bytesATuple);
  // Volatile, or the compiler may find that it is never used and leave it out.
  void* volatile memory = ::operator new(bytes + forSmallThings);
  ::operator delete(memory);
}

vtkIdType bytesATuple(vtkFieldData* data)
{
  vtkIdType bytes = 0;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    bytes += static_cast<vtkIdType>(array->GetNumberOfComponents()) *
      (array->GetDataTypeSize() > 0 ? array->GetDataTypeSize() : 1);
  }
  return bytes;
}

}
