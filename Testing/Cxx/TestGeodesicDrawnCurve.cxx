// SPDX-License-Identifier: BSD-3-Clause
// The source given by its points: open, closed and of one point, changed between executions, far
// from the surface, missing, and kept when the executive is exchanged.
#include "GeodesicTesting.h"

#include "vtkCompositeDataPipeline.h"
#include "vtkCubeSource.h"
#include "vtkGeodesicDistanceFieldFromDrawnCurve.h"

#include <algorithm>
#include <limits>

using namespace GeodesicTesting;

namespace
{

using DrawnField = vtkGeodesicDistanceFieldFromDrawnCurve;

void Draw(DrawnField* field, const std::vector<Point>& curve)
{
  field->SetNumberOfCurvePoints(static_cast<vtkIdType>(curve.size()));
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    field->SetCurvePoint(static_cast<vtkIdType>(i), curve[i][0], curve[i][1], curve[i][2]);
  }
}

vtkSmartPointer<DrawnField> Drawn(vtkPolyData* surface, const std::vector<Point>& curve)
{
  auto field = vtkSmartPointer<DrawnField>::New();
  field->SetInputData(surface);
  Draw(field, curve);
  return field;
}

std::vector<Point> Closed(std::vector<Point> curve)
{
  curve.push_back(curve.front());
  return curve;
}

void CheckCurves(Check& check)
{
  const std::vector<Point> bent = { { 0.2, 0.1, 0 }, { 0.9, 0.3, 0 }, { 0.4, 0.8, 0 } };
  const auto field = Drawn(Square(6), bent);
  field->Update();
  CheckDistances(check, field, DistanceTo(bent), "open");

  field->CurveClosedOn();
  field->Update();
  CheckDistances(check, field, DistanceTo(Closed(bent)), "closed");

  std::vector<Point> moved = bent;
  moved[1] = { 0.7, 0.05, 0 };
  field->SetCurvePoint(1, 0.7, 0.05, 0);
  field->Update();
  CheckDistances(check, field, DistanceTo(Closed(moved)), "closed, a point moved");

  moved.push_back({ 0.1, 0.9, 0 });
  field->SetCurvePoint(3, 0.1, 0.9, 0);
  field->Update();
  CheckDistances(check, field, DistanceTo(Closed(moved)), "closed, a point more");

  field->SetNumberOfCurvePoints(2);
  field->Update();
  CheckDistances(check, field, DistanceTo({ moved[0], moved[1] }), "two points are not closed");

  field->SetNumberOfCurvePoints(1);
  field->Update();
  CheckDistances(check, field, DistanceTo({ moved[0] }), "one point");

  Point p;
  field->GetCurvePoint(0, p.data());
  check.That(p == moved[0] && field->GetNumberOfCurvePoints() == 1, "the point can be asked for");
}

void CheckExecutesWhenTheCurveChanges(Check& check)
{
  const auto field = Drawn(Square(4), { { 0, 0.5, 0 }, { 1, 0.5, 0 } });
  int executions = 0;
  const Listener listener(field, vtkCommand::EndEvent, [&executions]() { ++executions; });
  field->Update();
  Draw(field, { { 0, 0.5, 0 }, { 1, 0.5, 0 } });
  field->SetCurveClosed(false);
  field->Update();
  check.Equal(executions, 1, "setting what is there does nothing");
  field->SetCurvePoint(0, 0, 0.25, 0);
  field->Update();
  check.Equal(executions, 2, "a point");
  field->SetCurveClosed(true);
  field->Update();
  check.Equal(executions, 3, "closed");
}

/// It is put onto the surface, but the user is told.
void CheckFarCurve(Check& check)
{
  const auto field = Drawn(Square(4), { { 0.25, -3, 7 }, { 0.75, 0.5, 2 } });
  Messages(field).ExpectWarning(
    check, { "up to 7.61577 away from the surface" }, "a far curve is told");
  CheckDistances(check, field, DistanceTo({ { 0.25, 0, 0 }, { 0.75, 0.5, 0 } }), "a far curve");
  check.Equal(field->GetSourceSnapDistance(), std::hypot(3.0, 7.0), "how far it was");
}

/// Handles that are dragged beside the surface go onto it without a word.
void CheckCurveBeside(Check& check)
{
  const auto field = Drawn(Square(4), { { 0.25, 0.25, 0 }, { 0.75, 0.5, 0.5 } });
  Messages(field).ExpectNoWarning(check, "a curve beside");
  check.Equal(field->GetSourceSnapDistance(), 0.5, "how far it was beside");
}

