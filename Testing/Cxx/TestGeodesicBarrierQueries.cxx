// SPDX-License-Identifier: BSD-3-Clause
// Paths, isolines and matrices on a surface with a barrier, in closed form; targets in the barrier
// are not reached.
#include "BarrierTesting.h"

#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkTable.h"

using namespace GeodesicTesting;

namespace
{

const Point Source{ 0.125, 0.1875, 0 };

/// Two in the wall, of which one is at a vertex, and others on both sides and on the rim.
const std::vector<Point> Targets = { { 0.3, 0.9, 0 }, { 0.5625, 0.25, 0 }, { 0.9, 0.1, 0 },
  { WallBegin, 0.5, 0 }, { 0.59, 0.31, 0 }, { WallEnd, 0.4375, 0 }, { 0.51, 0.97, 0 } };

bool IsInBarrier(std::size_t target)
{
  return target == 1 || target == 4;
}

void CheckPaths(Check& check)
{
  vtkNew<vtkGeodesicPaths> filter;
  filter->SetTargetsData(PointSources(Targets));
  const std::string warning =
    RunWithBarriers(check, filter, SquareWithWall(16), PointSources({ Source }), "paths");
  check.That(
    Contains(warning, "2 targets not reached"), "targets in a barrier are counted: " + warning);
  auto* output = OutputOf(filter);
  check.Equal(output->GetNumberOfLines(), 5.0, "paths");
  vtkIdType line = 0;
  for (std::size_t i = 0; i < Targets.size(); ++i)
  {
    if (IsInBarrier(i))
    {
      continue;
    }
    check.Equal(CellValue(output, "TargetId", line), i, "the target of a path");
    const double length = CellValue(output, "GeodesicDistance", line);
    check.Near(length, AroundWall(Source)(Targets[i]), 1e-12, "the length of a path around a wall");
    const std::vector<Point> points = CornersOf(output, output->GetNumberOfVerts() + line);
    for (std::size_t k = 1; k < points.size(); ++k)
    {
      check.That(IsFree(points[k - 1], points[k]), "no piece of a path crosses the wall");
    }
    ++line;
  }
}

void CheckMatrix(Check& check)
{
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetTargetsData(PointSources(Targets));
  RunWithBarriers(
    check, filter, SquareWithWall(16), PointSources({ Source, { 0.8, 0.3, 0 } }), "a matrix");
  vtkTable* table = filter->GetOutput();
  check.Equal(table->GetNumberOfRows(), Targets.size(), "rows");
  for (std::size_t i = 0; i < Targets.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    check.Equal(table->GetValueByName(row, "TargetId").ToDouble(), i, "row");
    const double value = table->GetValueByName(row, "Source0").ToDouble();
    const double truth = AroundWall(Source)(Targets[i]);
    check.That(IsInBarrier(i) ? std::isinf(value) : std::abs(value - truth) < 1e-12,
      "an entry: " + std::to_string(value) + " instead of " + std::to_string(truth));
    check.Equal(std::isinf(table->GetValueByName(row, "Source1").ToDouble()) ? 1.0 : 0.0,
      IsInBarrier(i) ? 1.0 : 0.0, "whether a target is reached from the other source");
  }
}

void CheckContour(Check& check)
{
  vtkNew<vtkGeodesicContour> filter;
  filter->GenerateValues(8, 0.2, 1.2);
  RunWithBarriers(check, filter, SquareWithWall(16), PointSources({ Source }), "isolines");
  auto* output = OutputOf(filter);
  check.That(output->GetNumberOfLines() >= 8, "there are lines");
  vtkDataArray* values = output->GetPointData()->GetArray("GeodesicDistance");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Point p = PointAt(output, i);
    // Rounding may put a point of the rim a little inside.
    const bool isInside =
      IsInWall(p) && std::min({ p[0] - WallBegin, WallEnd - p[0], WallTop - p[1] }) > 1e-12;
    check.That(!isInside, "no line is drawn in a barrier");
    const double truth = AroundWall(Source)(p);
    check.That(std::isinf(truth) || std::abs(values->GetTuple1(i) - truth) < 1e-9,
      "a point of an isoline: " + std::to_string(truth));
  }
}

}

int TestGeodesicBarrierQueries(int, char*[])
{
  Check check;
  CheckPaths(check);
  CheckMatrix(check);
  CheckContour(check);
  return check.Result();
}
