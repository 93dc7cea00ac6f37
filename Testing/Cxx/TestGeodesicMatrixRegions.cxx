// SPDX-License-Identifier: BSD-3-Clause
// Tables of regions: equal values of TargetIdArrayName are one target, whose distance is the least
// over its points, lines and outlines.
#include "GeodesicTesting.h"
#include "RegionTesting.h"
#include "TableTesting.h"

#include "vtkDoubleArray.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>

using namespace GeodesicTesting;

namespace
{

/// A rectangle in the unit square, on lines of an 8 x 8 grid.
struct Rectangle
{
  int Label;
  double Low[2];
  double High[2];

  bool Holds(const Point& p) const
  {
    return this->Low[0] < p[0] && p[0] < this->High[0] && this->Low[1] < p[1] &&
      p[1] < this->High[1];
  }
  double DistanceTo(const Rectangle& other) const
  {
    double apart[2];
    for (int x = 0; x < 2; ++x)
    {
      apart[x] = std::max({ 0.0, other.Low[x] - this->High[x], this->Low[x] - other.High[x] });
    }
    return std::hypot(apart[0], apart[1]);
  }
};

/// The second touches none; the last two touch in a corner. One label has two rectangles.
const std::vector<Rectangle> Rectangles = { { 40, { 0, 0 }, { 0.25, 0.25 } },
  { 7, { 0.5, 0.625 }, { 0.75, 0.875 } }, { 3, { 0.75, 0 }, { 1, 0.125 } },
  { 3, { 0.375, 0.125 }, { 0.5, 0.25 } }, { 12, { 0.5, 0.25 }, { 0.625, 0.375 } } };
const std::vector<int> Ids = { 3, 7, 12, 40 };

double Truth(int a, int b)
{
  double least = Infinity;
  for (const Rectangle& one : Rectangles)
  {
    for (const Rectangle& other : Rectangles)
    {
      if (one.Label == a && other.Label == b)
      {
        least = std::min(least, one.DistanceTo(other));
      }
    }
  }
  return least;
}

int LabelAt(const Point& p)
{
  for (const Rectangle& rectangle : Rectangles)
  {
    if (rectangle.Holds(p))
    {
      return rectangle.Label;
    }
  }
  return -5;
}

double DistanceAt(const Point& p, int label)
{
  double least = Infinity;
  for (const Rectangle& rectangle : Rectangles)
  {
    if (rectangle.Label == label)
    {
      least = std::min(least, rectangle.DistanceTo({ 0, { p[0], p[1] }, { p[0], p[1] } }));
    }
  }
  return least;
}

template <typename Array>
vtkSmartPointer<vtkPolyData> LabelledSquare()
{
  return Labelled<Array>(Square(8), LabelAt);
}

vtkSmartPointer<vtkGeodesicDistanceMatrix> MatrixOf(
  vtkDataObject* surface, vtkDataObject* source, vtkDataObject* targets = nullptr)
{
  auto matrix = vtkSmartPointer<vtkGeodesicDistanceMatrix>::New();
  matrix->SetInputData(surface);
  matrix->SetSourceData(source);
  matrix->SetTargetsData(targets);
  matrix->SetTargetIdArrayName("Label");
  return matrix;
}

void CheckAllRegions(Check& check)
{
  const auto surface = LabelledSquare<vtkIntArray>();
  for (const bool isSeparate : { false, true })
  {
    const auto parts = WithoutNegative(surface);
    const auto matrix = MatrixOf(surface, parts, isSeparate ? surface.Get() : nullptr);
    matrix->SetSourceIdArrayName("Label");
    const std::string what = isSeparate ? "regions on port 2" : "all regions";
    const auto table = TableOf(check, matrix, what);
    CheckIds(check, matrix->GetOutput(), Ids, what);
    for (std::size_t i = 0; i < Ids.size() && table.size() == Ids.size(); ++i)
    {
      check.That(matrix->GetOutput()->GetColumnName(static_cast<vtkIdType>(i) + 1) ==
          "Source" + std::to_string(Ids[i]),
        what + ": names of columns");
      for (std::size_t j = 0; j < Ids.size(); ++j)
      {
        const double truth = Truth(Ids[i], Ids[j]);
        check.That(std::abs(table[i][j] - truth) <= 1e-14,
          what + ": " + std::to_string(table[i][j]) + " for " + std::to_string(truth));
        check.That(isSeparate || table[i][j] == table[j][i], what + ": symmetric");
      }
    }
  }
}

/// One of the few targets is solved, or the point.
void CheckPointsAndLines(Check& check)
{
  const auto surface = LabelledSquare<vtkIntArray>();
  const std::vector<Point> places = { { 0.3, 0.9, 0 }, { 0.0625, 0.1, 0 }, { 0.9, 0.4, 0 },
    { 0.4375, 0.1875, 0 }, { 0.1, 0.6, 0 }, { 0.5, 0.5, 0 } };
  const auto points = PointSources(places);
  const auto table = TableOf(check, MatrixOf(surface, points, surface), "points to regions");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const double truth = DistanceAt(places[i], Ids[row]);
      check.That(std::abs(table[row][i] - truth) <= 1e-14 && (truth > 0 || table[row][i] == 0),
        "points to regions: " + std::to_string(table[row][i]) + " for " + std::to_string(truth));
    }
  }
  // A line whose nearest point is between vertices, and two points, of one value each.
  const auto line = Polyline({ { 0.1, 0.7, 0 }, { 0.9, 0.7, 0 } });
  SetCellLabels(line, { 2 });
  const auto toLine = TableOf(check, MatrixOf(surface, points, line), "a line");
  check.That(toLine.size() == 1 && std::abs(toLine[0][0] - 0.2) <= 1e-14 &&
      std::abs(toLine[0][1] - std::hypot(0.0375, 0.6)) <= 1e-14,
    "the least distance along a line");
  const auto targets = PointSources({ { 0.3, 0.8, 0 }, { 0.9, 0.9, 0 }, { 0.3, 0.1, 0 } });
  SetPointLabels(targets, { 6, 1, 6 });
  const auto toPoints = MatrixOf(surface, points, targets);
  const auto pairs = TableOf(check, toPoints, "sets of points");
  CheckIds(check, toPoints->GetOutput(), { 1, 6 }, "sets of points");
  check.That(pairs.size() == 2 && std::abs(pairs[1][0] - 0.1) <= 1e-14 &&
      std::abs(pairs[1][1] - 0.2375) <= 1e-14 && std::abs(pairs[0][2] - 0.5) <= 1e-14,
    "the nearest point of a set");
}

