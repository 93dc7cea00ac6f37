// SPDX-License-Identifier: BSD-3-Clause
// A source point is put onto the closest point of the surface: the snap distance is the least over
// all faces, whatever the surface's scale and shape.
#include "GeodesicTesting.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <numeric>
#include <random>

using namespace GeodesicTesting;

namespace
{

Point Corner(vtkPolyData* surface, vtkIdType face, vtkIdType k)
{
  vtkNew<vtkIdList> ids;
  surface->GetPolys()->GetCellAtId(face, ids);
  Point p;
  surface->GetPoint(ids->GetId(k), p.data());
  return p;
}

/// To the nearest point inside the face where the foot of the perpendicular is inside, else to its
/// sides.
double DistanceToFace(const Point& p, const Point& a, const Point& b, const Point& c)
{
  double least = std::min(
    { DistanceToSegment(p, a, b), DistanceToSegment(p, b, c), DistanceToSegment(p, c, a) });
  Point u, v, w, normal, across;
  for (std::size_t k = 0; k < 3; ++k)
  {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    w[k] = p[k] - a[k];
  }
  vtkMath::Cross(u.data(), v.data(), normal.data());
  const double area = vtkMath::Norm(normal.data());
  if (area == 0.0)
  {
    return least;
  }
  vtkMath::Cross(w.data(), v.data(), across.data());
  const double s = vtkMath::Dot(across.data(), normal.data()) / (area * area);
  vtkMath::Cross(u.data(), w.data(), across.data());
  const double t = vtkMath::Dot(across.data(), normal.data()) / (area * area);
  if (s >= 0.0 && t >= 0.0 && s + t <= 1.0)
  {
    least = std::min(least, std::abs(vtkMath::Dot(w.data(), normal.data())) / area);
  }
  return least;
}

double DistanceToSurface(const Point& p, vtkPolyData* surface)
{
  double least = VTK_DOUBLE_MAX;
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    least = std::min(least,
      DistanceToFace(
        p, Corner(surface, face, 0), Corner(surface, face, 1), Corner(surface, face, 2)));
  }
  return least;
}

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(12);
  sphere->SetPhiResolution(9);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  return sphere->GetOutput();
}

/// Most of the surface in a corner of its bounding box.
vtkSmartPointer<vtkPolyData> SquareWithTail()
{
  auto surface = Square(8);
  const vtkIdType tip = surface->GetPoints()->InsertNextPoint(1e5, 1e5, 1e4);
  surface->GetPolys()->InsertNextCell({ 79, 80, tip });
  return surface;
}

/// The only way to the points at x > 1 is a face without area.
vtkSmartPointer<vtkPolyData> SquareWithWhisker()
{
  auto surface = Square(2);
  vtkPoints* points = surface->GetPoints();
  const vtkIdType middle = points->InsertNextPoint(1.5, 0.0, 0.0);
  const vtkIdType end = points->InsertNextPoint(2.0, 0.0, 0.0);
  surface->GetPolys()->InsertNextCell({ 2, middle, end });
  return surface;
}

/// A square of 200 thousand triangles in an order without order, so that the locator has parts all
/// over it; its snap distance is known.
void CheckManyParts(Check& check)
{
  auto surface = Square(320);
  const vtkIdType count = surface->GetNumberOfPolys();
  std::vector<vtkIdType> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(8));
  vtkNew<vtkCellArray> shuffled;
  vtkNew<vtkIdList> ids;
  for (const vtkIdType face : order)
  {
    surface->GetPolys()->GetCellAtId(face, ids);
    shuffled->InsertNextCell(ids);
  }
  surface->SetPolys(shuffled);

  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetMaximumDistance(1e-3);
  filter->SetInputData(surface);
  Messages messages(filter);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> coordinate(-1.5, 2.5);
  for (int i = 0; i < 20; ++i)
  {
    const Point p = { coordinate(random), coordinate(random), (i % 2) * coordinate(random) };
    const Point inside = { std::min(std::max(p[0], 0.0), 1.0), std::min(std::max(p[1], 0.0), 1.0),
      0.0 };
    const double expected = std::sqrt(vtkMath::Distance2BetweenPoints(p.data(), inside.data()));
    filter->SetSourceData(PointSources({ p }));
    messages.Update();
    check.That(std::abs(filter->GetSourceSnapDistance() - expected) <= 1e-14,
      "many parts: point " + std::to_string(i) + " is put " +
        std::to_string(filter->GetSourceSnapDistance()) + " away instead of " +
        std::to_string(expected));
  }
}

void CheckSurface(
  Check& check, const std::string& name, vtkSmartPointer<vtkPolyData> surface, double scale)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.5, 2.5);
  MovePoints(surface,
    [&](const Point& p) {
      return Point{ scale * p[0], scale * p[1], scale * p[2] };
    });
  surface->GetPoints()->Modified();
  const double rounding = 1e-15 * surface->GetLength();
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetInputData(surface);
  Messages messages(filter);
  for (int i = 0; i < 100; ++i)
  {
    const Point p = { scale * coordinate(random), scale * coordinate(random),
      (i % 4 == 0 ? 0.0 : scale) * coordinate(random) };
    filter->SetSourceData(PointSources({ p }));
    messages.Update();
    const double expected = DistanceToSurface(p, surface);
    const double error = std::abs(filter->GetSourceSnapDistance() - expected);
    check.That(messages.Error().empty(), name + ": " + messages.Error());
    check.That(error <= rounding,
      name + ": point " + std::to_string(i) + " is put " +
        std::to_string(filter->GetSourceSnapDistance() / scale) + " away instead of " +
        std::to_string(expected / scale));
  }
}

}

int TestGeodesicLocation(int, char*[])
{
  Check check;
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    const std::string at = " at scale " + std::to_string(scale);
    CheckSurface(check, "a sphere" + at, Sphere(), scale);
    CheckSurface(check, "a flat square" + at, Square(8), scale);
    CheckSurface(check, "a square with a tail" + at, SquareWithTail(), scale);
    CheckSurface(check, "a square with a whisker" + at, SquareWithWhisker(), scale);
  }
  CheckManyParts(check);
  return check.Result();
}
