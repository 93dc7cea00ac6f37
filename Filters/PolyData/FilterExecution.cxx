// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/FilterExecution.h"

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
  this->memory_.look();
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
  const Stretch stretch = stretchOf(stage, this->stages_);
  const Job job = this->job_.part(stretch.begin, stretch.end);
  job.reach(0.0);
  return job;
}

}
