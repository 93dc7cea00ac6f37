// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ArrayMemory_h
#define geodesic_ArrayMemory_h

#include "vtkType.h"

class vtkFieldData;

namespace geodesic
{

/// Asks for the memory that VTK's arrays are about to take. Where one of them gets none, VTK ends
/// the process, unless it was compiled with NDEBUG, which distributions do not do.
///
/// \throws std::bad_alloc where there is not so much.
void requireMemory(vtkIdType tuples, vtkIdType bytesATuple);

/// What one tuple of all arrays takes.
vtkIdType bytesATuple(vtkFieldData* data);

}

#endif
