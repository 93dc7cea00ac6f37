// SPDX-License-Identifier: BSD-3-Clause
// What cannot be computed gives an error that says what is wrong, where and what to do; both
// outputs stay empty and the inputs untouched.
#include "GeodesicTesting.h"

#include "vtkMath.h"

#include <stdexcept>
#include <utility>

using namespace GeodesicTesting;

namespace
{

vtkSmartPointer<vtkPolyData> WithPoint(vtkSmartPointer<vtkPolyData> data, vtkIdType id, double x)
{
  data->GetPoints()->SetPoint(id, x, 0.0, 0.0);
  return data;
}

vtkSmartPointer<vtkPolyData> WithFace(vtkSmartPointer<vtkPolyData> data, vtkIdType badId)
{
  data->GetPolys()->InsertNextCell({ 0, 1, badId });
  return data;
}

vtkSmartPointer<vtkPolyData> WithLine(vtkSmartPointer<vtkPolyData> data, vtkIdType badId)
{
  data->SetLines(CellArray({ { 0, badId } }));
  return data;
}

std::vector<Case> Cases()
{
  const double nan = vtkMath::Nan();
  const double inf = vtkMath::Inf();
  const int boundary = vtkGeodesicDistanceField::SURFACE_BOUNDARY;
  const int both = vtkGeodesicDistanceField::CURVE_AND_BOUNDARY;
  const auto corner = PointSources({ { 0, 0, 0 } });
  const auto nothing = vtkSmartPointer<vtkPolyData>::New();
  const auto degenerate = Mesh({ { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 0, 1 } });
  auto twoSquares = Square(2);
  Append(twoSquares, Moved(Square(2), MovedBy(3.0)));
  auto emptyLine = PointSources({ { 0, 0, 0 } });
  emptyLine->SetLines(CellArray({ {} }));

  return {
    { "an empty surface", nothing, corner, { "port 0", "no faces", "Connect" } },
    { "a surface whose only face is a,a,b", degenerate, corner,
      { "port 0", "three different corners" } },
    { "a face that names a missing point", WithFace(Square(2), 99), corner,
      { "port 0", "Cell 8", "point 99", "9 points" } },
    { "a face that names a negative point", WithFace(Square(2), -1), corner,
      { "port 0", "Cell 8", "point -1" } },
    { "a NaN on the surface", WithPoint(Square(2), 4, nan), corner,
      { "port 0", "NaN", "point 4", "Remove" } },
    { "an infinite coordinate on the surface", WithPoint(Square(2), 7, -inf), corner,
      { "port 0", "infinite", "point 7" } },
    { "no source", Square(2), nullptr, { "no source", "choose a Source", "Surface Boundary" } },
    { "a closed surface and only its boundary", Tetrahedron(), nullptr,
      { "port 0", "closed", "no boundary", "Source Curve" }, boundary },
    { "a closed surface, its boundary and no curve", Tetrahedron(), nullptr,
      { "port 0", "closed", "choose a Source" }, both },
    { "an empty curve", Square(2), nothing, { "port 1", "empty", "Connect" } },
    { "an empty curve beside the boundary", Square(2), nothing, { "port 1", "empty" }, both },
    { "a curve of a line without points", Square(2), emptyLine, { "port 1", "empty" } },
    { "a NaN on the curve", Square(2), WithPoint(Polyline({ { 0, 0, 0 }, { 1, 0, 0 } }), 1, nan),
      { "port 1", "NaN", "point 1", "Remove" } },
    { "an infinite coordinate on the curve", Square(2),
      WithPoint(Polyline({ { 0, 0, 0 }, { 1, 0, 0 } }), 0, inf),
      { "port 1", "infinite", "point 0" } },
    { "a curve that names a missing point", Square(2), WithLine(PointSources({ { 0, 0, 0 } }), 5),
      { "port 1", "Cell 0", "point 5" } },
    { "a curve between two components", twoSquares, Polyline({ { 0.5, 0.5, 0 }, { 3.5, 0.5, 0 } }),
      { "component", "cell 0 of the source" } },
  };
}

void CheckCase(Check& check, const Case& bad)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(check, filter, messages, bad);
  check.That(!messages.Error().empty(), bad.Name + " gives an error");
  CheckWords(check, bad, messages.Error());
  CheckOutputsEmpty(check, filter, bad.Name);

  // The same filter works again once the input is right.
  filter->SetInputData(Square(4));
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  filter->SetSourceType(vtkGeodesicDistanceField::SOURCE_CURVE);
  messages.ExpectNoError(check, "no error after " + bad.Name);
  CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "after " + bad.Name);
}

void CheckNoSurface(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  messages.Update();
  check.That(Contains(messages.ExecutiveError(), "Input port 0") &&
      Contains(messages.ExecutiveError(), "vtkGeodesicDistanceField"),
    "no surface: the error names the port and the filter");
}