/// The length of a source: a drawn curve is a ruler.
void CheckLength(Check& check)
{
  vtkNew<DrawnField> field;
  field->SetInputData(Square(4));
  const auto expect = [&](double length, const std::string& what)
  {
    field->Update();
    check.Near(field->GetSourceLength(), length, 1e-14, what + " has the length");
    check.Equal(field->GetOutput()->GetFieldData()->GetArray("SourceLength")->GetTuple1(0),
      field->GetSourceLength(), "the getter and the array of the length of " + what);
  };
  Draw(field, { { 0.125, 0.25, 0 }, { 0.875, 0.5, 0 } });
  expect(std::hypot(0.75, 0.25), "two points");
  Draw(field, { { 0.125, 0.25, 0 }, { 0.875, 0.25, 0 }, { 0.875, 0.5, 0 } });
  expect(1.0, "three points");
  field->CurveClosedOn();
  expect(1.0 + std::hypot(0.75, 0.25), "a triangle");
  Draw(field, { { 0.125, 0.25, 0 } });
  expect(0.0, "a point");
  field->SetSourceTypeToSurfaceBoundary();
  expect(4.0, "the boundary");

  // Over an edge of a box the way is straight in its unfolding.
  vtkNew<DrawnField> overEdge;
  vtkNew<vtkCubeSource> box;
  overEdge->SetInputConnection(box->GetOutputPort());
  Draw(overEdge, { { -0.25, 0.25, 0.5 }, { 0.5, 0.0, 0.25 } });
  overEdge->Update();
  check.Near(overEdge->GetSourceLength(), std::hypot(1.0, 0.25), 1e-14, "around an edge");
}

/// Landmarks: the points are not joined, and have their numbers as ids.
void CheckPointsOnly(Check& check)
{
  const std::vector<Point> points = { { 0.125, 0.25, 0 }, { 0.875, 0.5, 0 }, { 0.5, 1, 0 } };
  const auto field = Drawn(Square(4), points);
  field->CurveClosedOn();
  field->GenerateSourceIdsOn();
  field->Update();
  field->PointsOnlyOn();
  field->Update();
  CheckDistances(
    check, field,
    [&points](const Point& p)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const Point& point : points)
      {
        least = std::min(least, DistanceTo({ point })(p));
      }
      return least;
    },
    "points only");
  check.Equal(field->GetSourceLength(), 0.0, "points have no length");
  vtkPolyData* marks = field->GetOutput(1);
  vtkDataArray* ids = marks->GetCellData()->GetArray("SourceId");
  check.Equal(marks->GetNumberOfVerts(), 3.0, "three marks");
  for (vtkIdType i = 0; ids && i < marks->GetNumberOfPoints(); ++i)
  {
    const Point p = PointAt(marks, i);
    check.That(
      p == points[static_cast<std::size_t>(ids->GetTuple1(i))], "ids are numbers of points");
  }
  field->PointsOnlyOff();
  field->Update();
  check.That(field->GetSourceLength() > 2.0, "joined again");
}

void CheckWithoutPoints(Check& check)
{
  vtkNew<DrawnField> field;
  field->SetInputData(Square(4));
  Messages messages(field);
  messages.ExpectError(check, { "curve has no points" }, "no points");
  CheckOutputsEmpty(check, field, "a curve without points");

  field->SetSourceTypeToSurfaceBoundary();
  messages.ExpectNoError(check, "the boundary will do");
  CheckDistances(check, field, DistanceToBoundaryOfSquare, "from the boundary");

  Point p = { 1, 1, 1 };
  field->GetCurvePoint(0, p.data());
  check.That(p == Point{ 0, 0, 0 }, "a point that is not there is the origin");
  check.That(Contains(messages.Error(), "no point 0"), "asked for: " + messages.Error());
  field->SetCurvePoint(-1, 0, 0, 0);
  check.That(field->GetNumberOfCurvePoints() == 0, "no point before the first");
  field->SetNumberOfCurvePoints(-2);
  check.That(field->GetNumberOfCurvePoints() == 0, "no fewer points than none");
}

void CheckExchangedExecutive(Check& check)
{
  vtkNew<DrawnField> field;
  const std::vector<Point> line = { { 0.5, 0, 0 }, { 0.5, 1, 0 } };
  Draw(field, line);
  vtkNew<vtkCompositeDataPipeline> executive;
  field->SetExecutive(executive);
  field->SetInputData(Square(4));
  field->Update();
  CheckDistances(check, field, DistanceTo(line), "another executive");
}

}

int TestGeodesicDrawnCurve(int, char*[])
{
  Check check;
  CheckCurves(check);
  CheckExecutesWhenTheCurveChanges(check);
  CheckFarCurve(check);
  CheckCurveBeside(check);
  CheckLength(check);
  CheckPointsOnly(check);
  CheckWithoutPoints(check);
  CheckExchangedExecutive(check);
  return check.Result();
}
