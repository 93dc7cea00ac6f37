// SPDX-License-Identifier: BSD-3-Clause
// The outputs' arrays, names and types; the inputs stay as they were; properties and printing.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkStringArray.h"

#include <sstream>

using namespace GeodesicTesting;

namespace
{

vtkSmartPointer<vtkPolyData> SurfaceWithData()
{
  auto surface = Square(4, Cells::Triangles, VTK_FLOAT);
  vtkNew<vtkFloatArray> heat;
  heat->SetName("Heat");
  vtkNew<vtkFloatArray> color;
  color->SetName("Color");
  color->SetNumberOfComponents(3);
  color->SetNumberOfTuples(surface->GetNumberOfCells());
  color->Fill(0.5);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    heat->InsertNextValue(static_cast<float>(i));
  }
  vtkNew<vtkStringArray> title;
  title->SetName("Title");
  title->InsertNextValue("square");
  surface->GetPointData()->SetScalars(heat);
  surface->GetCellData()->AddArray(color);
  surface->GetFieldData()->AddArray(title);
  return surface;
}

void CheckArrays(Check& check)
{
  auto surface = SurfaceWithData();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(surface);
  const vtkMTimeType before = surface->GetMTime();
  const auto filter = PlainField(surface, Polyline({ { 0, 0.5, 0 }, { 1, 0.5, 0 } }));
  Messages messages(filter);
  messages.Update();

  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* distances = Distances(filter);
  check.Equal(distances->GetDataType(), VTK_DOUBLE, "type of the distances");
  check.Equal(distances->GetNumberOfComponents(), 1, "components of the distances");
  check.That(output->GetPointData()->GetScalars() == distances, "the distances are the scalars");
  check.That(output->GetPointData()->HasArray("Heat"), "point data is passed");
  check.That(output->GetCellData()->HasArray("Color"), "cell data is passed");
  check.That(output->GetFieldData()->HasArray("Title"), "field data is passed");

  for (const char* name : { "WindowsPropagatedPerEdge", "SourceLength", "SourceSnapDistance",
         "RelativeErrorBound", "InterpolationErrorBound" })
  {
    vtkDataArray* array = output->GetFieldData()->GetArray(name);
    check.That(array && array->GetNumberOfTuples() == 1, std::string("field data ") + name);
  }
  check.Equal(output->GetFieldData()->GetArray("WindowsPropagatedPerEdge")->GetTuple1(0),
    filter->GetWindowsPropagatedPerEdge(), "the getter and the array of windows");
  check.That(
    filter->GetWindowsPropagatedPerEdge() > 0.0 && filter->GetWindowsPropagatedPerEdge() < 20,
    "windows per edge of a square");
  check.Equal(output->GetFieldData()->GetArray("SourceSnapDistance")->GetTuple1(0),
    filter->GetSourceSnapDistance(), "the getter and the array of the snap distance");

  check.That(surface->GetMTime() == before, "the input is not modified");
  check.Equal(surface->GetPointData()->GetNumberOfArrays(), 1, "the input's point arrays");
  check.That(surface->GetPointData()->GetScalars() == surface->GetPointData()->GetArray("Heat"),
    "the input's scalars");
  check.Equal(surface->GetFieldData()->GetNumberOfArrays(), 1, "the input's field arrays");
  check.Equal(surface->GetPolys()->GetNumberOfConnectivityIds(),
    copy->GetPolys()->GetNumberOfConnectivityIds(), "the input's cells");
}

