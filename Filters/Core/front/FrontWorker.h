// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontWorker_h
#define geodesic_FrontWorker_h

#include "front/Front.h"
#include "front/SaddleWedge.h"
#include "window/FacePropagation.h"
#include "window/WindowList.h"
#include "window/WindowPool.h"

#include <atomic>
#include <vector>

namespace geodesic
{

/// What a task of a batch works with: memory, and sums for which it does not matter who adds. So it
/// does not matter which worker a task gets.
struct FrontWorker
{
  std::vector<ApexSide> apexSides;
  LeavingWindows leaving;
  WindowListBuilder merged;
  WindowPool pool;
  std::vector<EmittedInterval> emitted;

  /// Over the whole solve: windows put on halfedges, and the largest relative error of a merge.
  std::uint64_t propagated = 0;
  double relativeError = 0.0;

  /// Windows that it has read or written, over the whole solve, and how many of them make it pause:
  /// one list after another is worked on only until then, so that progress can be told.
  std::uint64_t handled = 0;
  std::uint64_t pauseAt = 0;
  std::uint64_t turn = 0;

  bool hasToPause() const { return this->handled >= this->pauseAt; }
  void begin(std::uint64_t itsTurn)
  {
    constexpr std::uint64_t windowsPerTurn = 1U << 17; // some hundredths of a second
    if (this->turn != itsTurn)
    {
      this->turn = itsTurn;
      this->pauseAt = this->handled + windowsPerTurn;
    }
  }
};

/// The workers of a front: as many as there are threads, so that memory that one task gives back is
/// there for the next.
class FrontWorkers
{
public:
  explicit FrontWorkers(const ParallelFor& parallelFor)
    : parallelFor_(parallelFor)
    , desks_(parallelFor ? MostThreads : 1)
  {
    this->desks_.front().isUsed = true;
  }

  /// For work outside of tasks.
  FrontWorker& first() { return this->desks_.front().worker; }

  /// Calls visit(FrontWorker&) for each that has worked.
  template <typename Visit>
  void forEach(Visit&& visit)
  {
    for (WorkerSlot& desk : this->desks_)
    {
      if (desk.isUsed)
      {
        visit(desk.worker);
      }
    }
  }

  /// Runs item(worker, i) for i below `items`, at the same time where there are several. A turn of
  /// the workers, after which each may work on if it had to pause.
  template <typename Item>
  void run(std::size_t items, Item&& item)
  {
    ++this->turn_;
    this->first().begin(this->turn_);
    if (!this->parallelFor_ || items == 1)
    {
      for (std::size_t i = 0; i < items; ++i)
      {
        item(this->first(), i);
      }
      return;
    }
    this->parallelFor_(items,
      [&](std::size_t i)
      {
        const SlotLock seat(this->desks_);
        seat.worker().begin(this->turn_);
        item(seat.worker(), i);
      });
  }

private:
  /// More threads than this wait for one another.
  static constexpr std::size_t MostThreads = 64;

  struct alignas(64) WorkerSlot
  {
    FrontWorker worker;
    std::atomic<bool> isTaken{ false };
    bool isUsed = false;
  };

  /// Takes a desk for a task. A thread tries the same one first each time, whose memory is near.
  class SlotLock
  {
  public:
    explicit SlotLock(std::vector<WorkerSlot>& desks)
    {
      thread_local std::size_t last = 0;
      while (desks[last].isTaken.exchange(true, std::memory_order_acquire))
      {
        last = (last + 1) % desks.size();
      }
      this->desk_ = &desks[last];
      this->desk_->isUsed = true;
    }
    ~SlotLock() { this->desk_->isTaken.store(false, std::memory_order_release); }
    SlotLock(const SlotLock&) = delete;
    SlotLock& operator=(const SlotLock&) = delete;

    FrontWorker& worker() const { return this->desk_->worker; }

  private:
    WorkerSlot* desk_;
  };

  const ParallelFor& parallelFor_;
  std::vector<WorkerSlot> desks_;
  std::uint64_t turn_ = 0;
};

}

#endif
