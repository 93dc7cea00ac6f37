// SPDX-License-Identifier: BSD-3-Clause
// A section of a surface that touches or overlaps itself comes out as it went in: on the faces that
// it was cut from, and just as long.
#include "GeodesicTesting.h"

#include "vtkAppendPolyData.h"
#include "vtkMath.h"
#include "vtkReverseSense.h"
#include "vtkStripper.h"

#include <algorithm>
#include <limits>

using namespace GeodesicTesting;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A line in the plane z = 0 as a cut through it: points with a x + b y = c.
struct Line
{
  double a;
  double b;
  double c;
};

vtkSmartPointer<vtkPolyData> CutAlong(vtkPolyData* surface, const Line& line, bool joined)
{
  const double scale = line.c / (line.a * line.a + line.b * line.b);
  const auto lines =
    Section(surface, { line.a, line.b, 0.0 }, { line.a * scale, line.b * scale, 0.0 });
  if (!joined)
  {
    return lines;
  }
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(lines);
  stripper->SetMaximumLength(100000);
  stripper->Update();
  return stripper->GetOutput();
}

vtkSmartPointer<vtkPolyData> Together(vtkPolyData* first, vtkPolyData* second)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->AddInputData(first);
  append->AddInputData(second);
  append->Update();
  return append->GetOutput();
}

/// Distances from a source at a surface's points; checks that the source is as long as it was.
std::vector<double> DistancesFrom(
  Check& check, vtkPolyData* surface, vtkPolyData* source, bool merge, const std::string& what)
{
  const auto filter = PlainField(surface, source);
  filter->SetMergeCoincidentPoints(merge);
  RunWithoutError(check, filter, what);
  const double before = TotalLength(source);
  const double after = TotalLength(OutputOf(filter, 1));
  const bool isFloat = source->GetPoints()->GetDataType() == VTK_FLOAT;
  check.That(before > 0.0, what + ": the source has a length");
  check.Near(after, before, (isFloat ? 1e-6 : 1e-12) * before,
    what + ": the source comes out " + std::to_string(after / before) + " times as long");
  std::vector<double> distances;
  for (vtkIdType i = 0; Distances(filter) && i < surface->GetNumberOfPoints(); ++i)
  {
    distances.push_back(Distances(filter)->GetTuple1(i));
  }
  distances.resize(static_cast<std::size_t>(surface->GetNumberOfPoints()), -1.0);
  return distances;
}

//------------------------------------------------------------------------------
/// The unit square of 8 x 8, with the middle vertex moved over the side opposite in one of its
/// triangles, which is turned over and lies on others.
vtkSmartPointer<vtkPolyData> SquareWithInvertedTriangle(int dataType)
{
  auto surface = Square(8, Cells::Triangles, dataType);
  surface->GetPoints()->SetPoint(4 * 9 + 4, 5.2 / 8.0, 4.5 / 8.0, 0.0);
  return surface;
}

