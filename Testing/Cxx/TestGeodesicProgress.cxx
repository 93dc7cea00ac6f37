// SPDX-License-Identifier: BSD-3-Clause
// Progress never stands still and never falls, also on a surface of a million triangles, and abort
// is answered at once, wherever it is asked for.
#include "ProgressTesting.h"

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

vtkSmartPointer<vtkGeodesicDistanceField> Make(const Watched& run)
{
  auto filter = vtkSmartPointer<vtkGeodesicDistanceField>::New();
  filter->SetInputData(run.surface);
  filter->SetSourceData(Polyline({ { 0.31, 0.42, 0 }, { 0.43, 0.33, 0 } })); // corners of no face
  filter->SetRefineMesh(run.refine);
  filter->SetRefinementTolerance(run.tolerance);
  filter->SetMaximumDistance(run.maximumDistance);
  filter->SetAccuracy(run.approximate ? 1 : 0);
  return filter;
}

void CheckAbortAt(Check& check, const Watched& run, double fraction)
{
  const std::string name = run.name + ", abort at " + std::to_string(fraction);
  const auto filter = Make(run);
  CheckAbort(check, name, fraction, filter);
  CheckOutputsEmpty(check, filter, name);
}

}

int TestGeodesicProgress(int, char*[])
{
  vtkSMPTools::SetBackend("Sequential"); // one thread's processor time counts
  Check check;
  const auto most = NoisySquare(720);
  // So large that a report, which comes every 20 ms, is a small part of a run.
  const auto large = NoisySquare(400);
  const auto smaller = NoisySquare(330);
  const Watched million{ "a million triangles", most };
  const Watched exact{ "exact", large };
  Watched limited{ "a near limit", most };
  limited.maximumDistance = 0.01;
  Watched approximate{ "approximate", large };
  approximate.approximate = true;
  Watched refined{ "refined", smaller };
  refined.refine = true;
  refined.tolerance = 0.0002;
  Watched soup{ "refined triangles without common points", Soup(NoisySquare(100)) };
  soup.refine = true;
  soup.tolerance = 0.00005;
  const Watched quads{ "squares", NoisySquare(500, Cells::Quads) };
  for (const Watched& run : { million, limited, approximate, refined, soup, quads })
  {
    CheckNeverStill(check, run.name, [&] { return Make(run); });
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
