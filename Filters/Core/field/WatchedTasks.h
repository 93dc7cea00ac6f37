// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WatchedTasks_h
#define geodesic_WatchedTasks_h

#include "Progress.h"
#include "front/Front.h"

#include <cstddef>
#include <functional>

namespace geodesic
{

/// A task that reports its progress: it calls the callback with the fraction done, and throws
/// Aborted if the callback returns false.
using WatchedTask = std::function<void(std::size_t number, const ProgressCallback& progress)>;

/// Runs long tasks side by side. Meanwhile the calling thread reports, many times a second, how
/// much of all is done: the callback is called from the calling thread only. If a task throws, the
/// other tasks are stopped, and the exception is thrown again.
///
/// \param parallelFor if empty, one task after another in the calling thread.
/// \param progress called with the fraction done in [0, 1]; returning false stops all tasks.
/// \throws Aborted
void runWatched(std::size_t count, const WatchedTask& task, const ParallelFor& parallelFor,
  const ProgressCallback& progress);

}

#endif
