// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths from targets: ports and arrays, truth on planes, composite and boundary sources,
// and what is wrong with the input.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkGeodesicPaths.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"

using namespace GeodesicTesting;

namespace
{

/// The points of a line of the output.
std::vector<Point> LinePoints(vtkPolyData* output, vtkIdType line)
{
  std::vector<Point> points;
  for (const vtkIdType id : IdsOf(output->GetLines(), line))
  {
    points.push_back(PointAt(output, id));
  }
  return points;
}

/// Checks what holds of every output: arrays of the right types, lengths that are those of the
/// lines, and what is left at each point.
void CheckArrays(Check& check, vtkPolyData* output, const std::string& what)
{
  vtkCellData* cells = output->GetCellData();
  for (const char* name : { "TargetId", "SourceId" })
  {
    check.That(vtkIdTypeArray::SafeDownCast(cells->GetArray(name)) != nullptr, what + name);
  }
  for (const char* name : { "GeodesicDistance", "TargetSnapDistance" })
  {
    check.That(vtkDoubleArray::SafeDownCast(cells->GetArray(name)) != nullptr, what + name);
  }
  vtkDataArray* left = output->GetPointData()->GetScalars();
  check.That(left && left->GetName() == std::string("GeodesicDistance"), what + "point scalars");
  vtkIdType point = 0;
  for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
  {
    const std::vector<Point> points = LinePoints(output, line);
    const double length = CellValue(output, "GeodesicDistance", line);
    check.That(points.size() >= 2, what + "two points at least");
    check.Near(
      LengthOf(output, line), length, 1e-12 * length, what + "the length is that of the line");
    check.Equal(left->GetTuple1(point), length, what + "all is left at the target");
    point += static_cast<vtkIdType>(points.size());
    check.Equal(left->GetTuple1(point - 1), 0.0, what + "nothing is left at the source");
  }
}

void CheckStraightPathsInTheSquare(Check& check)
{
  vtkNew<vtkGeodesicPaths> filter;
  filter->SetInputData(Square(16));
  // A line without points has a number all the same.
  auto source = Polyline({ { 0.2, 0.1, 0.0 }, { 0.2, 0.9, 0.0 } });
  filter->SetSourceData(source);
  filter->SetTargetsData(
    PointSources({ { 0.9, 0.35, 0.25 }, { 0.2, 0.5, 0.0 }, { 0.1, 0.95, 0 } }));
  Messages messages(filter);
  messages.ExpectNoError(check, "straight paths: a target beside the square is told");
  CheckWords(check, messages.Warning(), { "at 1 of 3 points: point 0." },
    "straight paths: a target beside the square is told");
  vtkPolyData* output = filter->GetOutput();
  check.Equal(output->GetNumberOfLines(), 3, "a line for each target");
  CheckArrays(check, output, "straight paths: ");
  const double expected[3] = { 0.7, 0.0, std::hypot(0.1, 0.05) };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    check.Equal(CellValue(output, "TargetId", i), i, "target id");
    check.Equal(CellValue(output, "SourceId", i), 0, "source id");
    check.Near(
      CellValue(output, "GeodesicDistance", i), expected[i], 1e-15, "length " + std::to_string(i));
    check.Near(
      CellValue(output, "TargetSnapDistance", i), (i == 0 ? 0.25 : 0.0), 1e-16, "snap distance");
  }
  // 16 squares a unit with a diagonal each: from 0.9 to 0.2 there are 11 vertical edges.
  const std::vector<Point> first = LinePoints(output, 0);
  check.That(first.size() > 20, "a point at every edge: " + std::to_string(first.size()));
  for (const Point& p : first)
  {
    check.That(std::abs(p[1] - 0.35) <= 1e-15 && p[2] == 0.0, "straight");
  }
  const std::vector<Point> onSource = LinePoints(output, 1);
  check.That(onSource.size() == 2 && onSource[0] == onSource[1], "two equal points on the source");
}

void CheckIds(Check& check)
{
  auto lines = Polyline({ { 0.1, 0.1, 0.0 }, { 0.1, 0.9, 0.0 } });
  lines->GetPoints()->InsertNextPoint(0.9, 0.9, 0.0);
  lines->SetVerts(CellArray({ { 2 } })); // cell 0, the line is cell 1
  const auto sources = Blocks({ PointSources({ { 0.5, 0.1, 0.0 }, { 0.5, 0.2, 0.0 } }), // 0 and 1
    nullptr, lines });                                                                  // 2 and 3
  const auto targets = Blocks({ PointSources({ { 0.5, 0.25, 0.0 } }), nullptr,
    PointSources({ { 0.85, 0.9, 0.0 }, { 0.15, 0.5, 0.0 }, { 0.99, 0.5, 0 } }) });

  const auto filter = FilterOn<vtkGeodesicPaths>(Square(8), sources);
  filter->SetTargetsData(targets);
  filter->Update();
  const double expected[3] = { 1, 2, 3 };
  vtkPolyData* output = filter->GetOutput();
  check.Equal(output->GetNumberOfLines(), 4, "a line for each target");
  for (vtkIdType i = 0; i < 3; ++i)
  {
    check.Equal(CellValue(output, "TargetId", i), i, "target over blocks");
    check.Equal(CellValue(output, "SourceId", i), expected[i], "source over blocks");
  }
  filter->SetSourceTypeToCurveAndBoundary();
  filter->Update();
  check.Equal(CellValue(filter->GetOutput(), "SourceId", 3), 4, "the loop follows the cells");
  filter->SetSourceTypeToSurfaceBoundary();
  filter->SetSourceData(nullptr);
  filter->Update();
  output = filter->GetOutput();
  for (vtkIdType i = 0; i < 4; ++i)
  {
    check.Equal(CellValue(output, "SourceId", i), 0, "the only loop");
    const Point target = LinePoints(output, i).front();
    check.Near(CellValue(output, "GeodesicDistance", i), DistanceToBoundaryOfSquare(target), 1e-15,
      "distance to the boundary");
  }
}

