// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with barriers is told: the array, and sources that lie in one.
#include "BarrierTesting.h"

#include "vtkDoubleArray.h"
#include "vtkStringArray.h"

#include <limits>

using namespace GeodesicTesting;

namespace
{

/// The middle of the unit square is a barrier.
bool IsInside(const Point& p)
{
  return p[0] > 0.25 && p[0] < 0.75 && p[1] > 0.25 && p[1] < 0.75;
}

vtkSmartPointer<vtkPolyData> Surface()
{
  return WithBarriers(Square(8), IsInside);
}

template <typename Array>
vtkSmartPointer<vtkPolyData> WithArray(int components, vtkIdType tuples)
{
  auto surface = Square(8);
  vtkNew<Array> array;
  array->SetName("barrier");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  surface->GetCellData()->AddArray(array);
  return surface;
}

vtkSmartPointer<vtkPolyData> WithValues(double value, vtkIdType first, vtkIdType last)
{
  auto surface = WithArray<vtkDoubleArray>(1, 128);
  vtkDataArray* values = surface->GetCellData()->GetArray("barrier");
  values->Fill(0.0);
  for (vtkIdType cell = first; cell < last; ++cell)
  {
    values->SetTuple1(cell, value);
  }
  return surface;
}

/// With a line, which has no value.
vtkSmartPointer<vtkPolyData> WithLine(vtkSmartPointer<vtkPolyData> surface)
{
  surface->SetLines(CellArray({ { 0, 1 } }));
  return surface;
}

void CheckErrors(Check& check, const std::vector<Case>& cases)
{
  for (const Case& odd : cases)
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetBarrierArrayName("barrier");
    Messages messages(filter);
    Run(check, filter, messages, odd);
    CheckWords(check, odd, messages.Error());
    CheckOutputsEmpty(check, filter, odd.Name);
  }
}

void CheckArrays(Check& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto source = PointSources({ { 0, 0, 0 } });
  CheckErrors(check,
    {
      { "a missing array", Square(8), source,
        { "no cell array named barrier", "BarrierArrayName" } },
      { "several components", WithArray<vtkDoubleArray>(3, 128), source,
        { "barrier", "3 components", "the surface (input port 0)" } },
      { "strings", WithArray<vtkStringArray>(1, 128), source, { "barrier", "vtkStringArray" } },
      { "too few values", WithArray<vtkDoubleArray>(1, 100), source,
        { "100 values for 128 cells" } },
      { "too many values", WithArray<vtkDoubleArray>(1, 129), source,
        { "129 values for 128 cells. Give each cell a value" } },
      { "neither for cells nor for faces", WithLine(WithArray<vtkDoubleArray>(1, 127)), source,
        { "127 values for 129 cells, 128 of which are faces. Give each cell, or each face" } },
      { "NaN at a face", WithLine(WithValues(nan, 17, 18)), source, { "NaN at cell 18," } },
      { "NaN", WithValues(nan, 17, 19), source, { "barrier", "NaN at cell 17, 18" } },
      { "barriers everywhere", WithValues(1.0, 0, 128), source,
        { "All faces of the surface", "barrier" } },
      { "no faces", vtkSmartPointer<vtkPolyData>::New(), source, { "has no faces" } },
    });
}

/// The array of the points does not count.
void CheckPointArray(Check& check)
{
  auto surface = Square(8);
  vtkNew<vtkDoubleArray> array;
  array->SetName("barrier");
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  array->Fill(0.0);
  surface->GetPointData()->AddArray(array);
  CheckErrors(check,
    { { "an array of points", surface, PointSources({ { 0, 0, 0 } }),
      { "no cell array named" } } });
}

void CheckSources(Check& check)
{
  const int boundary = vtkGeodesicDistanceField::SURFACE_BOUNDARY;
  auto polylines = Polyline({ { 0.1, 0.1, 0 }, { 0.2, 0.1, 0 } });
  polylines->GetPoints()->InsertNextPoint(0.1, 0.2, 0);
  polylines->GetPoints()->InsertNextPoint(0.2, 0.2, 0);
  polylines->GetPoints()->InsertNextPoint(0.3, 0.27, 0.01);
  polylines->GetLines()->InsertNextCell({ 2, 3, 4 });
  // Cells are numbered by rows of 16; (0.5, 0.5) is a corner of cells of the fourth row and the
  // fifth, (0.3, 0.27) is in the third square of the third row, below its diagonal.
  CheckErrors(check,
    {
      { "a vertex in a barrier", Surface(), PointSources({ { 0, 0, 0 }, { 0.5, 0.5, 0 } }),
        { "Point 1 of the source (input port 1), at", "(0.5, 0.5, 0)", "lies in a barrier", "cell ",
          "of the surface (input port 0)" } },
      { "a point in a face of a barrier", Surface(), polylines,
        { "Point 2 of cell 1 of the source (input port 1)", "(0.3, 0.27, 0.01)", "cell 36 of" } },
      { "a boundary that barriers have",
        WithBarriers(Square(8),
          [](const Point& p)
          { return p[0] < 0.125 || p[0] > 0.875 || p[1] < 0.125 || p[1] > 0.875; }),
        nullptr, { "The whole boundary", "barriers", "Source Type" }, boundary },
      { "a closed surface", WithBarriers(Tetrahedron(), [](const Point& p) { return p[2] == 0; }),
        nullptr, { "is closed" }, boundary },
    });
}

/// On the rim, within rounding of it, and above it.
void CheckRim(Check& check)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const double rounding = type == VTK_FLOAT ? 1e-8 : 1e-17;
    const auto filter = PlainField(WithBarriers(Square(8, Cells::Triangles, type), IsInside),
      PointSources({ { 0.25, 0.25, 0 }, { 0.25 + rounding, 0.3, 0 }, { 0.75 - rounding, 0.6, 0 },
                     { 0.25, 0.7, 0.25 } },
        type));
    filter->SetBarrierArrayName("barrier");
    RunWithoutError(check, filter, "sources on a rim");
  }
}

/// A block is named in the message; one without the array has no barriers.
void CheckBlocks(Check& check)
{
  const auto right = [](const Point& p) { return p[0] > 0.5; };
  const auto left = [](const Point& p) { return p[0] < 0.5; };
  const auto filter =
    RefinedField(Blocks({ Part(Square(8), left), WithBarriers(Part(Square(8), right), IsInside) }),
      PointSources({ { 0.6, 0.5, 0 } }));
  filter->SetBarrierArrayName("barrier");
  Messages messages(filter);
  messages.ExpectError(check, { "of block 2 of the surface" }, "a source in a barrier of a block");
  filter->SetSourceData(PointSources({ { 0.4, 0.5, 0 } }));
  messages.ExpectNoError(check, "a block without barriers");
}

}

int TestGeodesicBarrierErrors(int, char*[])
{
  Check check;
  CheckArrays(check);
  CheckPointArray(check);
  CheckSources(check);
  CheckRim(check);
  CheckBlocks(check);
  return check.Result();
}
