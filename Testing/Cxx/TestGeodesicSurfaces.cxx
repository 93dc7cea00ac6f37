// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of every kind that a vtkPolyData can hold: the distance is that of the geometry, and the
// output keeps the input's points and data.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"

using namespace GeodesicTesting;

namespace
{

const std::vector<Point> Line = { { 0.1, 0.2, 0 }, { 0.7, 0.35, 0 }, { 0.65, 0.9, 0 } };

vtkSmartPointer<vtkPolyData> NumberedCells(vtkSmartPointer<vtkPolyData> data)
{
  AddArrayOf<vtkIdTypeArray>(
    data->GetCellData(), "Number", data->GetNumberOfCells(), [&](vtkIdType i) { return 100 + i; });
  return data;
}

/// Runs the filter without refinement.
void Run(
  Messages& messages, vtkGeodesicDistanceField* filter, vtkPolyData* surface, vtkPolyData* source)
{
  filter->RefineMeshOff();
  filter->SetInputData(surface);
  filter->SetSourceData(source);
  messages.Update();
}

void CheckKinds(Check& check)
{
  const std::vector<std::pair<std::string, vtkSmartPointer<vtkPolyData>>> kinds = {
    { "triangles", Square(8) },
    { "quads", Square(8, Cells::Quads) },
    { "strips", Square(8, Cells::Strips) },
    { "32-bit points", Square(8, Cells::Triangles, VTK_FLOAT) },
    { "soup", Soup(Square(8)) },
  };
  for (const auto& [name, surface] : kinds)
  {
    NumberedCells(surface);
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->GenerateSignedDistanceOn(); // needs one orientation
    Messages messages(filter);
    Run(messages, filter, surface, Polyline(Line));
    CheckDistances(check, filter, DistanceTo(Line), name);

    vtkPolyData* output = filter->GetOutput();
    check.That(output->GetPoints() == surface->GetPoints(), name + ": the points are the input's");
    check.Equal(output->GetNumberOfPolys(), 128.0, name + ": triangles");
    check.Equal(output->GetNumberOfCells(), 128.0, name + ": cells");
    check.Equal(output->GetPolys()->GetMaxCellSize(), 3.0, name + ": corners");
  }
}

/// Every triangle's number is that of the input's cell with all its corners.
void CheckCellData(Check& check, const std::string& name, vtkSmartPointer<vtkPolyData> surface)
{
  NumberedCells(surface);
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(messages, filter, surface, Polyline(Line));
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* numbers = output->GetCellData()->GetArray("Number");
  if (!numbers || numbers->GetNumberOfTuples() != output->GetNumberOfCells())
  {
    check.That(false, name + ": a number for each cell");
    return;
  }
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const auto parent = static_cast<vtkIdType>(numbers->GetTuple1(cell)) - 100;
    vtkNew<vtkIdList> outer;
    surface->GetCellPoints(parent, outer);
    for (const vtkIdType id : IdsOf(output->GetPolys(), cell))
    {
      check.That(outer->IsId(id) >= 0, name + ": the number of the cell around");
    }
  }
}

vtkSmartPointer<vtkPolyData> QuadsWithLinesAndStrips()
{
  auto surface = Square(4, Cells::Quads);
  // The last row of squares as a strip, behind lines and vertices.
  auto quads = CellsOf(surface->GetPolys());
  quads.resize(12);
  surface->SetPolys(CellArrayOf(quads));
  surface->SetStrips(CellArray({ { 15, 20, 16, 21, 17, 22, 18, 23, 19, 24 } }));
  surface->SetLines(CellArray({ { 0, 1 } }));
  surface->SetVerts(CellArray({ { 0 }, { 2, 3 } }));
  return surface;
}

/// A square cut out of the plane as one polygon that is far from convex: distances between its arms
/// go around the notch.
void CheckConcavePolygon(Check& check)
{
  const auto surface = Mesh({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 2, 3, 0 }, { 2, 1, 0 },
                              { 1, 1, 0 }, { 1, 3, 0 }, { 0, 3, 0 } },
    { { 0, 1, 2, 3, 4, 5, 6, 7 } });
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(messages, filter, surface, PointSources({ { 1, 3, 0 } }));
  check.That(messages.Error().empty(), "a U as one polygon: " + messages.Error());
  check.Equal(filter->GetOutput()->GetNumberOfPolys(), 6.0, "its triangles");
  const double around = Distances(filter) ? Distances(filter)->GetTuple1(3) : 0.0;
  check.Near(around, 5.0, 1e-14, "the way around the notch of a U");
}

/// The distance from the first point to another, along a path over some points of a polygon.
void CheckPathInPolygon(Check& check, const std::vector<Point>& points,
  const std::vector<vtkIdType>& outline, const std::vector<std::size_t>& path, double scale,
  const std::string& what)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    length += LengthBetween(points[path[i]], points[path[i + 1]]);
  }
  // At sizes far apart.
  const auto surface = Moved(Mesh(points, { outline }), ScaledBy(scale));
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(messages, filter, surface, PointSources({ ScaledBy(scale)(points[path.front()]) }));
  check.That(messages.Error().empty() && !Contains(messages.Warning(), "polygon"),
    what + ": no message: " + messages.Error() + messages.Warning());
  const double distance = Distances(filter)->GetTuple1(static_cast<vtkIdType>(path.back())) / scale;
  check.Near(distance, length, 1e-13 * length,
    what + ": " + std::to_string(distance) + " for " + std::to_string(length));
  check.Equal(filter->GetOutput()->GetNumberOfPolys(), outline.size() - 2, what + ": triangles");
}

