// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThreadTeam_h
#define geodesic_ThreadTeam_h

#include "Job.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>

namespace geodesic
{

/// Threads that stay for a whole computation. A solve has some ten thousand short parallel loops,
/// and vtkSMPTools' backend STDThread starts its threads anew for each, which takes longer than the
/// loop: with a loop of vtkSMPTools for each in place of this, an exact solve on 269 thousand faces
/// takes 2.4 times as long on two threads. With the backend TBB it takes 1.0 to 1.1 times as long,
/// but not every VTK is built with TBB, and the engine is built without VTK.
///
/// Each thread, the caller's too, takes the tasks of a range of its own one by one, and then those
/// that are left of the others'. Ranges, because neighbouring tasks of one loop go on in
/// neighbouring tasks of the next, whose data are then at hand. For a moment after a loop, threads
/// look for the next one; then they sleep.
///
/// A system may say that it has more processors than a team gets: other processes work, or a
/// container has a quota. A thread that lets others run while it waits, and comes back late again
/// and again, has no processor of its own. Then the team has a member less for a while.
class ThreadTeam
{
public:
  /// \param threads that work, with the caller's. If some cannot be started, there are fewer.
  explicit ThreadTeam(std::size_t threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Runs the tasks of a ParallelFor. Called by one thread at a time, not by tasks.
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& wait = {});

private:
  using Clock = std::chrono::steady_clock;

  // The numbers of the next task and of the one after the last. Tasks of all loops are numbered
  // through, so that nobody takes a task of one loop for one of another.
  struct alignas(64) Range
  {
    std::atomic<std::uint64_t> next{ 0 };
    std::atomic<std::uint64_t> end{ 0 };
  };

  void start();
  void fitToMachine();
  void grow(Clock::time_point now);
  void share(std::size_t count);
  void waitForOthers(std::size_t count, const std::function<void()>& wait);
  void help(std::size_t member);
  void letOthersRun(int& lateness);
  void sleepUntilNext(std::size_t member, std::uint64_t loops);
  bool takeOne(std::size_t member);
  bool takeOneOf(Range& range);
  void keepException();

  /// One for each thread, the caller's first.
  std::vector<Range> ranges_;
  std::vector<std::thread> helpers_;
  std::atomic<const std::function<void(std::size_t)>*> task_{ nullptr };
  /// The number of the loop's first task, and of the one after its last.
  std::atomic<std::uint64_t> first_{ 0 };
  std::uint64_t end_ = 0;
  std::atomic<std::size_t> done_{ 0 };

  /// How many loops there were, how many threads sleep, and what wakes them.
  std::atomic<std::uint64_t> loops_{ 0 };
  std::atomic<std::size_t> sleepers_{ 0 };
  std::atomic<bool> stops_{ false };
  std::condition_variable wake_;

  /// How many members work, those with the lowest numbers; the others sleep. Any member may make
  /// it less, the caller's thread alone more.
  std::atomic<std::size_t> active_;
  /// How many there were in the last loop; when they became more, when they are to become more
  /// again, and how long they are to be fewer. See letOthersRun() for the last.
  std::size_t members_;
  Clock::time_point grown_;
  Clock::time_point nextGrowth_;
  Clock::duration pause_;
  int lateness_ = 0;

  /// Guards thrown_, and the moment at which a thread falls asleep.
  std::mutex guard_;
  std::exception_ptr thrown_;
};

/// So many threads for a Job; one thread if there are fewer than two. The threads start with the
/// first loop, and end with the last copy of the result.
ParallelFor teamOf(std::size_t threads);

}

#endif
