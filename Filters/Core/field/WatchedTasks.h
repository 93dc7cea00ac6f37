// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WatchedTasks_h
#define geodesic_WatchedTasks_h

#include "Progress.h"
#include "front/Front.h"

#include <cstddef>
#include <functional>

namespace geodesic
{

/// Work that tells how far it is: it calls the callback with a fraction done, and stops with
/// Aborted where that returns false.
using WatchedTask = std::function<void(std::size_t number, const ProgressCallback& progress)>;

/// Runs tasks of some length side by side. While they run the calling thread tells how much of all
/// is done, many times a second: the callback is called from there only, whichever thread is at
/// work. After an exception of a task the others are stopped, and it is thrown again.
///
/// \param parallelFor absent: one task after another in the calling thread.
/// \param progress called with the fraction done in [0, 1]; returning false stops all tasks.
/// \throws Aborted
void runWatched(std::size_t count, const WatchedTask& task, const ParallelFor& parallelFor,
  const ProgressCallback& progress);

}

#endif