/// An array of the points of a data set with cells makes sets of its points.
void CheckArrayOfPoints(Check& check)
{
  const auto surface = Square(8);
  std::vector<int> labels(81, -1);
  labels[0] = 9;
  labels[80] = 9;
  labels[8] = 4;
  SetPointLabels(surface, labels);
  const auto matrix = MatrixOf(surface, PointSources({ { 0.75, 0.5, 0 } }), surface);
  const auto table = TableOf(check, matrix, "an array of points");
  CheckIds(check, matrix->GetOutput(), { 4, 9 }, "an array of points");
  check.That(table.size() == 2 && std::abs(table[0][0] - std::hypot(0.25, 0.5)) <= 1e-14 &&
      std::abs(table[1][0] - std::hypot(0.25, 0.5)) <= 1e-14,
    "an array of points");
}

void CheckNamesPositionsAndBlocks(Check& check)
{
  const auto surface = LabelledSquare<vtkDoubleArray>(); // whole numbers, however stored
  const auto parts = WithoutNegative(surface);
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  auto* labels = parts->GetCellData()->GetArray("Label");
  for (vtkIdType i = 0; i < parts->GetNumberOfCells(); ++i)
  {
    names->InsertNextValue("part " + std::to_string(static_cast<int>(labels->GetTuple1(i))));
  }
  parts->GetCellData()->AddArray(names);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, parts);
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  const auto more = PointSources({ { 0.1, 0.9, 0 } });
  SetPointLabels(more, { 7 });
  vtkNew<vtkStringArray> name;
  name->SetName("Name");
  name->InsertNextValue("ignored");
  more->GetPointData()->AddArray(name);
  blocks->SetBlock(2, more);
  const Point place{ 0.125, 0.875, 0 };
  const auto matrix = MatrixOf(surface, PointSources({ place }), blocks);
  matrix->SetTargetNameArrayName("Name");
  matrix->GenerateTargetPositionsOn();
  const auto table = TableOf(check, matrix, "blocks", 3);
  CheckIds(check, matrix->GetOutput(), Ids, "blocks");
  auto* positions =
    vtkDataArray::SafeDownCast(matrix->GetOutput()->GetColumnByName("TargetPosition"));
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double own = DistanceAt(place, Ids[row]);
    const double truth = Ids[row] == 7 ? std::hypot(0.025, 0.025) : own;
    check.That(std::abs(table[row][0] - truth) <= 1e-14, "blocks are one set of targets");
    check.That(
      matrix->GetOutput()->GetValueByName(static_cast<vtkIdType>(row), "TargetName").ToString() ==
        "part " + std::to_string(Ids[row]),
      "a target goes by the name of its first part");
    Point p;
    positions->GetTuple(static_cast<vtkIdType>(row), p.data());
    const bool isOwnPoint = Ids[row] == 7 && p == Point{ 0.1, 0.9, 0 };
    check.That(DistanceAt(p, Ids[row]) <= 1e-15 || isOwnPoint, "a target's position is on it");
  }
}

