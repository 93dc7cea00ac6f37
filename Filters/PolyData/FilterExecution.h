// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FilterExecution_h
#define geodesic_FilterExecution_h

#include "Exchange.h"
#include "Job.h"
#include "PolyData/Notes.h"
#include "PolyData/Stages.h"

#include <chrono>
#include <vector>

class vtkAlgorithm;

namespace geodesic
{

/// One execution of a filter: which stage it is in, whom it works with, and what the user should
/// know. It tells the filter how far the work is, and obeys abort.
class FilterExecution
{
public:
  /// \param stages that the execution will have.
  /// \param exchange with the other ranks, all of which have such an execution.
  FilterExecution(vtkAlgorithm* filter, std::vector<Stage> stages, Exchange& exchange);
  FilterExecution(const FilterExecution&) = delete;
  FilterExecution& operator=(const FilterExecution&) = delete;

  /// Begins a stage, or begins it again.
  ///
  /// \returns its job, on the threads that vtkSMPTools is set to use. Whoever tells it how far the
  ///          stage is, throws NotEnoughMemory if the system has hardly any left.
  /// \throws Aborted
  Job begin(Stage stage);
  /// The stage that has begun last.
  Stage stage() const { return this->stage_; }
  /// The threads and the watcher, for short loops between stages.
  const Job& job() const { return this->job_; }

  /// Between all ranks.
  Exchange& exchange() const { return this->exchange_; }
  /// What the user should know.
  Notes& notes() { return this->notes_; }

private:
  bool tellFilter(double done);

  vtkAlgorithm* filter_;
  std::vector<Stage> stages_;
  Stage stage_ = Stage::ReadSurface;
  Job job_;
  /// When to look at the memory again.
  std::chrono::steady_clock::time_point nextLook_ = std::chrono::steady_clock::time_point::min();
  Exchange& exchange_;
  Notes notes_;
};

}

#endif
