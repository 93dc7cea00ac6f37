// SPDX-License-Identifier: BSD-3-Clause
// vtkGeodesicContour in a pipeline: its values, arrays and lines, what is wrong with properties,
// composite input.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkGeodesicContour.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"

#include <limits>
#include <map>

using namespace GeodesicTesting;

namespace
{

constexpr double Pi = 3.14159265358979323846;

struct Line
{
  std::vector<vtkIdType> Points;
  double Value = 0.0;
  double Length = 0.0;
  bool IsClosed() const { return this->Points.front() == this->Points.back(); }
};

std::vector<Line> LinesOf(Check& check, vtkPolyData* output)
{
  std::vector<Line> lines;
  vtkDataArray* atCells = output->GetCellData()->GetArray("GeodesicDistance");
  vtkDataArray* atPoints = output->GetPointData()->GetArray("GeodesicDistance");
  if (!atCells || !atPoints || atCells->GetNumberOfTuples() != output->GetNumberOfCells() ||
    atPoints->GetNumberOfTuples() != output->GetNumberOfPoints())
  {
    check.That(output->GetNumberOfCells() == 0, "every cell and point has its value");
    return lines;
  }
  check.That(atCells->GetDataType() == VTK_DOUBLE, "values are doubles");
  for (vtkIdType i = 0; i < output->GetNumberOfLines(); ++i)
  {
    Line line;
    line.Points = IdsOf(output->GetLines(), i);
    line.Value = atCells->GetTuple1(output->GetNumberOfVerts() + i);
    line.Length = LengthOf(output, i);
    for (const vtkIdType id : line.Points)
    {
      check.That(atPoints->GetTuple1(id) == line.Value, "a point has its line's value");
    }
    lines.push_back(line);
  }
  return lines;
}

void SetUp(vtkGeodesicContour* filter, vtkPolyData* surface, vtkPolyData* source,
  const std::vector<double>& values)
{
  filter->SetInputData(surface);
  filter->SetSourceData(source);
  filter->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    filter->SetValue(static_cast<int>(i), values[i]);
  }
}

void CheckCircles(Check& check)
{
  vtkNew<vtkGeodesicContour> filter;
  const Point center = { 0.47, 0.52, 0.0 };
  // Neither in order nor different.
  SetUp(filter, Square(16), PointSources({ center }), { 0.4, 0.1, 0.4, 0.25, 7.0 });
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const std::vector<Line> lines = LinesOf(check, output);
  check.Equal(lines.size(), 3, "lines of three values within the square");
  const double tolerance = 0.0001 * std::sqrt(2.0);
  const std::vector<double> values = { 0.1, 0.25, 0.4 };
  for (std::size_t i = 0; i < lines.size() && i < values.size(); ++i)
  {
    check.Equal(lines[i].Value, values[i], "lines are in the order of the values");
    check.That(lines[i].IsClosed(), "a circle is closed");
    const double circle = 2.0 * Pi * values[i];
    check.That(lines[i].Length <= circle * (1.0 + 1e-12) &&
        lines[i].Length >= circle * (1.0 - tolerance / (2.9 * values[i])),
      "chords are within their tolerance of the circle");
    check.That(output->GetPointData()->GetScalars() && output->GetCellData()->GetScalars(),
      "the value is the active scalars");
    // The distance grows to the left: round the centre with the clock.
    const Point a = PointAt(output, lines[i].Points[0]);
    const Point b = PointAt(output, lines[i].Points[1]);
    check.That(
      (a[0] - center[0]) * (b[1] - center[1]) - (a[1] - center[1]) * (b[0] - center[0]) < 0,
      "the distance grows to the left");
  }
  CheckTruth(check, output, DistanceTo({ center }), "circles");
  filter->SetChordTolerance(0.01);
  filter->Update();
  const vtkIdType coarse = filter->GetOutput()->GetNumberOfPoints();
  filter->ToleranceIsAbsoluteOn();
  filter->SetAbsoluteChordTolerance(1e-6);
  filter->Update();
  check.That(filter->GetOutput()->GetNumberOfPoints() > 4 * coarse,
    "a smaller tolerance asks for more points");
}

void CheckValues(Check& check)
{
  vtkNew<vtkGeodesicContour> filter;
  check.Equal(filter->GetNumberOfContours(), 0, "no value by default");
  filter->GenerateValues(5, 0.1, 0.5);
  check.Equal(filter->GetNumberOfContours(), 5, "generated values");
  check.Equal(filter->GetValue(0), 0.1, "first value");
  check.Equal(filter->GetValues()[4], 0.5, "last value");
  double range[2] = { 1.0, 2.0 };
  filter->GenerateValues(3, range);
  double values[3];
  filter->GetValues(values);
  check.Equal(values[1], 1.5, "a value in the middle");
  const vtkMTimeType before = filter->GetMTime();
  filter->SetValue(1, 1.5);
  check.That(filter->GetMTime() == before, "the same value modifies nothing");
  filter->SetValue(1, 1.6);
  check.That(filter->GetMTime() > before, "another value modifies the filter");
  std::ostringstream text;
  filter->Print(text);
  check.That(Contains(text.str(), "ChordTolerance: 0.0001"), "PrintSelf tells the tolerance");
}

