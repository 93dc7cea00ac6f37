// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontWorker_h
#define geodesic_FrontWorker_h

#include "Job.h"
#include "front/SaddleWedge.h"
#include "window/FacePropagation.h"
#include "window/WindowList.h"
#include "window/WindowPool.h"

#include <atomic>
#include <utility>
#include <vector>

namespace geodesic
{

/// What a task of a batch works with: memory, and sums that do not depend on who adds. So a task
/// may use any worker.
struct FrontWorker
{
  std::vector<HalfedgeList> due;
  std::vector<ApexSide> apexSides;
  LeavingWindows leaving;
  WindowListBuilder merged;
  std::vector<Window> bounds;
  WindowPool pool;
  std::vector<EmittedInterval> emitted;

  /// Over the whole solve: windows put on halfedges, and the largest relative error of a merge.
  std::uint64_t propagated = 0;
  double relativeError = 0.0;
  /// How many windows were read or written since takeWork(); a list counts as some more.
  std::uint64_t work = 0;

  /// Lets the watcher stop the work, about once a millisecond. To be called between lists.
  ///
  /// \param windows how many windows were read or written since the last call.
  void look(const Job& job, std::size_t windows)
  {
    constexpr std::size_t windowsPerLook = 1U << 12;
    constexpr std::size_t workOfList = 8;
    this->work += windows + workOfList;
    this->sinceLook_ += windows;
    if (this->sinceLook_ >= windowsPerLook)
    {
      this->sinceLook_ = 0;
      job.look();
    }
  }

private:
  std::size_t sinceLook_ = 0;
};

/// The workers of a front: as many as there are threads, so that a task reuses the memory of
/// earlier ones.
class FrontWorkers
{
public:
  explicit FrontWorkers(const Job& job)
    : job_(job)
    , slots_(job.isParallel() ? MostThreads : 1)
  {
    this->slots_.front().wasUsed = true;
  }

  /// The worker for work outside of tasks.
  FrontWorker& first() { return this->slots_.front().worker; }

  /// Calls visit(FrontWorker&) for each worker that was used, between runs.
  template <typename Visit>
  void forEach(Visit&& visit)
  {
    for (WorkerSlot& slot : this->slots_)
    {
      if (slot.wasUsed)
      {
        visit(slot.worker);
      }
    }
  }

  /// The work of all workers since the last call.
  std::uint64_t takeWork()
  {
    std::uint64_t work = 0;
    this->forEach([&work](FrontWorker& worker) { work += std::exchange(worker.work, 0); });
    return work;
  }

  /// Runs item(worker, i) for i below `items`, in parallel if there are several.
  template <typename Item>
  void run(std::size_t items, Item&& item)
  {
    if (!this->job_.isParallel() || items == 1)
    {
      for (std::size_t i = 0; i < items; ++i)
      {
        item(this->first(), i);
      }
      return;
    }
    this->job_.tasks(items,
      [&](std::size_t i)
      {
        const SlotLock lock(*this);
        item(lock.worker(), i);
      });
  }

private:
  /// If there are more threads, they wait for one another.
  static constexpr std::size_t MostThreads = 64;

  struct alignas(64) WorkerSlot
  {
    FrontWorker worker;
    /// Whether a task has used it; read between runs.
    bool wasUsed = false;
    std::atomic<bool> isTaken{ false };
  };

  /// Takes a free slot for a task. A thread first tries its last slot, whose memory is near.
  class SlotLock
  {
  public:
    explicit SlotLock(FrontWorkers& workers)
    {
      thread_local std::size_t last = 0;
      while (workers.slots_[last].isTaken.exchange(true, std::memory_order_acquire))
      {
        last = (last + 1) % workers.slots_.size();
      }
      this->slot_ = &workers.slots_[last];
      this->slot_->wasUsed = true;
    }
    ~SlotLock() { this->slot_->isTaken.store(false, std::memory_order_release); }
    SlotLock(const SlotLock&) = delete;
    SlotLock& operator=(const SlotLock&) = delete;

    FrontWorker& worker() const { return this->slot_->worker; }

  private:
    WorkerSlot* slot_;
  };

  const Job& job_;
  std::vector<WorkerSlot> slots_;
};

}

#endif
