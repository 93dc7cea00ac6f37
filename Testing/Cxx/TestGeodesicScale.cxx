// SPDX-License-Identifier: BSD-3-Clause
// Scaled by a power of two, a surface gives the same digits, also where squares of its coordinates
// leave the range of numbers; where distances cannot be told, there is an error.
#include "GeodesicTesting.h"

#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkMinimalStandardRandomSequence.h"

#include <cmath>
#include <limits>
#include <vector>

using namespace GeodesicTesting;

namespace
{

double Scaled(double x, int exponent)
{
  return std::ldexp(x, exponent);
}

vtkSmartPointer<vtkPolyData> Scaled(vtkPolyData* data, int exponent)
{
  auto scaled = CopyOf(data);
  std::vector<Point> points = PlacesOf(data);
  for (Point& p : points)
  {
    p = { Scaled(p[0], exponent), Scaled(p[1], exponent), Scaled(p[2], exponent) };
  }
  scaled->SetPoints(PointSources(points)->GetPoints());
  return scaled;
}

vtkSmartPointer<vtkPolyData> BumpySphere()
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  auto bumpy = ChangedSphere(
    20, 15, [&](const Point& p) { return ScaledBy(1.0 + 0.2 * random->GetNextValue())(p); });
  return bumpy;
}

/// Three points beside the surface, some faces apart.
vtkSmartPointer<vtkPolyData> CurveBeside(vtkPolyData* surface)
{
  return Moved(Polyline(PlacesOf(surface, { 3, 40, 200 })), ScaledBy(1.001));
}

/// All numbers of an output; those that are lengths are scaled back.
std::vector<double> NumbersOfOutput(vtkDataObject* output, int exponent)
{
  std::vector<double> numbers;
  const auto add = [&](vtkDataArray* array, bool areLengths)
  {
    for (const double number : NumbersOf(array))
    {
      numbers.push_back(areLengths ? Scaled(number, -exponent) : number);
    }
  };
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
  {
    vtkFieldData* arrays = output->GetAttributesAsFieldData(kind);
    for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
    {
      const std::string name = arrays->GetArray(i)->GetName();
      const bool hasNoUnit = Contains(name, "Id") || Contains(name, "Angle") ||
        Contains(name, "Gradient") || Contains(name, "Normal");
      add(arrays->GetArray(i), !hasNoUnit);
    }
  }
  if (auto* surface = vtkPolyData::SafeDownCast(output))
  {
    add(surface->GetPoints()->GetData(), true);
  }
  return numbers;
}

/// How the filter is set, for a surface scaled by 2^exponent.
using Setting = std::function<void(vtkGeodesicDistanceField*, int exponent)>;

std::vector<double> Run(int exponent, const Setting& set)
{
  const auto surface = BumpySphere();
  const auto filter =
    RefinedField(Scaled(surface, exponent), Scaled(CurveBeside(surface), exponent));
  set(filter, exponent);
  filter->GenerateSourceIdsOn();
  filter->Update();
  std::vector<double> numbers = { Scaled(filter->GetSourceSnapDistance(), -exponent),
    Scaled(filter->GetInterpolationErrorBound(), -exponent) };
  for (int port = 0; port < 2; ++port)
  {
    const std::vector<double> more = NumbersOfOutput(filter->GetOutputDataObject(port), exponent);
    numbers.insert(numbers.end(), more.begin(), more.end());
  }
  return numbers;
}

/// Lines, paths or a table.
std::vector<double> RunOther(int exponent, const vtkSmartPointer<vtkGeodesicAlgorithm>& filter)
{
  const auto surface = BumpySphere();
  filter->SetInputDataObject(0, Scaled(surface, exponent));
  filter->SetSourceData(Scaled(CurveBeside(surface), exponent));
  if (filter->GetNumberOfInputPorts() > 2)
  {
    filter->SetInputDataObject(2, Scaled(PointSources(PlacesOf(surface, { 77, 250 })), exponent));
  }
  filter->Update();
  return NumbersOfOutput(filter->GetOutputDataObject(0), exponent);
}