void CheckValueZero(Check& check)
{
  auto source = Polyline({ { 0.2, 0.3, 0 }, { 0.6, 0.31, 0 }, { 0.7, 0.72, 0 } });
  source->SetVerts(CellArray({ { source->GetPoints()->InsertNextPoint(0.1, 0.9, 0.0) } }));
  vtkNew<vtkGeodesicContour> filter;
  SetUp(filter, Square(8), source, { 0.0 });
  filter->Update();
  const std::vector<Line> lines = LinesOf(check, filter->GetOutput());
  check.Equal(filter->GetOutput()->GetNumberOfVerts(), 1, "a vertex at 0");
  check.Equal(lines.size(), 1, "the curve at 0");
  const Point first = PointAt(filter->GetOutput(), lines[0].Points.front());
  const Point last = PointAt(filter->GetOutput(), lines[0].Points.back());
  check.That(first[0] < 0.21 && last[0] > 0.69, "the curve in its own direction");
  check.That(std::abs(lines[0].Length - std::hypot(0.4, 0.01) - std::hypot(0.1, 0.41)) < 1e-12,
    "the whole curve");
  filter->SetNumberOfContours(2);
  filter->SetValue(1, 0.05);
  filter->Update();
  check.Equal(filter->GetOutput()->GetNumberOfVerts(), 1, "0 among others");
  check.Equal(LinesOf(check, filter->GetOutput()).size(), 3,
    "the curve, and a line round it and round the point");
}

/// A table of the points can be cut into lines again.
void CheckLineIds(Check& check)
{
  const auto filter =
    FilterOn<vtkGeodesicContour>(Square(8), PointSources({ { 0.2, 0.2, 0 }, { 0.8, 0.7, 0 } }));
  filter->SetNumberOfContours(3);
  filter->SetValue(0, 0.0); // two vertices
  filter->SetValue(1, 0.1); // two circles
  filter->SetValue(2, 0.3); // arcs
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("LineId"));
  check.That(
    ids && ids->GetNumberOfTuples() == output->GetNumberOfPoints(), "a line for each point");
  check.That(output->GetNumberOfVerts() == 2 && output->GetNumberOfCells() > 4, "points and lines");
  vtkIdType next = 0;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; ids && cell < output->GetNumberOfCells(); ++cell)
  {
    output->GetCellPoints(cell, points);
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      const vtkIdType point = points->GetId(i);
      const bool isRepeated = i > 0 && point == points->GetId(0);
      check.That(isRepeated || point == next++, "points stand in the order of their lines");
      check.That(ids->GetValue(point) == cell, "the line of a point");
    }
  }
  check.That(next == output->GetNumberOfPoints(), "every point belongs to a line");
}

void CheckBoundary(Check& check)
{
  vtkNew<vtkGeodesicContour> filter;
  SetUp(filter, Square(7), nullptr, { 0.1, 0.2, 0.45, 0.55 });
  filter->SetSourceTypeToSurfaceBoundary();
  filter->Update();
  const std::vector<Line> lines = LinesOf(check, filter->GetOutput());
  check.Equal(lines.size(), 3, "squares inside the square");
  for (const Line& line : lines)
  {
    check.That(line.IsClosed() && std::abs(line.Length - 4.0 * (1.0 - 2.0 * line.Value)) < 1e-12,
      "a smaller square");
  }
  CheckTruth(check, filter->GetOutput(), DistanceToBoundaryOfSquare, "squares");
}

// Two halves that touch are one surface, and lines go on from one to the other.
void CheckComposite(Check& check)
{
  const auto right = Moved(Square(8), MovedBy(1.0));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Square(8));
  blocks->SetBlock(2, right);
  const auto filter = FilterOn<vtkGeodesicContour>(blocks, PointSources({ { 0.9, 0.47, 0.0 } }));
  filter->SetValue(0, 0.3);
  filter->Update();
  const std::vector<Line> lines = LinesOf(check, filter->GetOutput());
  check.Equal(lines.size(), 1, "one line over both blocks");
  check.That(!lines.empty() && lines[0].IsClosed(), "it is closed");
}

