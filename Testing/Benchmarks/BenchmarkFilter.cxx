// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFilter.h"

#include "vtkGeodesicDistanceField.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <chrono>
#include <stdexcept>

namespace
{

vtkNew<vtkGeodesicDistanceField> makeFilter(vtkPolyData* surface, vtkPolyData* source)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(surface);
  if (source)
  {
    filter->SetSourceData(source);
  }
  else
  {
    filter->SetSourceTypeToSurfaceBoundary();
  }
  return filter;
}

FilterRun update(vtkGeodesicDistanceField* filter)
{
  FilterRun run;
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.outputCells = filter->GetOutput()->GetNumberOfCells();
  if (run.outputCells == 0)
  {
    throw std::runtime_error("vtkGeodesicDistanceField has given no output");
  }
  return run;
}

} // anonymous namespace

FilterRun runFilter(vtkPolyData* surface, vtkPolyData* source, double relativeError, double refine)
{
  const vtkNew<vtkGeodesicDistanceField> filter = makeFilter(surface, source);
  if (relativeError > 0.0)
  {
    filter->SetAccuracyToApproximate();
    filter->SetRelativeError(relativeError);
  }
  filter->SetRefineMesh(refine > 0.0);
  filter->SetRefinementTolerance(refine);
  return update(filter);
}

FilterRun runFilterWithoutReach(vtkPolyData* surface, vtkPolyData* source)
{
  const vtkNew<vtkGeodesicDistanceField> filter = makeFilter(surface, source);
  constexpr double nearlyNothing = 1e-9;
  filter->SetMaximumDistance(nearlyNothing * surface->GetLength());
  filter->SetRefineMesh(false);
  return update(filter);
}