void CheckBarriers(Check& check)
{
  const auto surface = Square(8);
  AddArrayOf<vtkIntArray>(surface->GetCellData(), "Wall", surface->GetNumberOfCells(),
    [&](vtkIdType i)
    {
      const Point p = CentreOf(surface, i);
      return p[0] > 0.5 && p[0] < 0.625 && p[1] < 0.875 ? 1 : 0;
    });
  const auto source = PointSources({ { 0.25, 0.25, 0 } });
  const auto targets =
    PointSources({ { 0.5625, 0.3, 0 }, { 0.5625, 0.4, 0 }, { 0.6, 0.3, 0 }, { 0.25, 0.75, 0 } });
  SetPointLabels(targets, { 1, 2, 1, 2 });
  const auto matrix = MatrixOf(surface, source, targets);
  matrix->SetBarrierArrayName("Wall");
  const auto table = TableOf(check, matrix, "barriers");
  check.That(table.size() == 2 && table[0][0] == Infinity && std::abs(table[1][0] - 0.5) <= 1e-14,
    "points in a barrier are never reached");
  const auto line = Polyline({ { 0.7, 0.3, 0 }, { 0.55, 0.3, 0 } });
  SetCellLabels(line, { 1 });
  matrix->SetTargetsData(line);
  CheckError(check, matrix, { "(0.55, 0.3, 0)", "barrier" }, "a line into a barrier");
}

void CheckErrors(Check& check)
{
  const auto surface = LabelledSquare<vtkIntArray>();
  const auto source = PointSources({ { 0.1, 0.1, 0 } });
  const auto matrix = MatrixOf(surface, source, surface);
  matrix->SetTargetIdArrayName("Other");
  CheckError(check, matrix,
    { "set of targets (input port 2)", "no cell array named Other", "TargetIdArrayName" },
    "a missing array");
  matrix->SetTargetIdArrayName("None");
  check.That(TableOf(check, matrix, "None").size() == 81, "None: each point is a target");
  matrix->SetTargetIdArrayName("Label");
  auto* labels = surface->GetCellData()->GetArray("Label");
  vtkSmartPointer<vtkDataArray> kept = labels;
  AddArrayOf<vtkDoubleArray>(surface->GetCellData(), "Label", surface->GetNumberOfCells(),
    [](vtkIdType i) { return 0.5 * static_cast<double>(i); });
  CheckError(check, matrix, { "Label (TargetIdArrayName)", "whole number" }, "halves");
  vtkNew<vtkIntArray> pairs;
  pairs->SetName("Label");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(surface->GetNumberOfCells());
  surface->GetCellData()->AddArray(pairs);
  CheckError(check, matrix, { "TargetIdArrayName", "2 components" }, "two components");
  AddArrayOf<vtkIntArray>(
    surface->GetCellData(), "Label", surface->GetNumberOfCells(), [](vtkIdType) { return -1; });
  CheckError(check, matrix, { "has no target", "Negative" }, "negative values alone");
  surface->GetCellData()->AddArray(kept);
  check.That(TableOf(check, matrix, "after errors").size() == Ids.size(), "good again");
}

