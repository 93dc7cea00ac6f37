// SPDX-License-Identifier: BSD-3-Clause
// Checks of a filter's progress and of abort. Processor time tells how long it stands still: one
// thread must work.
#ifndef ProgressTesting_h
#define ProgressTesting_h

#include "GeodesicTesting.h"

namespace GeodesicTesting
{

/// Makes the filter with its inputs, anew: one that has run has kept the structure of its surface.
using MakeFilter = std::function<vtkSmartPointer<vtkAlgorithm>()>;

/// A stretch of a run without a report.
struct Still
{
  double Seconds = 0.0;
  double Progress = 0.0; // of the report at its end

  bool operator<(const Still& other) const { return this->Seconds < other.Seconds; }
};

/// Checks that a filter's progress never stands still for more than a tenth of the run's time,
/// never falls and comes to 1.
///
/// A machine with other work makes a stretch take longer here and there, in one run and not in the
/// next: what takes long by itself does so in each of several runs.
inline void CheckNeverStill(Check& check, const std::string& name, const MakeFilter& make)
{
  constexpr int runs = 5;
  std::string message;
  for (int run = 0; run < runs; ++run)
  {
    const auto filter = make();
    Still longest;
    double before = 0.0;
    const double begin = ProcessorTime();
    double last = begin;
    const auto note = [&]
    {
      const double now = ProcessorTime();
      const double progress = filter->GetProgress();
      longest = std::max(longest, Still{ now - last, progress });
      check.That(progress >= before, name + ": progress never falls");
      before = progress;
      last = now;
    };
    Listener listener(filter, vtkCommand::ProgressEvent, note);
    Messages messages(filter);
    messages.Update();
    note();
    check.That(messages.Error().empty(), name + ": no error");
    check.That(before == 1.0, name + ": progress to 1");

    const double total = last - begin;
    if (longest.Seconds <= 0.1 * total)
    {
      return;
    }
    message += name + ": still for " + std::to_string(longest.Seconds) + " of " +
      std::to_string(total) + " s before " + std::to_string(longest.Progress) + '\n';
  }
  check.That(false, message);
}

/// Asks to abort at the first progress of at least the fraction, and checks that the filter goes on
/// with nothing.
inline void CheckAbort(Check& check, const std::string& name, double fraction,
  const vtkSmartPointer<vtkAlgorithm>& filter)
{
  bool asked = false;
  int reports = 0;
  Listener listener(filter, vtkCommand::ProgressEvent,
    [&]
    {
      reports += asked && filter->GetProgress() < 1.0 ? 1 : 0;
      if (!asked && filter->GetProgress() >= fraction && filter->GetProgress() < 1.0)
      {
        asked = true;
        filter->SetAbortExecute(1);
      }
    });
  Messages messages(filter);
  messages.Update();
  check.That(asked, name + ": there was progress to abort at");
  check.That(reports == 0, name + ": " + std::to_string(reports) + " reports after it");
  check.That(messages.Error().empty(), name + " is no error: " + messages.Error());
}

}

#endif
