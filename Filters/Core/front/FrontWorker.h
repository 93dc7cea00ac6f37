// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontWorker_h
#define geodesic_FrontWorker_h

#include "front/Outbox.h"
#include "front/SaddleWedge.h"
#include "front/VertexStates.h"
#include "window/FacePropagation.h"
#include "window/WindowList.h"
#include "window/WindowPool.h"

#include <vector>

namespace geodesic
{

/// What one task of a batch works with and leaves behind. Nothing in it depends on which thread
/// runs the task.
struct FrontWorker
{
  /// Its number among the workers.
  std::size_t number = 0;

  /// Work space.
  std::vector<ApexSide> apexSides;
  LeavingWindows leaving;
  WindowListBuilder merged;
  WindowPool pool;
  std::vector<EmittedInterval> emitted;

  /// The lists that it sends to halfedges.
  std::vector<SentList> sent;
  /// Paths found while lists went through faces, and where lists have come to.
  std::vector<DistanceUpdate> updates;
  std::vector<DistanceUpdate> arrivals;
  /// Halfedges that had no list, and those whose lists have changed.
  std::vector<Id> newLists;
  std::vector<Id> changedLists;
  /// Halfedges with windows within the distance limit.
  std::vector<Id> withinLimit;

  /// Over the whole solve: windows put on halfedges, and the largest relative error of a merge.
  std::uint64_t propagated = 0;
  double relativeError = 0.0;
};

/// The workers of a front. Tasks are cut by the number of items alone, and each has a worker of its
/// own.
class FrontWorkers
{
public:
  FrontWorkers()
    : workers_(1)
  {
  }

  std::size_t size() const { return this->workers_.size(); }
  auto begin() { return this->workers_.begin(); }
  auto end() { return this->workers_.end(); }
  FrontWorker& first() { return this->workers_.front(); }

  /// Into how many tasks a loop is cut.
  static std::size_t numberOfTasks(std::size_t items, bool parallel)
  {
    constexpr std::size_t itemsPerTask = 8;
    constexpr std::size_t maximumTasks = 32;
    return parallel ? std::clamp<std::size_t>(items / itemsPerTask, 1, maximumTasks) : 1;
  }

  void resize(std::size_t count)
  {
    this->workers_.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->workers_[i].number = i;
    }
  }

  /// Runs item(worker, i) for i below `items`, in so many tasks.
  template <typename ParallelFor, typename Item>
  void run(std::size_t items, std::size_t tasks, const ParallelFor& parallelFor, Item&& item)
  {
    const auto task = [&](std::size_t number)
    {
      const std::size_t last = (number + 1) * items / tasks;
      for (std::size_t i = number * items / tasks; i < last; ++i)
      {
        item(this->workers_[number], i);
      }
    };
    if (tasks == 1)
    {
      task(0);
      return;
    }
    parallelFor(tasks, task);
  }

private:
  std::vector<FrontWorker> workers_;
};

}

#endif