constexpr int Cuts = 50;

/// Points along the outline of a region, and the largest step between them.
double CutOutline(const Region& region, std::vector<Point>& places)
{
  const auto outline = OutlineOf(region);
  double step = 0.0;
  for (const std::vector<vtkIdType>& ids : CellsOf(outline->GetLines()))
  {
    const Point a = PointAt(outline, ids[0]);
    const Point ab = Minus(PointAt(outline, ids[1]), a);
    step = std::max(step, std::sqrt(Dot(ab, ab)) / Cuts);
    for (int i = 0; i <= Cuts; ++i)
    {
      const double t = static_cast<double>(i) / Cuts;
      places.push_back({ a[0] + t * ab[0], a[1] + t * ab[1], a[2] + t * ab[2] });
    }
  }
  return step;
}

/// The least distance from a region to points that lie densely on the outline of another one.
double LeastDistance(const Region& from, const std::vector<Point>& places)
{
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  matrix->SetInputData(from.Surface);
  matrix->SetSourceData(SourceOf(from));
  matrix->SetSourceIdArrayName("One");
  matrix->SetTargetsData(PointSources(places));
  matrix->Update();
  double least = Infinity;
  for (const std::vector<double>& row : RowsOf(matrix->GetOutput()))
  {
    least = std::min(least, row[0]);
  }
  return least;
}

/// Each face has the label of the nearest of some places, or none.
void CheckRandomRegions(Check& check, std::uint64_t seed)
{
  const std::string name = "seed " + std::to_string(seed);
  const Region random = RandomRegion(seed);
  std::mt19937_64 numbers(seed);
  std::vector<Point> middles;
  for (int i = 0; i < 6; ++i)
  {
    const auto cells = static_cast<std::uint64_t>(random.Surface->GetNumberOfCells());
    middles.push_back(CentreOf(random.Surface, static_cast<vtkIdType>(numbers() % cells)));
  }
  const auto labelAt = [&middles](const Point& p)
  {
    const auto apart = [&p](const Point& m)
    { return std::hypot(p[0] - m[0], std::hypot(p[1] - m[1], p[2] - m[2])); };
    const auto nearest = std::min_element(middles.begin(), middles.end(),
      [&apart](const Point& a, const Point& b) { return apart(a) < apart(b); });
    return static_cast<int>(nearest - middles.begin()) - 2;
  };
  const auto surface = Labelled(random.Surface, labelAt);
  const auto parts = WithoutNegative(surface);
  const auto matrix = MatrixOf(surface, parts);
  matrix->SetSourceIdArrayName("Label");
  const Rows table = TableOf(check, matrix, name);
  std::vector<Region> regions;
  auto* labels = surface->GetCellData()->GetArray("Label");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double id =
      matrix->GetOutput()->GetValueByName(static_cast<vtkIdType>(row), "TargetId").ToDouble();
    regions.push_back({ surface, {} });
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      regions.back().IsInside.push_back(labels->GetTuple1(cell) == id);
    }
  }
  check.That(table.size() > 1, name + ": several regions");
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    std::vector<Point> places;
    const double step = CutOutline(regions[i], places);
    check.Equal(table[i][i], 0.0, name + ": from itself");
    for (std::size_t j = 0; j < table.size(); ++j)
    {
      const double above = i == j ? 0.0 : LeastDistance(regions[j], places);
      check.That(table[i][j] <= above + 1e-12 && table[i][j] >= above - 0.5 * step - 1e-12,
        name + ": " + std::to_string(table[i][j]) + " for " + std::to_string(above));
      check.Equal(table[i][j], table[j][i], name + ": symmetric");
    }
  }
}

}

int TestGeodesicMatrixRegions(int, char*[])
{
  Check check;
  CheckAllRegions(check);
  CheckPointsAndLines(check);
  CheckArrayOfPoints(check);
  CheckNamesPositionsAndBlocks(check);
  CheckBarriers(check);
  CheckErrors(check);
  for (std::uint64_t seed = 0; seed < RegionSeeds(20); ++seed)
  {
    CheckRandomRegions(check, seed);
  }
  return check.Result();
}