void CheckOutlines(Check& check)
{
  const std::vector<Point> square = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 },
    { 1, 1, 0 }, { 3, 1, 0 }, { 3, 3, 0 }, { 1, 3, 0 } };
  const std::vector<Point> concave = { { .59, .12, 0 }, { .18, .08, 0 }, { .64, .27, 0 },
    { -.14, .58, 0 }, { -.34, -.61, 0 } };
  for (const double scale : { 1.0, 1e-6, 1e-7, 1e-30, 1e30 })
  {
    const std::string size = " of size " + std::to_string(scale);
    CheckPathInPolygon(check, square, { 0, 1, 2, 3, 0, 4, 7, 6, 5, 4 }, { 0, 5, 2 }, scale,
      "a square with a hole" + size);
    CheckPathInPolygon(
      check, concave, { 0, 1, 2, 3, 4 }, { 0, 1, 2 }, scale, "a concave pentagon" + size);
    std::vector<Point> thin = concave;
    for (Point& p : thin)
    {
      p = { p[0], 1e-5 * p[1], p[0] };
    }
    CheckPathInPolygon(
      check, thin, { 0, 1, 2, 3, 4 }, { 0, 1, 2 }, scale, "a thin pentagon" + size);
  }
}

void CheckDegenerateQuads(Check& check)
{
  // A quad with a repeated corner is a triangle; one with two is nothing.
  const auto surface = Mesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    { { 0, 1, 2, 2 }, { 0, 0, 2, 3 }, { 0, 0, 1, 1 } });
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(messages, filter, surface, PointSources({ { 1, 0, 0 } }));
  CheckDistances(check, filter, DistanceTo({ { 1, 0, 0 } }), "quads with repeated corners");
  check.Equal(
    filter->GetOutput()->GetNumberOfPolys(), 2.0, "triangles from quads with repeated corners");
  check.That(Contains(messages.Warning(), "1 face with two corners"), "the empty quad is counted");
}

void CheckPolygonsWithoutArea(Check& check)
{
  // A quad folded onto a line conducts along it.
  const auto surface =
    Mesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } }, { { 0, 1, 3, 2 } });
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(messages, filter, surface, PointSources({ { 0, 0, 0 } }));
  check.That(messages.Error().empty(), "a quad without area: " + messages.Error());
  CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "a quad without area");
}

void CheckMerging(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->MergeCoincidentPointsOff();
  Messages messages(filter);
  Run(messages, filter, Soup(Square(4)), PointSources({ { 0, 0, 0 } }));
  vtkIdType reached = 0;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    reached += std::isfinite(Distances(filter)->GetTuple1(i)) ? 1 : 0;
  }
  check.Equal(reached, 3.0, "points reached in soup that is not merged");

  filter->MergeCoincidentPointsOn();
  messages.Update();
  CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "soup merged");

  // Minus zero is zero, and on the boundary the next number is the same place, too.
  auto surface = Soup(Square(1));
  vtkPoints* points = surface->GetPoints();
  for (vtkIdType i = 3; i < 6; ++i)
  {
    const Point p = PointAt(points, i);
    points->SetPoint(i, p[0] == 0.0 ? -0.0 : p[0], p[1] == 0.0 ? -0.0 : p[1], -0.0);
  }
  filter->SetInputData(surface);
  messages.Update();
  CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "soup with -0");
  for (vtkIdType i = 3; i < 6; ++i)
  {
    const Point p = PointAt(points, i);
    points->SetPoint(i, p[0], p[1], 5e-324);
  }
  points->Modified();
  surface->Modified();
  messages.Update();
  CheckDistances(
    check, filter, DistanceTo({ { 0, 0, 0 } }), "soup with points that differ in the last bit");
}

/// As many triangles as cells, though they are not the cells.
void CheckStripBesideVertex(Check& check)
{
  auto surface = Square(1, Cells::Strips);
  surface->SetVerts(CellArray({ { 0 } }));
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(messages, filter, NumberedCells(surface), PointSources({ { 0, 0, 0 } }));
  vtkPolyData* output = filter->GetOutput();
  check.Equal(output->GetNumberOfPolys(), 2.0, "triangles of a strip");
  vtkDataArray* numbers = output->GetCellData()->GetArray("Number");
  check.That(numbers && numbers->GetNumberOfTuples() == 2 && numbers->GetTuple1(0) == 101.0 &&
      numbers->GetTuple1(1) == 101.0,
    "both have the number of the strip");
}

}

int TestGeodesicSurfaces(int, char*[])
{
  Check check;
  CheckKinds(check);
  CheckCellData(check, "triangles", Square(4));
  CheckCellData(check, "quads", Square(4, Cells::Quads));
  CheckCellData(check, "strips", Square(4, Cells::Strips));
  CheckCellData(check, "cells of all kinds", QuadsWithLinesAndStrips());
  CheckConcavePolygon(check);
  CheckOutlines(check);
  CheckDegenerateQuads(check);
  CheckPolygonsWithoutArea(check);
  CheckMerging(check);
  CheckStripBesideVertex(check);
  return check.Result();
}
