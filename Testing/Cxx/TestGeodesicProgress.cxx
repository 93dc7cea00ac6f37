// SPDX-License-Identifier: BSD-3-Clause
// On a surface of a million triangles progress never stands still and never falls, and abort is
// answered at once, wherever it is asked for.
#include "GeodesicTesting.h"

#include "vtkSMPTools.h"

using namespace GeodesicTesting;

namespace
{

/// A run whose progress is watched.
struct Watched
{
  std::string name;
  vtkSmartPointer<vtkPolyData> surface;
  bool refine = false;
  double tolerance = 0.001;
  double maximumDistance = 0.0;
  bool approximate = false;
};

void SetUp(vtkGeodesicDistanceField* filter, const Watched& run)
{
  filter->SetInputData(run.surface);
  filter->SetSourceData(Polyline({ { 0.31, 0.42, 0 }, { 0.43, 0.33, 0 } })); // corners of no face
  filter->SetRefineMesh(run.refine);
  filter->SetRefinementTolerance(run.tolerance);
  filter->SetMaximumDistance(run.maximumDistance);
  filter->SetAccuracy(run.approximate ? 1 : 0);
}

/// Watches the time that goes by between one report and the next.
void CheckNeverStill(Check& check, const Watched& run)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  SetUp(filter, run);
  std::vector<double> times;
  std::vector<double> progress;
  const auto note = [&]
  {
    times.push_back(ProcessorTime());
    progress.push_back(filter->GetProgress());
  };
  Listener listener(filter, vtkCommand::ProgressEvent, note);
  const double begin = ProcessorTime();
  Messages messages(filter);
  messages.Update();
  note();

  const double total = times.back() - begin;
  check.That(std::is_sorted(progress.begin(), progress.end()), run.name + ": progress never falls");
  check.That(progress.front() >= 0.0 && progress.back() == 1.0, run.name + ": progress to 1");
  double last = begin;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    check.That(times[i] - last <= 0.1 * total,
      run.name + ": still for " + std::to_string(times[i] - last) + " of " + std::to_string(total) +
        " s before " + std::to_string(progress[i]));
    last = times[i];
  }
  check.That(messages.Error().empty(), run.name + ": no error");
  check.That(Distances(filter) != nullptr, run.name + ": there is a distance");
}

/// Asks to abort at the first progress of at least the fraction.
void CheckAbortAt(Check& check, const Watched& run, double fraction)
{
  const std::string name = run.name + ", abort at " + std::to_string(fraction);
  vtkNew<vtkGeodesicDistanceField> filter;
  SetUp(filter, run);
  double asked = 0.0;
  double progress = 0.0;
  Listener listener(filter, vtkCommand::ProgressEvent,
    [&]
    {
      if (asked == 0.0 && filter->GetProgress() >= fraction)
      {
        asked = ProcessorTime();
        progress = filter->GetProgress();
        filter->SetAbortExecute(1);
      }
    });
  Messages messages(filter);
  messages.Update();
  const double seconds = ProcessorTime() - asked;
  check.That(asked != 0.0 && progress < 1.0, name + ": there was progress to abort at");
  check.That(seconds < 1.0, name + " took " + std::to_string(seconds) + " s of processor time");
  check.That(messages.Error().empty(), name + " is no error: " + messages.Error());
  CheckOutputsEmpty(check, filter, name);
}

}

int TestGeodesicProgress(int, char*[])
{
  vtkSMPTools::SetBackend("Sequential"); // one thread's processor time counts
  Check check;
  const auto million = NoisySquare(720);
  const auto smaller = NoisySquare(330);
  const Watched exact{ "a million triangles", million };
  Watched limited{ "a near limit", million };
  limited.maximumDistance = 0.01;
  Watched approximate{ "approximate", million };
  approximate.approximate = true;
  Watched refined{ "refined", smaller };
  refined.refine = true;
  refined.tolerance = 0.0002;
  Watched soup{ "refined triangles without common points", Soup(NoisySquare(100)) };
  soup.refine = true;
  soup.tolerance = 0.00005;
  const Watched quads{ "squares", NoisySquare(500, Cells::Quads) };
  for (const Watched& run : { exact, limited, approximate, refined, soup, quads })
  {
    CheckNeverStill(check, run);
  }

  // While the mesh is built, a source located, the front on its way, refinement at work, and the
  // output written.
  for (const double fraction : { 0.01, 0.1, 0.151, 0.3, 0.6, 0.85 })
  {
    CheckAbortAt(check, exact, fraction);
  }
  for (const double fraction : { 0.3, 0.56, 0.7, 0.86, 0.95 })
  {
    CheckAbortAt(check, refined, fraction);
  }
  return check.Result();
}
