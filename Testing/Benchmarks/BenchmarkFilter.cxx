// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFilter.h"

#include "vtkGeodesicDistanceField.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <chrono>
#include <stdexcept>

FilterRun runFilter(vtkPolyData* surface, vtkPolyData* source, double relativeError, double refine)
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
  if (relativeError > 0.0)
  {
    filter->SetAccuracyToApproximate();
    filter->SetRelativeError(relativeError);
  }
  filter->SetRefineMesh(refine > 0.0);
  filter->SetRefinementTolerance(refine);

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