void CheckBadProperties(Check& check)
{
  const auto expect = [&](const std::string& words, auto&& change)
  {
    vtkNew<vtkGeodesicContour> filter;
    SetUp(filter, Square(4), PointSources({ { 0.4, 0.4, 0 } }), { 0.2 });
    filter->Update();
    change(filter.Get());
    Messages(filter).ExpectError(check, { words }, "a bad property");
    check.That(
      filter->GetOutput()->GetNumberOfPoints() == 0 && filter->GetOutput()->GetNumberOfCells() == 0,
      "the output is empty: " + words);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expect("no value", [](vtkGeodesicContour* f) { f->SetNumberOfContours(0); });
  expect("Value 0 is -0.1", [](vtkGeodesicContour* f) { f->SetValue(0, -0.1); });
  expect("Value 1 is nan", [nan](vtkGeodesicContour* f) { f->SetValue(1, nan); });
  expect("Value 0 is inf", [infinity](vtkGeodesicContour* f) { f->SetValue(0, infinity); });
  expect("ChordTolerance is not", [](vtkGeodesicContour* f) { f->SetChordTolerance(0.0); });
  expect("ChordTolerance is not", [nan](vtkGeodesicContour* f) { f->SetChordTolerance(nan); });
  expect("AbsoluteChordTolerance is not",
    [](vtkGeodesicContour* f)
    {
      f->ToleranceIsAbsoluteOn();
      f->SetAbsoluteChordTolerance(-1.0);
    });
  expect("no source", [](vtkGeodesicContour* f) { f->SetSourceData(nullptr); });
}

vtkSmartPointer<vtkPolyData> WithTurnedFaces()
{
  auto surface = Square(6);
  auto triangles = CellsOf(surface->GetPolys());
  for (std::size_t f = 0; f < triangles.size(); f += 5)
  {
    std::swap(triangles[f][1], triangles[f][2]);
  }
  surface->SetPolys(CellArrayOf(triangles));
  return surface;
}

void CheckDirectionWarning(Check& check)
{
  vtkNew<vtkGeodesicContour> filter;
  SetUp(filter, WithTurnedFaces(), PointSources({ { 0.5, 0.48, 0 } }), { 0.3 });
  Messages(filter).ExpectWarning(
    check, { "opposite orientation" }, "a direction that says nothing");
  const std::vector<Line> lines = LinesOf(check, filter->GetOutput());
  check.That(lines.size() == 1 && lines[0].IsClosed(), "the line is whole all the same");
}

// A curve from one end of the square to the other: its left is above it.
void CheckSigned(Check& check)
{
  auto source = Polyline({ { 0.0, 0.4, 0 }, { 1.0, 0.4, 0 } });
  vtkNew<vtkGeodesicContour> filter;
  SetUp(filter, Square(8), source, { 0.2, -0.1, -0.2, 0.0, 0.5 });
  filter->SignedDistancesOn();
  filter->Update();
  const std::vector<Line> lines = LinesOf(check, filter->GetOutput());
  const std::vector<double> values = { 0.0, -0.2, -0.1, 0.2, 0.5 };
  check.Equal(lines.size(), 5, "a line a signed value");
  for (std::size_t i = 0; i < lines.size() && i < values.size(); ++i)
  {
    check.Equal(lines[i].Value, values[i], "the signed value");
    const Point first = PointAt(filter->GetOutput(), lines[i].Points.front());
    const Point last = PointAt(filter->GetOutput(), lines[i].Points.back());
    check.That(std::abs(first[1] - 0.4 - values[i]) < 1e-12, "on its side of the curve");
    check.That(first[0] < 0.01 && last[0] > 0.99, "in the curve's direction");
    check.Near(lines[i].Length, 1.0, 1e-12, "as long as the curve");
  }
  // The boundary has no right-hand side.
  filter->SetSourceTypeToSurfaceBoundary();
  filter->SetNumberOfContours(2);
  filter->SetValue(0, -0.1);
  filter->SetValue(1, 0.2);
  filter->Update();
  const std::vector<Line> inside = LinesOf(check, filter->GetOutput());
  check.That(inside.size() == 1 && inside[0].Value == 0.2, "the boundary is positive");

  SetUp(filter, WithTurnedFaces(), source, { 0.1 });
  filter->SetSourceTypeToSourceCurve();
  Messages(filter).ExpectError(check, { "SignedDistances needs a surface whose faces have one" },
    "sides need one orientation");
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "no lines then");
}

}

int TestGeodesicContour(int, char*[])
{
  Check check;
  CheckCircles(check);
  CheckValues(check);
  CheckValueZero(check);
  CheckLineIds(check);
  CheckBoundary(check);
  CheckComposite(check);
  CheckBadProperties(check);
  CheckDirectionWarning(check);
  CheckSigned(check);
  return check.Result();
}