/// Past a section that is straight up, the distance is that of a plane: the turned triangle and
/// what it lies on reach no farther.
void CheckInvertedTriangle(Check& check)
{
  for (const int dataType : { VTK_DOUBLE, VTK_FLOAT })
  {
    auto surface = SquareWithInvertedTriangle(dataType);
    for (const Line& line : { Line{ 0.0, 1.0, 0.556 }, Line{ 0.0, 1.0, 0.5713 },
           Line{ 1.0, 0.0, 0.637 }, Line{ 1.0, 0.2, 0.75 }, Line{ 1.0, -1.0, 0.0717 } })
    {
      for (const bool joined : { true, false })
      {
        const std::string what = "an inverted triangle, the section " + std::to_string(line.a) +
          " x + " + std::to_string(line.b) + " y = " + std::to_string(line.c) +
          (joined ? ", joined" : ", in pieces") + (dataType == VTK_FLOAT ? ", 32 bits" : "");
        auto section = CutAlong(surface, line, joined);
        const auto distances = DistancesFrom(check, surface, section, true, what);
        for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
        {
          const Point p = PointAt(surface, i);
          const double offset = line.a * p[0] + line.b * p[1] - line.c;
          const double away = std::abs(offset) / std::hypot(line.a, line.b);
          const bool isPast = line.b == 0.0 && p[0] > line.c;
          if (isPast)
          {
            check.Near(distances[static_cast<std::size_t>(i)], away,
              dataType == VTK_FLOAT ? 1e-6 : 1e-12, what);
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Two sheets at one place, each with its own triangles and points.
void CheckCoincidentSheets(Check& check)
{
  const Line line{ 1.0, 0.37, 0.7123 };
  const auto away = [&line](const double* p)
  { return std::abs(line.a * p[0] + line.b * p[1] - line.c) / std::hypot(line.a, line.b); };
  auto fine = Square(8);
  auto coarse = Square(5);
  // What the lines leave of a strip through the square is nearest to an end: keep to the middle.
  const auto isBeside = [](const double* p) { return p[1] >= 0.25 && p[1] <= 0.75; };
  for (const bool fineFirst : { true, false })
  {
    auto surface = fineFirst ? Together(fine, coarse) : Together(coarse, fine);
    const vtkIdType inFirst = fineFirst ? fine->GetNumberOfPoints() : coarse->GetNumberOfPoints();
    for (const bool cutFine : { true, false })
    {
      for (const bool joined : { true, false })
      {
        const std::string what = std::string("two sheets, ") + (fineFirst ? "fine" : "coarse") +
          " first, a section of the " + (cutFine ? "fine" : "coarse") + " one" +
          (joined ? ", joined" : ", in pieces");
        auto section = CutAlong(cutFine ? fine : coarse, line, joined);
        const auto distances = DistancesFrom(check, surface, section, false, what);
        for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
        {
          const bool isCut = (i < inFirst) == (cutFine == fineFirst);
          const double* p = surface->GetPoint(i);
          if (!isCut || isBeside(p))
          {
            check.Near(
              distances[static_cast<std::size_t>(i)], isCut ? away(p) : Infinity, 1e-12, what);
          }
        }
      }
    }
    // The section of both at once, in pieces: each keeps to its sheet.
    const std::string what = "two sheets, the section of both";
    const auto distances =
      DistancesFrom(check, surface, CutAlong(surface, line, false), false, what);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double* p = surface->GetPoint(i);
      if (isBeside(p))
      {
        check.Near(distances[static_cast<std::size_t>(i)], away(p), 1e-12, what);
      }
    }
  }
}

/// A curve along the points of one sheet, every second of which is a point of the other, too.
void CheckCoincidentPoints(Check& check)
{
  auto fine = Square(8);
  auto coarse = Square(4);
  for (const bool fineFirst : { true, false })
  {
    auto surface = fineFirst ? Together(fine, coarse) : Together(coarse, fine);
    const vtkIdType inFirst = fineFirst ? fine->GetNumberOfPoints() : coarse->GetNumberOfPoints();
    std::vector<Point> points;
    for (int i = 0; i <= 8; ++i)
    {
      points.push_back({ i / 8.0, 0.5, 0.0 });
    }
    const std::string what = "points of two sheets";
    const auto distances = DistancesFrom(check, surface, Polyline(points), false, what);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const bool isFine = (i < inFirst) == fineFirst;
      check.Near(distances[static_cast<std::size_t>(i)],
        isFine ? std::abs(surface->GetPoint(i)[1] - 0.5) : Infinity, 1e-12, what);
    }
  }
}

/// A closed sheet twice, the second turned inside out: a closed section is on one of them.
void CheckDoubledSphere(Check& check)
{
  auto sphere = ChangedSphere(14, 11, [](const Point& p) { return p; });
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputData(sphere);
  reversed->ReverseCellsOn();
  reversed->Update();
  auto surface = Together(sphere, reversed->GetOutput());
  for (const bool joined : { true, false })
  {
    const std::string what =
      std::string("a doubled sphere, the section ") + (joined ? "joined" : "in pieces");
    const auto distances =
      DistancesFrom(check, surface, CutAlong(sphere, { 1.0, 0.3, 0.1 }, joined), false, what);
    const auto half = distances.begin() + sphere->GetNumberOfPoints();
    const auto isReached = [](double d) { return d < Infinity; };
    check.That(std::all_of(distances.begin(), half, isReached), what + ": the one is reached");
    check.That(std::none_of(half, distances.end(), isReached), what + ": the other is not");
  }
}

//------------------------------------------------------------------------------
/// A strip of width 1 and length 2.9, folded over at 2 so that it ends at 1.1; as (x, y) in space
/// and with the length along the strip.
struct FoldedStrip
{
  vtkSmartPointer<vtkPolyData> Surface;
  std::vector<double> Along;
};

FoldedStrip MakeFoldedStrip()
{
  constexpr int rows = 7;
  FoldedStrip strip;
  std::vector<Point> points;
  int columns = 0;
  for (; columns <= 13; ++columns)
  {
    const double along = columns <= 8 ? 0.25 * columns : 2.0 + 0.18 * (columns - 8);
    for (int j = 0; j <= rows; ++j)
    {
      points.push_back({ along <= 2.0 ? along : 4.0 - along, double(j) / rows, 0.0 });
      strip.Along.push_back(along);
    }
  }
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i + 1 < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      const vtkIdType a = i * (rows + 1) + j;
      InsertSquare(polys, Cells::Triangles, { a, a + rows + 1, a + rows + 2, a + 1 });
    }
  }
  strip.Surface = PointSources(points);
  strip.Surface->SetPolys(polys);
  return strip;
}

/// Unfolded, the section is two segments that meet in the fold, and distances are those of the
/// plane.
void CheckFoldedStrip(Check& check)
{
  const FoldedStrip strip = MakeFoldedStrip();
  const auto height = [](double x) { return 0.23 + 0.31 * x; };
  const Line line{ -0.31, 1.0, 0.23 };
  const Distance truth =
    DistanceTo({ { 0.0, height(0.0), 0.0 }, { 2.0, height(2.0), 0.0 }, { 2.9, height(1.1), 0.0 } });
  for (const bool joined : { true, false })
  {
    const std::string what =
      std::string("a folded strip, the section ") + (joined ? "joined" : "in pieces");
    const auto distances =
      DistancesFrom(check, strip.Surface, CutAlong(strip.Surface, line, joined), true, what);
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      const double y = strip.Surface->GetPoint(static_cast<vtkIdType>(i))[1];
      check.Near(distances[i], truth({ strip.Along[i], y, 0.0 }), 1e-12, what);
    }
  }
}

//------------------------------------------------------------------------------
/// Triangles that share no points and are not to be joined: each has its own part of the section.
void CheckSoup(Check& check)
{
  constexpr double height = 0.43;
  auto surface = Soup(Square(4));
  for (const bool joined : { true, false })
  {
    const std::string what =
      std::string("a soup of triangles, the section ") + (joined ? "joined" : "in pieces");
    const auto distances =
      DistancesFrom(check, surface, CutAlong(surface, { 0.0, 1.0, height }, joined), false, what);
    for (vtkIdType first = 0; first < surface->GetNumberOfPoints(); first += 3)
    {
      std::vector<Point> ends;
      for (vtkIdType k = 0; k < 3; ++k)
      {
        const Point p{ surface->GetPoint(first + k)[0], surface->GetPoint(first + k)[1], 0.0 };
        const vtkIdType next = first + (k + 1) % 3;
        const Point q{ surface->GetPoint(next)[0], surface->GetPoint(next)[1], 0.0 };
        if ((p[1] < height) != (q[1] < height))
        {
          const double t = (height - p[1]) / (q[1] - p[1]);
          ends.push_back({ p[0] + t * (q[0] - p[0]), height, 0.0 });
        }
      }
      for (vtkIdType k = 0; k < 3; ++k)
      {
        const Point p = PointAt(surface, first + k);
        check.Near(distances[static_cast<std::size_t>(first + k)],
          ends.empty() ? Infinity : DistanceToSegment(p, ends[0], ends[1]), 1e-12, what);
      }
    }
  }
}

}

int TestGeodesicTouching(int, char*[])
{
  Check check;
  CheckInvertedTriangle(check);
  CheckCoincidentSheets(check);
  CheckCoincidentPoints(check);
  CheckDoubledSphere(check);
  CheckFoldedStrip(check);
  CheckSoup(check);
  return check.Result();
}
