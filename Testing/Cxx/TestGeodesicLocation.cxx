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

/// To the nearest point inside the face where the foot of the perpendicular is inside, else to its
/// sides.
double DistanceToFace(const Point& p, const Point& a, const Point& b, const Point& c)
{
  double least = std::min(
    { DistanceToSegment(p, a, b), DistanceToSegment(p, b, c), DistanceToSegment(p, c, a) });
  const Point u = Minus(b, a);
  const Point v = Minus(c, a);
  const Point w = Minus(p, a);
  const Point normal = Cross(u, v);
  const double area = std::sqrt(Dot(normal, normal));
  if (area == 0.0)
  {
    return least;
  }
  const double s = Dot(Cross(w, v), normal) / (area * area);
  const double t = Dot(Cross(u, w), normal) / (area * area);
  if (s >= 0.0 && t >= 0.0 && s + t <= 1.0)
  {
    least = std::min(least, std::abs(Dot(w, normal)) / area);
  }
  return least;
}

double DistanceToSurface(const Point& p, vtkPolyData* surface)
{
  double least = VTK_DOUBLE_MAX;
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    const std::vector<Point> corners = CornersOf(surface, face);
    least = std::min(least, DistanceToFace(p, corners[0], corners[1], corners[2]));
  }
  return least;
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
  auto triangles = CellsOf(surface->GetPolys());
  std::shuffle(triangles.begin(), triangles.end(), std::mt19937(8));
  surface->SetPolys(CellArrayOf(triangles));

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
    filter->SetSourceData(PointSources({ p }));
    messages.Update();
    check.Near(filter->GetSourceSnapDistance(), LengthBetween(p, inside), 1e-14,
      "many parts: point " + std::to_string(i) + " is put onto the surface from");
  }
}

void CheckSurface(
  Check& check, const std::string& name, vtkSmartPointer<vtkPolyData> surface, double scale)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.5, 2.5);
  MovePoints(surface, ScaledBy(scale));
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
    check.That(messages.Error().empty(), name + ": " + messages.Error());
    check.Near(filter->GetSourceSnapDistance(), expected, rounding,
      name + ": point " + std::to_string(i) + " is put onto the surface from");
  }
}

}

int TestGeodesicLocation(int, char*[])
{
  Check check;
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    const std::string at = " at scale " + std::to_string(scale);
    CheckSurface(
      check, "a sphere" + at, ChangedSphere(12, 9, [](const Point& p) { return p; }), scale);
    CheckSurface(check, "a flat square" + at, Square(8), scale);
    CheckSurface(check, "a square with a tail" + at, SquareWithTail(), scale);
    CheckSurface(check, "a square with a whisker" + at, SquareWithWhisker(), scale);
  }
  CheckManyParts(check);
  return check.Result();
}
