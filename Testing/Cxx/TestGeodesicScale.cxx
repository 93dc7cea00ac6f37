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
  auto scaled = vtkSmartPointer<vtkPolyData>::New();
  scaled->DeepCopy(data);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    points->InsertNextPoint(Scaled(p[0], exponent), Scaled(p[1], exponent), Scaled(p[2], exponent));
  }
  scaled->SetPoints(points);
  return scaled;
}

vtkSmartPointer<vtkPolyData> BumpySphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(15);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  auto bumpy = vtkSmartPointer<vtkPolyData>::New();
  bumpy->DeepCopy(sphere->GetOutput());
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  for (vtkIdType i = 0; i < bumpy->GetNumberOfPoints(); ++i)
  {
    double p[3];
    bumpy->GetPoint(i, p);
    const double factor = 1.0 + 0.2 * random->GetNextValue();
    bumpy->GetPoints()->SetPoint(i, factor * p[0], factor * p[1], factor * p[2]);
  }
  return bumpy;
}

/// Three points beside the surface, some faces apart.
vtkSmartPointer<vtkPolyData> CurveBeside(vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(3);
  for (const vtkIdType i : { 3, 40, 200 })
  {
    double p[3];
    surface->GetPoint(i, p);
    lines->InsertCellPoint(points->InsertNextPoint(1.001 * p[0], 1.001 * p[1], 1.001 * p[2]));
  }
  auto curve = vtkSmartPointer<vtkPolyData>::New();
  curve->SetPoints(points);
  curve->SetLines(lines);
  return curve;
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
  vtkDataArray* distances = filter->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
  for (vtkIdType i = 0; distances && i < distances->GetNumberOfTuples(); ++i)
  {
    lengths.push_back(distances->GetTuple1(i));
  }
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
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Scaled(surface, exponent));
  filter->SetSourceData(Scaled(CurveBeside(surface), exponent));
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
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetInputData(Scaled(surface, exponent));
    filter->SetSourceData(Scaled(CurveBeside(surface), exponent));
    Messages messages(filter);
    messages.Update();
    check.That(Contains(messages.Error(), "between 1e-290 and 1e290"), "a size beyond is an error");
    check.That(filter->GetOutput()->GetNumberOfPoints() == 0, "a size beyond gives no output");
  }
}

void CheckPointsThatNoFaceUses(Check& check)
{
  const auto surface = Scaled(BumpySphere(), -900);
  surface->GetPointData()->Initialize();
  surface->GetPoints()->InsertNextPoint(1.0, 1e300, 0.0);
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(surface);
  filter->SetSourceData(Scaled(CurveBeside(BumpySphere()), -900));
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), "points that no face uses may be anywhere");
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
