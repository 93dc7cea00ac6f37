// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/FilterExecution.h"

#include "PolyData/Memory.h"
#include "ThreadTeam.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <utility>

namespace geodesic
{

FilterExecution::FilterExecution(
  vtkAlgorithm* filter, std::vector<Stage> stages, Exchange& exchange)
  : filter_(filter)
  , stages_(std::move(stages))
  , job_([this](double done) { return this->tellFilter(done); },
      teamOf(static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads())),
      Job::Sharing::WherePaying)
  , exchange_(exchange)
{
}

bool FilterExecution::tellFilter(double done)
{
  constexpr std::chrono::milliseconds pause(100); // in which a process takes some 100 MB
  const auto now = std::chrono::steady_clock::now();
  if (now >= this->nextLook_)
  {
    this->nextLook_ = now + pause;
    requireAnyMemory();
  }
  this->filter_->UpdateProgress(done);
#if VTK_VERSION_NUMBER >= 90220220630ULL
  return !this->filter_->CheckAbort();
#else
  return !this->filter_->GetAbortExecute();
#endif
}

Job FilterExecution::begin(Stage stage)
{
  this->stage_ = stage;
  double before = 0.0;
  double here = 0.0;
  double all = 0.0;
  for (const Stage other : this->stages_)
  {
    const double share = rowOf(other).share;
    before += other < stage ? share : 0.0;
    here += other == stage ? share : 0.0;
    all += share;
  }
  const Job job = this->job_.part(before / all, (before + here) / all);
  job.reach(0.0);
  return job;
}

}