/// Two blocks of a surface, moved apart from a third part that no path leads to.
void CheckCompositeSurfaceAndUnreached(Check& check)
{
  const auto right = Moved(Square(4), MovedBy(1.0));
  const auto island = Moved(Square(2), MovedBy(5.0));
  const auto surface = Blocks({ Square(4), right, island });
  const auto filter = FilterOn<vtkGeodesicPaths>(surface, PointSources({ { 0.1, 0.3, 0.0 } }));
  filter->SetTargetsData(
    PointSources({ { 5.5, 0.5, 0.0 }, { 1.7, 0.6, 0.0 }, { 5.7, 0.5, 0.0 }, { 1.2, 0.6, 0.0 } }));
  Messages messages(filter);
  messages.ExpectNoError(check, "composite: no error");
  check.That(Contains(messages.Warning(), "2 targets not reached"), messages.Warning());
  vtkPolyData* output = filter->GetOutput();
  check.That(output != nullptr, "composite: one vtkPolyData");
  check.Equal(output->GetNumberOfLines(), 2, "composite: reached targets");
  check.Equal(CellValue(output, "TargetId", 0), 1, "composite: target 1");
  check.Equal(CellValue(output, "TargetId", 1), 3, "composite: target 3");
  check.Near(CellValue(output, "GeodesicDistance", 0), std::hypot(1.6, 0.3), 1e-14, "length");
  CheckArrays(check, output, "composite: ");
}

/// Of equally close places on two sheets a target takes the vertex.
void CheckVertexBeforeFace(Check& check)
{
  for (const bool isVertexFirst : { true, false })
  {
    auto upright = Square(1);
    MovePoints(upright, [](const Point& p) { return Point{ 0.75 + p[0], 0.25, 0.25 + p[1] }; });
    const auto surface =
      Blocks({ isVertexFirst ? upright : Square(1), isVertexFirst ? Square(1) : upright });
    const auto filter = FilterOn<vtkGeodesicPaths>(surface, PointSources({ { 1.5, 0.25, 0.75 } }));
    filter->SetTargetsData(PointSources({ { 0.75, 0.25, 0.125 } }));
    Messages messages(filter);
    messages.Update();
    check.That(filter->GetOutput()->GetNumberOfLines() == 1,
      "a target between a vertex of one sheet and a face of another: " + messages.Warning());
  }
}

void CheckEmpty(Check& check, vtkGeodesicPaths* filter, const std::string& what)
{
  check.That(filter->GetOutput()->GetNumberOfPoints() == 0 &&
      filter->GetOutput()->GetNumberOfCells() == 0 &&
      filter->GetOutput()->GetCellData()->GetNumberOfArrays() == 0,
    what + " leaves the output empty");
}

/// Targets that cannot be used.
struct BadTargets
{
  std::string Name;
  vtkSmartPointer<vtkDataObject> Data;
  std::vector<std::string> Words;
};

void CheckBadInput(Check& check)
{
  const double nan = vtkMath::Nan();
  const auto blocks = Blocks(
    { PointSources({ { 0, 0, 0 } }), PointSources({ { 0, 0, 0 }, { vtkMath::Inf(), 0, 0 } }) });
  vtkNew<vtkTable> table;
  const std::vector<BadTargets> cases = {
    { "no targets", nullptr, { "no targets", "port 2", "Targets" } },
    { "empty targets", vtkSmartPointer<vtkPolyData>::New(), { "port 2", "empty" } },
    { "NaN targets", PointSources({ { 0, 0, 0 }, { 1, 1, 0 }, { 0, nan, 0 } }),
      { "port 2", "NaN", "point 2", "Remove" } },
    { "infinite targets in a block", blocks, { "port 2", "Block 2", "point 1", "infinite" } },
    { "a table", table, { "port 2", "vtkTable", "Extract Surface" } },
  };
  for (const BadTargets& bad : cases)
  {
    const auto filter = FilterOn<vtkGeodesicPaths>(Square(2), PointSources({ { 0, 0, 0 } }));
    filter->SetTargetsData(PointSources({ { 1, 1, 0 } }));
    Messages messages(filter);
    messages.Update();
    check.Equal(filter->GetOutput()->GetNumberOfLines(), 1, "a good run");
    filter->SetTargetsData(bad.Data);
    messages.ExpectError(check, bad.Words, bad.Name);
    CheckEmpty(check, filter, bad.Name);
  }
}

}

int TestGeodesicPaths(int, char*[])
{
  Check check;
  CheckStraightPathsInTheSquare(check);
  CheckIds(check);
  CheckCompositeSurfaceAndUnreached(check);
  CheckVertexBeforeFace(check);
  CheckBadInput(check);
  return check.Result();
}
