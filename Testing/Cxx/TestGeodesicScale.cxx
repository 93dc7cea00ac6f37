// SPDX-License-Identifier: BSD-3-Clause
// Scaled by a power of two, a surface gives the same digits, also where squares of its coordinates
// leave the range of numbers; where distances cannot be told, there is an error.
#include "GeodesicTesting.h"

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

/// All numbers of an execution that are lengths, scaled back.
std::vector<double> Lengths(vtkGeodesicDistanceField* filter, int exponent)
{
  std::vector<double> lengths = { filter->GetSourceSnapDistance(),
    filter->GetInterpolationErrorBound() };
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* output = filter->GetOutput(port);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double* p = output->GetPoint(i);
      lengths.insert(lengths.end(), p, p + 3);
    }
  }
  const std::vector<double> distances = NumbersOf(Distances(filter));
  lengths.insert(lengths.end(), distances.begin(), distances.end());
  for (double& length : lengths)
  {
    length = Scaled(length, -exponent);
  }
  return lengths;
}

/// How the filter is set, for a surface scaled by 2^exponent.
using Setting = std::function<void(vtkGeodesicDistanceField*, int exponent)>;

std::vector<double> Run(int exponent, const Setting& set)
{
  const auto surface = BumpySphere();
  const auto filter =
    RefinedField(Scaled(surface, exponent), Scaled(CurveBeside(surface), exponent));
  set(filter, exponent);
  filter->Update();
  return Lengths(filter, exponent);
}

void CheckEveryDigitStays(Check& check, const char* name, const Setting& set)
{
  const std::vector<double> lengths = Run(0, set);
  check.That(lengths.size() > 1000, std::string(name) + ": there is a field");
  for (const int exponent : { -960, -700, -150, -110, -98, 98, 110, 150, 700, 960 })
  {
    check.That(Run(exponent, set) == lengths,
      std::string(name) + ": every digit stays at 2^" + std::to_string(exponent));
  }
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
  CheckEveryDigitStays(check, "refined", [](vtkGeodesicDistanceField*, int) {});
  CheckEveryDigitStays(check, "approximate",
    [](vtkGeodesicDistanceField* filter, int) { filter->SetAccuracyToApproximate(); });
  CheckEveryDigitStays(check, "with a limit",
    [](vtkGeodesicDistanceField* filter, int exponent)
    { filter->SetMaximumDistance(Scaled(0.5, exponent)); });
  CheckEveryDigitStays(check, "with an absolute tolerance",
    [](vtkGeodesicDistanceField* filter, int exponent)
    {
      filter->ToleranceIsAbsoluteOn();
      filter->SetAbsoluteRefinementTolerance(Scaled(0.002, exponent));
    });
  CheckSizesBeyond(check);
  CheckPointsThatNoFaceUses(check);
  return check.Result();
}
