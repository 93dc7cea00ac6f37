// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkTasks_h
#define BenchmarkTasks_h

#include "Job.h"

#include <vector>

/// What more threads would give. Tasks run on one thread, one after another; the time of each is
/// taken, and those of one step are dealt out to the threads, the longest first. It holds neither
/// for memory that is slower when all cores use it nor for what a step costs to begin and end.
class TaskModel
{
public:
  /// \param numbersOfThreads for which it is asked.
  explicit TaskModel(const std::vector<int>& numbersOfThreads);

  /// Where its tasks are run; the model must outlive it.
  geodesic::ParallelFor parallelFor();

  /// \param seconds of all that was done, on one thread, in tasks and outside of them.
  /// \returns the share of what is outside of tasks.
  double serialShare(double seconds) const;
  /// \returns how many times as fast, for each number of threads.
  std::vector<double> gains(double seconds) const;

private:
  struct Threads
  {
    int number;
    /// Of all steps, in which the others wait for the busiest thread.
    double seconds;
  };

  void deal(std::vector<double> tasks);

  std::vector<Threads> threads_;
  double tasks_ = 0.0;
  /// Of the model itself.
  double overhead_ = 0.0;
};

#endif
