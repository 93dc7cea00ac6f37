// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ParallelFor_h
#define geodesic_ParallelFor_h

#include "Tasks.h"

namespace geodesic
{

/// The engine's parallelFor on the threads that vtkSMPTools is set to use; empty where that is one.
/// It has its threads from its first call until its last copy is gone: not to be kept longer than a
/// solve.
/// An exception of a task is thrown again in the caller's thread.
ParallelFor smpParallelFor();

}

#endif
