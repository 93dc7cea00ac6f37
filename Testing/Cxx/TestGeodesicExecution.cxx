// SPDX-License-Identifier: BSD-3-Clause
// The filter executes when something changed and only then, reuses the surface when only the source
// did, runs again after an abort, and takes requests from outside.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkUnsignedCharArray.h"

using namespace GeodesicTesting;

namespace
{

void CheckExecutesWhenSomethingChanged(Check& check)
{
  auto surface = Square(4);
  auto source = PointSources({ { 0, 0, 0 } });
  const auto filter = PlainField(surface, source);
  int executions = 0;
  Listener listener(filter, vtkCommand::StartEvent, [&] { ++executions; });

  const auto expect = [&](int expected, const std::string& what)
  {
    executions = 0;
    filter->Update();
    check.Equal(executions, expected, "executions " + what);
  };
  expect(1, "the first time");
  expect(0, "without a change");
  filter->SetSourceType(filter->GetSourceType());
  filter->SetMaximumDistance(filter->GetMaximumDistance());
  filter->SetMergeCoincidentPoints(filter->GetMergeCoincidentPoints());
  filter->SetDistanceArrayName("GeodesicDistance");
  filter->SetAccuracy(filter->GetAccuracy());
  filter->SetRelativeError(filter->GetRelativeError());
  filter->SetRefineMesh(filter->GetRefineMesh());
  filter->SetRefinementTolerance(filter->GetRefinementTolerance());
  filter->SetToleranceIsAbsolute(filter->GetToleranceIsAbsolute());
  filter->SetAbsoluteRefinementTolerance(filter->GetAbsoluteRefinementTolerance());
  filter->SetMaximumNumberOfCells(filter->GetMaximumNumberOfCells());
  expect(0, "after setting properties to what they are");
  filter->SetMaximumDistance(0.5);
  expect(1, "after a property changed");
  source->GetPoints()->SetPoint(0, 1, 0, 0);
  source->GetPoints()->Modified();
  expect(1, "after the source changed");
  surface->GetPoints()->SetPoint(0, -1, 0, 0);
  surface->GetPoints()->Modified();
  expect(1, "after the surface changed");
}

void CheckSurfaceIsReused(Check& check)
{
  auto surface = Square(8, Cells::Quads);
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetInputData(surface);
  BuildWatch builds(filter);
  const auto expect = [&](bool built, const std::string& what)
  { builds.Expect(check, built, what); };

  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  expect(true, "the first time");
  filter->SetSourceData(PointSources({ { 1, 1, 0 } }));
  expect(false, "for another source");
  CheckDistances(check, filter, DistanceTo({ { 1, 1, 0 } }), "another source");
  filter->SetSourceTypeToSurfaceBoundary();
  expect(false, "for another source type");
  CheckDistances(check, filter, DistanceToBoundaryOfSquare, "another source type");
  filter->SetSourceTypeToSourceCurve();
  filter->SetSourceData(vtkNew<vtkPolyData>());
  Messages(filter).ExpectError(check, { "empty" }, "a source that fails");
  check.Equal(builds.Count(), 0, "the structure is not built for a source that fails");
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  expect(false, "after a source that failed");
  filter->RefineMeshOn();
  expect(false, "for refinement");
  filter->SetRefinementTolerance(0.01);
  expect(false, "for another tolerance");
  filter->SetAccuracyToApproximate();
  expect(false, "for an approximate field");
  filter->SetAccuracyToExact();
  filter->RefineMeshOff();
  filter->MergeCoincidentPointsOff();
  expect(true, "when points are no longer merged");

  // A change in place counts, whether told by the points or by the surface.
  MovePoints(surface, ScaledBy(2));
  surface->Modified();
  expect(true, "after the surface changed");
  CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "the changed surface");
  filter->SetInputData(Square(8, Cells::Quads));
  expect(true, "for another surface");
}

template <typename Array>
vtkSmartPointer<Array> Filled(const char* name, vtkIdType tuples, double value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(tuples);
  array->Fill(value);
  return array;
}