void CheckCurveOutput(Check& check)
{
  const auto filter = PlainField(Square(4), Polyline({ { 0.1, 0.55, 0 }, { 0.9, 0.55, 0 } }));
  filter->Update();
  auto* curves = OutputOf(filter, 1);
  check.Equal(curves->GetPoints()->GetDataType(), VTK_DOUBLE, "type of the curve's points");
  // Between x = 0.1 and 0.9 the line y = 0.55 crosses 3 upright edges and 3 diagonals.
  check.Equal(curves->GetNumberOfPoints(), 8.0, "points of the curve");
  check.Equal(curves->GetNumberOfLines(), 1.0, "lines of the curve");
  double last = 0.0;
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    const double* p = curves->GetPoint(i);
    check.That(p[0] > last && std::abs(p[1] - 0.55) < 1e-15, "the curve runs straight");
    last = p[0];
  }
}

void CheckArrayName(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetInputData(Square(2));
  filter->SetSourceTypeToSurfaceBoundary();
  filter->SetDistanceArrayName("Depth");
  filter->Update();
  check.That(filter->GetOutput()->GetPointData()->HasArray("Depth"), "the array has its name");
  check.That(
    !filter->GetOutput()->GetPointData()->HasArray("GeodesicDistance"), "and no other is there");
}

void CheckMaximumDistance(Check& check)
{
  const int n = 32;
  const double limit = 0.3;
  const Distance truth = DistanceTo({ { 0, 0, 0 } });
  const auto filter = PlainField(Square(n), PointSources({ { 0, 0, 0 } }));
  filter->SetMaximumDistance(limit);
  filter->Update();
  vtkIdType finite = 0;
  vtkPolyData* output = filter->GetOutput();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Point p = PointAt(output, i);
    const double distance = Distances(filter)->GetTuple1(i);
    finite += std::isfinite(distance) ? 1 : 0;
    check.That(truth(p) > limit || std::abs(distance - truth(p)) < 1e-14, "exact within the limit");
  }
  check.That(finite < output->GetNumberOfPoints() / 4, "the front stopped");
  filter->SetMaximumDistance(0.0);
  filter->Update();
  CheckDistances(check, filter, truth, "without limit again");
}

void CheckPropertiesAndPrinting(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetSourceType(7);
  check.Equal(filter->GetSourceType(), 2, "a source type beyond the last");
  check.Equal(filter->GetMaximumDistance(), 0.0, "the limit by default");
  check.That(filter->GetJoinLines(), "lines are joined by default");
  check.That(filter->GetMergeCoincidentPoints(), "points are merged by default");
  check.Equal(filter->GetAccuracy(), 0, "accuracy by default");
  check.Equal(filter->GetRelativeError(), 0.001, "relative error by default");
  check.That(filter->GetRefineMesh(), "the mesh is refined by default");
  check.That(!filter->GetToleranceIsAbsolute(), "the tolerance is relative by default");
  check.Equal(filter->GetMaximumNumberOfCells(), 50000000.0, "most cells by default");
  filter->SetAccuracyToApproximate();
  filter->SetRelativeError(0.25);
  filter->RefineMeshOff();
  filter->ToleranceIsAbsoluteOn();
  filter->SetMaximumNumberOfCells(7);
  std::ostringstream text;
  filter->Print(text);
  for (const char* name : { "SourceType: 2", "Accuracy: Approximate", "RelativeError: 0.25",
         "RefineMesh: Off", "RefinementTolerance: 0.001", "ToleranceIsAbsolute: On",
         "AbsoluteRefinementTolerance: 1", "MaximumNumberOfCells: 7", "RelativeErrorBound: 0",
         "InterpolationErrorBound: inf", "MaximumDistance: 0", "JoinLines: On",
         "MergeCoincidentPoints: On", "Controller: (global)", "DistanceArrayName: GeodesicDistance",
         "WindowsPropagatedPerEdge: 0", "SourceLength: 0", "SourceSnapDistance: 0" })
  {
    check.That(Contains(text.str(), name), std::string("printing says ") + name);
  }
}

}

int TestGeodesicOutput(int, char*[])
{
  Check check;
  CheckArrays(check);
  CheckCurveOutput(check);
  CheckArrayName(check);
  CheckMaximumDistance(check);
  CheckPropertiesAndPrinting(check);
  return check.Result();
}
