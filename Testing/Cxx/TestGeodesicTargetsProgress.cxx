// SPDX-License-Identifier: BSD-3-Clause
// Lines, paths and matrices report progress, which never stands still and never falls, on a surface
// of a million triangles too, and answer abort at once.
#include "ProgressTesting.h"

#include "vtkGeodesicContour.h"
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

vtkSmartPointer<vtkGeodesicAlgorithm> MakePaths(vtkPolyData* surface)
{
  auto paths = vtkSmartPointer<vtkGeodesicPaths>::New();
  paths->SetInputData(surface);
  paths->SetSourceData(Polyline({ { 0.31, 0.42, 0 }, { 0.43, 0.33, 0 } }));
  paths->SetTargetsData(Cloud(2000));
  return paths;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeMatrix(vtkPolyData* surface)
{
  auto matrix = vtkSmartPointer<vtkGeodesicDistanceMatrix>::New();
  matrix->SetInputData(surface);
  matrix->SetSourceData(Cloud(2));
  matrix->SetTargetsData(Cloud(50));
  return matrix;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeContour(vtkPolyData* surface)
{
  auto contour = vtkSmartPointer<vtkGeodesicContour>::New();
  contour->SetInputData(surface);
  contour->SetSourceData(PointSources({ { 0.31, 0.42, 0 } }));
  contour->GenerateValues(200, 0.003, 0.6); // so many lines that drawing them takes time
  return contour;
}

void CheckAbortAt(
  Check& check, const std::string& what, double fraction, vtkGeodesicAlgorithm* filter)
{
  const std::string name = what + ", abort at " + std::to_string(fraction);
  CheckAbort(check, name, fraction, filter);
  check.That(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL) == 0 &&
      filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::ROW) == 0,
    name + ": the output is empty");
}

}

int TestGeodesicTargetsProgress(int, char*[])
{
  vtkSMPTools::SetBackend("Sequential"); // one thread's processor time counts
  Check check;
  const auto million = NoisySquare(720);
  const auto smaller = NoisySquare(200);
  CheckNeverStill(check, "lines", [&] { return MakeContour(smaller); });
  for (const double fraction : { 0.1, 0.5, 0.8 })
  {
    CheckAbortAt(check, "lines", fraction, MakeContour(smaller));
  }
  CheckNeverStill(check, "paths", [&] { return MakePaths(million); });
  CheckNeverStill(check, "a matrix", [&] { return MakeMatrix(million); });
  // So large that a report, which comes every 20 ms, is a small part of a run.
  const auto large = NoisySquare(400);
  // While the mesh is built, the source and the targets located, the front on its way, paths
  // traced.
  for (const double fraction : { 0.1, 0.24, 0.28, 0.4, 0.7 })
  {
    CheckAbortAt(check, "paths", fraction, MakePaths(large));
    CheckAbortAt(check, "a matrix", fraction, MakeMatrix(large));
  }
  return check.Result();
}
