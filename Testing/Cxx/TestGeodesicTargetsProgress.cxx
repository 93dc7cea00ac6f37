// SPDX-License-Identifier: BSD-3-Clause
// On a surface of a million triangles paths and matrices report progress, which never stands still
// and never falls, and answer abort at once.
#include "GeodesicTesting.h"

#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkSMPTools.h"

using namespace GeodesicTesting;

namespace
{

vtkSmartPointer<vtkPolyData> Cloud(int count)
{
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back({ 0.5 + 0.49 * std::sin(1.7 * i), 0.5 + 0.49 * std::sin(2.9 * i + 1.0), 0.0 });
  }
  return PointSources(points);
}

/// A filter with its inputs.
struct Query
{
  std::string Name;
  vtkSmartPointer<vtkGeodesicAlgorithm> Filter;
};

std::vector<Query> MakeQueries(vtkPolyData* surface)
{
  const auto paths = vtkSmartPointer<vtkGeodesicPaths>::New();
  paths->SetInputData(surface);
  paths->SetSourceData(Polyline({ { 0.31, 0.42, 0 }, { 0.43, 0.33, 0 } }));
  paths->SetTargetsData(Cloud(2000));
  const auto matrix = vtkSmartPointer<vtkGeodesicDistanceMatrix>::New();
  matrix->SetInputData(surface);
  matrix->SetSourceData(Cloud(2));
  matrix->SetTargetsData(Cloud(50));
  return { { "paths", paths }, { "a matrix", matrix } };
}

/// Watches the time that goes by between one report and the next.
void CheckNeverStill(Check& check, const Query& run)
{
  std::vector<double> times = { ProcessorTime() };
  std::vector<double> progress;
  const auto note = [&]
  {
    times.push_back(ProcessorTime());
    progress.push_back(run.Filter->GetProgress());
  };
  Listener listener(run.Filter, vtkCommand::ProgressEvent, note);
  Messages messages(run.Filter);
  messages.Update();
  note();
  const double total = times.back() - times.front();
  check.That(std::is_sorted(progress.begin(), progress.end()), run.Name + ": progress never falls");
  check.That(progress.back() == 1.0, run.Name + ": progress to 1");
  check.That(messages.Error().empty(), run.Name + ": no error");
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    check.That(times[i] - times[i - 1] <= 0.1 * total,
      run.Name + ": still for " + std::to_string(times[i] - times[i - 1]) + " of " +
        std::to_string(total) + " s before " + std::to_string(progress[i - 1]));
  }
}

/// Asks to abort at the first progress of at least the fraction.
void CheckAbortAt(Check& check, const Query& run, double fraction)
{
  const std::string name = run.Name + ", abort at " + std::to_string(fraction);
  double asked = 0.0;
  Listener listener(run.Filter, vtkCommand::ProgressEvent,
    [&]
    {
      if (asked == 0.0 && run.Filter->GetProgress() >= fraction)
      {
        asked = ProcessorTime();
        run.Filter->SetAbortExecute(1);
      }
    });
  Messages messages(run.Filter);
  messages.Update();
  const double seconds = ProcessorTime() - asked;
  check.That(asked != 0.0, name + ": there was progress to abort at");
  check.That(seconds < 1.0, name + " took " + std::to_string(seconds) + " s of processor time");
  check.That(messages.Error().empty(), name + " is no error: " + messages.Error());
  check.That(run.Filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL) == 0 &&
      run.Filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::ROW) == 0,
    name + ": the output is empty");
}

}

int TestGeodesicTargetsProgress(int, char*[])
{
  vtkSMPTools::SetBackend("Sequential"); // one thread's processor time counts
  Check check;
  const auto million = NoisySquare(720);
  for (const Query& run : MakeQueries(million))
  {
    CheckNeverStill(check, run);
  }
  // While the mesh is built, the source and the targets located, the front on its way, paths
  // traced.
  for (const double fraction : { 0.1, 0.24, 0.28, 0.4, 0.7 })
  {
    for (const Query& run : MakeQueries(million))
    {
      CheckAbortAt(check, run, fraction);
    }
  }
  return check.Result();
}