/// The structure depends on coordinates, cells, ghost flags and global ids, and on nothing else;
/// values count, whether or not anything tells that they are modified.
void CheckWhatTheStructureDependsOn(Check& check)
{
  auto surface = Square(8, Cells::Quads);
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  BuildWatch builds(filter);
  const auto expect = [&](vtkPolyData* input, bool built, const std::string& what)
  {
    filter->SetInputData(input);
    filter->Modified();
    builds.Expect(check, built, what);
  };
  expect(surface, true, "the first time");
  vtkNew<vtkPolyData> withArrays;
  withArrays->ShallowCopy(surface);
  withArrays->GetPointData()->AddArray(Filled<vtkDoubleArray>("Heat", 81, 1.0));
  withArrays->GetCellData()->SetScalars(Filled<vtkDoubleArray>("Number", 64, 2.0));
  expect(withArrays, false, "for more arrays upstream");
  check.That(filter->GetOutput()->GetPointData()->HasArray("Heat") &&
      filter->GetOutput()->GetCellData()->HasArray("Number"),
    "which are passed on");
  const auto copy = CopyOf(withArrays);
  expect(copy, false, "for a copy");

  copy->GetPoints()->SetPoint(40, 0.5, 0.5, 0.25);
  expect(copy, true, "after a coordinate changed in place");
  copy->GetPoints()->SetPoint(40, 0.5, 0.5, 0.0);
  expect(copy, true, "after it changed back");
  vtkNew<vtkIdList> turned;
  for (const vtkIdType id : { 1, 10, 9, 0 })
  {
    turned->InsertNextId(id);
  }
  copy->GetPolys()->ReplaceCellAtId(0, turned);
  expect(copy, true, "after a cell changed in place");
  auto ghosts = Filled<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), 64, 0.0);
  copy->GetCellData()->AddArray(ghosts);
  expect(copy, true, "with ghost flags");
  ghosts->SetValue(63, vtkDataSetAttributes::DUPLICATECELL);
  expect(copy, true, "after a ghost flag changed in place");
  ghosts->SetValue(63, 0);
  expect(copy, true, "after it changed back");
  auto ids = Filled<vtkIdTypeArray>("Ids", 81, 0.0);
  copy->GetPointData()->SetGlobalIds(ids);
  expect(copy, true, "with global ids");
  ids->SetValue(5, 5);
  expect(copy, true, "after a global id changed in place");
  expect(copy, false, "without a change");
}

void CheckStructureIsReleasedWithTheOutput(Check& check)
{
  const auto filter = PlainField(Square(8, Cells::Quads), PointSources({ { 0, 0, 0 } }));
  BuildWatch builds(filter);
  for (const bool isReleased : { false, true })
  {
    filter->SetReleaseDataFlag(isReleased ? 1 : 0);
    filter->Modified();
    filter->Update();
    builds.Count();
    filter->Modified();
    filter->Update();
    check.That(builds.Count() == (isReleased ? 1 : 0),
      std::string("the structure is ") + (isReleased ? "released" : "kept") + " with the output");
  }
}

/// That progress never falls and that an abort leaves nothing, TestGeodesicProgress shows.
void CheckRunsAfterAnAbort(Check& check)
{
  const auto filter = RefinedField(Square(256), Polyline({ { 0.1, 0.1, 0 }, { 0.9, 0.3, 0 } }));
  for (const double fraction : { 0.05, 0.3, 0.8 })
  {
    bool isAsked = false;
    Listener listener(filter, vtkCommand::ProgressEvent,
      [&]
      {
        isAsked = isAsked || filter->GetProgress() >= fraction;
        filter->SetAbortExecute(isAsked ? 1 : 0);
      });
    filter->Modified();
    filter->Update();
    CheckOutputsEmpty(check, filter, "an abort");
    filter->RemoveObservers(vtkCommand::ProgressEvent);
    filter->SetAbortExecute(0);
    filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
    filter->Update();
    CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "the execution after an abort");
  }
}

/// As an executive does it, and whoever else has the filter by its own class.
void CheckTakesRequests(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  vtkExecutive* executive = filter->GetExecutive();
  vtkNew<vtkInformation> request;
  request->Set(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT());
  request->Set(vtkExecutive::FROM_OUTPUT_PORT(), 0);
  check.Equal(filter->ProcessRequest(
                request, executive->GetInputInformation(), executive->GetOutputInformation()),
    1, "what a request for output objects returns");
  check.That(executive->GetOutputData(0) != nullptr, "the request has made an output object");
}

}

int TestGeodesicExecution(int, char*[])
{
  Check check;
  CheckExecutesWhenSomethingChanged(check);
  CheckSurfaceIsReused(check);
  CheckWhatTheStructureDependsOn(check);
  CheckStructureIsReleasedWithTheOutput(check);
  CheckRunsAfterAnAbort(check);
  CheckTakesRequests(check);
  return check.Result();
}