const std::vector<int> AllExponents = { -960, -700, -150, -110, -98, 98, 110, 150, 700, 960 };

void CheckEveryDigitStays(
  Check& check, const char* name, const std::function<std::vector<double>(int)>& run)
{
  const std::vector<double> numbers = run(0);
  check.That(!numbers.empty(), std::string(name) + ": there are numbers");
  for (const int exponent : AllExponents)
  {
    check.That(run(exponent) == numbers,
      std::string(name) + ": every digit stays at 2^" + std::to_string(exponent));
  }
}

void CheckFields(Check& check)
{
  const auto expect = [&](const char* name, const Setting& set)
  { CheckEveryDigitStays(check, name, [&](int exponent) { return Run(exponent, set); }); };
  expect("refined", [](vtkGeodesicDistanceField*, int) {});
  expect("approximate",
    [](vtkGeodesicDistanceField* filter, int) { filter->SetAccuracyToApproximate(); });
  expect("with a limit",
    [](vtkGeodesicDistanceField* filter, int exponent)
    { filter->SetMaximumDistance(Scaled(0.5, exponent)); });
  expect("with an absolute tolerance",
    [](vtkGeodesicDistanceField* filter, int exponent)
    {
      filter->ToleranceIsAbsoluteOn();
      filter->SetAbsoluteRefinementTolerance(Scaled(0.002, exponent));
    });
  expect("with coordinates",
    [](vtkGeodesicDistanceField* filter, int)
    {
      filter->GenerateGradientsOn();
      filter->GenerateSourceArcLengthOn();
      filter->GenerateSourceAngleOn();
    });
}

void CheckOtherFilters(Check& check)
{
  CheckEveryDigitStays(check, "lines",
    [](int exponent)
    {
      vtkNew<vtkGeodesicContour> contour;
      contour->SetValue(0, Scaled(0.3, exponent));
      return RunOther(exponent, contour.Get());
    });
  CheckEveryDigitStays(check, "paths",
    [](int exponent)
    {
      vtkNew<vtkGeodesicPaths> paths;
      paths->GenerateSourceArcLengthOn();
      paths->GenerateSourceAngleOn();
      return RunOther(exponent, paths.Get());
    });
  CheckEveryDigitStays(check, "a table",
    [](int exponent)
    {
      vtkNew<vtkGeodesicDistanceMatrix> matrix;
      matrix->SetMaximumDistance(Scaled(1.0, exponent));
      return RunOther(exponent, matrix.Get());
    });
}

void CheckSizesBeyond(Check& check)
{
  const auto surface = BumpySphere();
  for (const int exponent : { -980, 980 })
  {
    const auto filter =
      RefinedField(Scaled(surface, exponent), Scaled(CurveBeside(surface), exponent));
    Messages(filter).ExpectError(
      check, { "between 1e-290 and 1e290" }, "a size beyond is an error");
    check.That(filter->GetOutput()->GetNumberOfPoints() == 0, "a size beyond gives no output");
  }
}

void CheckPointsThatNoFaceUses(Check& check)
{
  const auto surface = Scaled(BumpySphere(), -900);
  surface->GetPointData()->Initialize();
  surface->GetPoints()->InsertNextPoint(1.0, 1e300, 0.0);
  const auto filter = RefinedField(surface, Scaled(CurveBeside(BumpySphere()), -900));
  RunWithoutError(check, filter, "points that no face uses may be anywhere");
  check.That(filter->GetOutput()->GetNumberOfPoints() > 0, "and the others have a field");
}

}

int TestGeodesicScale(int, char*[])
{
  Check check;
  CheckFields(check);
  CheckOtherFilters(check);
  CheckSizesBeyond(check);
  CheckPointsThatNoFaceUses(check);
  return check.Result();
}