void CheckEmptyName(Check& check)
{
  const auto filter = RefinedField(Square(2), PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  for (const char* name : { "", static_cast<const char*>(nullptr) })
  {
    filter->SetDistanceArrayName(name);
    filter->Modified();
    messages.ExpectError(check, { "DistanceArrayName is empty" }, "an empty array name");
    check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0.0,
      "points of the output with an empty array name");
  }
}

/// Only what is used can be wrong.
void CheckWrongNumbers(Check& check)
{
  const auto filter = RefinedField(Square(2), PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  const auto expect = [&](const std::string& words, const std::string& what)
  {
    messages.Update();
    check.That(words.empty() == messages.Error().empty() && Contains(messages.Error(), words),
      what + ": " + messages.Error());
    check.That((filter->GetOutput()->GetNumberOfPoints() == 0) == !words.empty(),
      what + ": the output is empty after an error, and only then");
  };
  for (const double wrong : { 0.0, -0.001, vtkMath::Nan(), vtkMath::Inf() })
  {
    const std::string value = " of " + std::to_string(wrong);
    filter->SetRefinementTolerance(wrong);
    expect("RefinementTolerance is not a positive number", "a tolerance" + value);
    filter->RefineMeshOff();
    expect("", "an unused tolerance" + value);
    filter->RefineMeshOn();
    filter->ToleranceIsAbsoluteOn();
    expect("", "a relative tolerance" + value + " where the absolute is used");
    filter->SetAbsoluteRefinementTolerance(wrong);
    expect("AbsoluteRefinementTolerance is not a positive number", "an absolute tolerance" + value);
    filter->ToleranceIsAbsoluteOff();
    filter->SetRefinementTolerance(0.001);
    expect("", "an unused absolute tolerance" + value);
    filter->SetAbsoluteRefinementTolerance(1.0);
  }
  for (const double wrong : { -1e-9, vtkMath::Nan(), vtkMath::Inf() })
  {
    const std::string value = " of " + std::to_string(wrong);
    filter->SetRelativeError(wrong);
    expect("", "an unused relative error" + value);
    filter->SetAccuracyToApproximate();
    expect("RelativeError is not a finite number", "a relative error" + value);
    filter->SetAccuracyToExact();
  }
  for (const double wrong : { -1e-9, -vtkMath::Inf(), vtkMath::Nan() })
  {
    filter->SetMaximumDistance(wrong);
    expect("MaximumDistance is not a number of at least 0",
      "a maximum distance of " + std::to_string(wrong));
  }
  filter->SetMaximumDistance(vtkMath::Inf());
  expect("", "an infinite maximum distance");
  filter->SetMaximumDistance(0.0);
  filter->SetMaximumNumberOfCells(-1);
  expect("MaximumNumberOfCells is negative", "a negative number of cells");
  filter->RefineMeshOff();
  expect("", "a negative number of cells that is not used");
}

/// Whatever an execution throws is an error of the filter; the next execution is right.
void CheckForeignExceptions(Check& check)
{
  const auto filter = RefinedField(Square(8), PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  int kind = 0;
  Listener listener(filter, vtkCommand::ProgressEvent,
    [&]
    {
      const int thrown = filter->GetProgress() > 0.5 ? std::exchange(kind, 0) : 0;
      if (thrown == 1)
      {
        throw std::runtime_error("of an observer");
      }
      if (thrown == 2)
      {
        throw thrown;
      }
    });
  for (const int which : { 1, 2 })
  {
    const std::string name = which == 1 ? "an exception of an observer" : "a number thrown";
    kind = which;
    filter->Modified();
    try
    {
      messages.Update();
    }
    catch (...)
    {
      check.That(false, name + " crosses the pipeline");
    }
    check.That(Contains(messages.Error(), "not foreseen"), name + ": " + messages.Error());
    check.That(which == 2 || Contains(messages.Error(), "of an observer"), name + ": what it says");
    CheckOutputsEmpty(check, filter, name);
    filter->Modified();
    messages.ExpectNoError(check, "no error after " + name);
    CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "after " + name);
  }
}

void CheckManyBadPointsAreCounted(Check& check)
{
  auto surface = Square(4);
  for (vtkIdType id = 0; id < 9; ++id)
  {
    WithPoint(surface, 2 * id, vtkMath::Nan());
  }
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(surface);
  filter->SetSourceType(vtkGeodesicDistanceField::SURFACE_BOUNDARY);
  Messages(filter).ExpectError(check, { "point 0, 2, 4, 6, 8 and 4 more" },
    "many NaN points: the first are named, the others counted");
}

}

int TestGeodesicBadInput(int, char*[])
{
  Check check;
  for (const Case& bad : Cases())
  {
    CheckCase(check, bad);
  }
  CheckNoSurface(check);
  CheckEmptyName(check);
  CheckWrongNumbers(check);
  CheckForeignExceptions(check);
  CheckManyBadPointsAreCounted(check);
  return check.Result();
}
