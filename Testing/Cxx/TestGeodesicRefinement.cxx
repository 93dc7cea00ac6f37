// SPDX-License-Identifier: BSD-3-Clause
// The refined surface is the input's, without gaps, and its linear interpolant is as near to the
// distance as the filter says, which is what was asked for.
#include "GeodesicTesting.h"

#include "vtkCellData.h"

#include <map>
#include <random>
#include <set>
#include <sstream>

using namespace GeodesicTesting;

namespace
{

const std::vector<Point> Line = { { 0.1, 0.2, 0 }, { 0.7, 0.35, 0 }, { 0.65, 0.9, 0 } };

/// Twice the area of a triangle in the plane z = 0, with its sign.
double Area(const Point& a, const Point& b, const Point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

vtkDataArray* Originals(vtkGeodesicDistanceField* filter)
{
  return filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds");
}

/// The largest difference between the interpolant and the truth at random points of each triangle
/// with a corner within the limit.
double MeasuredError(vtkGeodesicDistanceField* filter, const Distance& truth, double limit)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* distances = Distances(filter);
  double worst = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfPolys(); ++cell)
  {
    const auto ids = IdsOf(output->GetPolys(), cell);
    const auto corners = CornersOf(output, cell);
    if (std::min({ truth(corners[0]), truth(corners[1]), truth(corners[2]) }) > limit)
    {
      continue;
    }
    for (int i = 0; i < 20; ++i)
    {
      const double u = unit(random);
      const double v = unit(random) * (1.0 - u);
      const std::array<double, 3> weights = { 1.0 - u - v, u, i % 4 == 0 ? 0.0 : v };
      const double sum = weights[0] + weights[1] + weights[2];
      Point p = { 0, 0, 0 };
      double interpolated = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        interpolated += weights[k] / sum * distances->GetTuple1(ids[k]);
        for (std::size_t j = 0; j < 3; ++j)
        {
          p[j] += weights[k] / sum * corners[k][j];
        }
      }
      worst =
        std::isfinite(interpolated) ? std::max(worst, std::abs(interpolated - truth(p))) : worst;
    }
  }
  return worst;
}

void CheckBounds(Check& check, vtkGeodesicDistanceField* filter, const Distance& truth,
  double tolerance, const std::string& what, double limit = VTK_DOUBLE_MAX)
{
  const double measured = MeasuredError(filter, truth, limit);
  const double reported = filter->GetInterpolationErrorBound();
  std::cout << what << ": " << filter->GetOutput()->GetNumberOfCells() << " triangles, measured "
            << measured << ", reported " << reported << ", requested " << tolerance << "\n";
  check.That(measured <= reported * (1.0 + 1e-9), what + ": the measured error is below the bound");
  check.That(reported <= tolerance, what + ": the bound is below the tolerance");
  check.Equal(
    filter->GetOutput()->GetFieldData()->GetArray("InterpolationErrorBound")->GetTuple1(0),
    reported, what + ": the array of the bound");
}

/// Numbers of triangles at each edge, by the places of its ends.
std::map<std::pair<Point, Point>, int> Edges(vtkPolyData* data)
{
  std::map<std::pair<Point, Point>, int> edges;
  for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
  {
    const auto corners = CornersOf(data, cell);
    for (std::size_t k = 0; k < 3; ++k)
    {
      ++edges[std::minmax(corners[k], corners[(k + 1) % 3])];
    }
  }
  return edges;
}

/// On a square every edge has two triangles, or one and lies on the boundary.
void CheckSquareIsWhole(Check& check, vtkPolyData* output, const std::string& what)
{
  for (const auto& [edge, count] : Edges(output))
  {
    const Point middle = { 0.5 * (edge.first[0] + edge.second[0]),
      0.5 * (edge.first[1] + edge.second[1]), 0.0 };
    const bool boundary = DistanceToBoundaryOfSquare(middle) == 0.0;
    check.That(count == (boundary ? 1 : 2), what + ": no gap at an edge");
  }
}

void CheckClosedIsWhole(Check& check)
{
  const auto filter = RefinedField(Tetrahedron(), PointSources({ { 0.2, 0.3, 0 } }));
  filter->Update();
  check.That(filter->GetOutput()->GetNumberOfCells() > 100, "a tetrahedron is refined");
  for (const auto& edge : Edges(filter->GetOutput()))
  {
    check.Equal(edge.second, 2, "triangles at an edge of a closed surface");
  }
}

/// The input's points come first and unchanged; each triangle lies in its original cell, turned as
/// that, and together they fill it.
void CheckGeometry(
  Check& check, vtkGeodesicDistanceField* filter, vtkPolyData* input, const std::string& what)
{
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* originals = Originals(filter);
  if (!originals || originals->GetNumberOfTuples() != output->GetNumberOfCells())
  {
    check.That(false, what + ": an original cell for each");
    return;
  }
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    check.That(PointAt(output, i) == PointAt(input, i), what + ": the input's points");
  }
  std::vector<double> filled(static_cast<std::size_t>(input->GetNumberOfPolys()), 0.0);
  vtkIdType last = 0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const auto original = static_cast<vtkIdType>(originals->GetTuple1(cell));
    check.That(original >= last, what + ": the parts of cells in the order of the cells");
    last = original;
    const auto outer = CornersOf(input, original);
    const auto inner = CornersOf(output, cell);
    const double area = Area(outer[0], outer[1], outer[2]);
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (const Point& p : inner)
      {
        check.That(
          Area(outer[k], outer[(k + 1) % 3], p) / area > -1e-12, what + ": inside its cell");
      }
    }
    const double part = Area(inner[0], inner[1], inner[2]) / area;
    check.That(part > 0.0, what + ": turned like its cell");
    filled[static_cast<std::size_t>(original)] += part;
  }
  for (const double sum : filled)
  {
    check.Near(sum, 1.0, 1e-4, what + ": the parts fill their cell");
  }
}

void CheckTolerances(Check& check, int dataType)
{
  const std::string name = dataType == VTK_FLOAT ? "32 bits, " : "64 bits, ";
  auto surface = Square(8, Cells::Triangles, dataType);
  const auto filter = RefinedField(surface, Polyline(Line));
  const double diagonal = std::sqrt(2.0);
  vtkIdType before = 0;
  for (const double tolerance : { 1e-2, 1e-3, 1e-4 })
  {
    const std::string what = name + std::to_string(tolerance);
    filter->SetRefinementTolerance(tolerance);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    check.Equal(output->GetPoints()->GetDataType(), VTK_DOUBLE, what + ": type of the points");
    check.That(output->GetNumberOfCells() > before, what + ": more triangles");
    before = output->GetNumberOfCells();
    CheckBounds(check, filter, DistanceTo(Line), tolerance * diagonal, what);
    CheckDistances(check, filter, DistanceTo(Line), what);
    CheckGeometry(check, filter, surface, what);
    CheckSquareIsWhole(check, output, what);
  }

  // The same in the surface's own units.
  filter->ToleranceIsAbsoluteOn();
  filter->SetAbsoluteRefinementTolerance(1e-4 * diagonal);
  filter->Update();
  check.Equal(
    filter->GetOutput()->GetNumberOfCells(), before, name + "triangles with an absolute tolerance");
}

/// What linear interpolation misses most: sources strictly inside one face, the only local maximum
/// strictly inside another.
void CheckInsideOfFaces(Check& check)
{
  const Point source = { 0.6, 0.3, 0 };
  const auto filter = RefinedField(Square(1), PointSources({ source }));
  filter->Update();
  CheckBounds(check, filter, DistanceTo({ source }), 1e-3 * std::sqrt(2.0), "a point in a face");
  const std::vector<Point> segment = { source, { 0.7, 0.31, 0 } };
  filter->SetSourceData(Polyline(segment));
  filter->Update();
  CheckBounds(check, filter, DistanceTo(segment), 1e-3 * std::sqrt(2.0), "a segment in a face");
  filter->SetSourceTypeToSurfaceBoundary();
  filter->Update();
  CheckBounds(
    check, filter, DistanceToBoundaryOfSquare, 1e-3 * std::sqrt(2.0), "the ridges of a square");
}

void CheckNothingToRefine(Check& check)
{
  const auto filter = RefinedField(Square(4), Polyline({ { 0, 0, 0 }, { 0, 1, 0 } }));
  filter->Update();
  check.Equal(
    filter->GetOutput()->GetNumberOfCells(), 32.0, "triangles where the distance is linear");
  check.That(filter->GetInterpolationErrorBound() < 1e-9, "its bound");
  check.That(Originals(filter) != nullptr, "its original cells");

  filter->RefineMeshOff();
  filter->Update();
  check.That(!Originals(filter), "no original cells without refinement");
  check.That(std::isinf(filter->GetInterpolationErrorBound()), "no bound without refinement");
}

/// Where several points are at one place, each face keeps its own, also on split edges.
void CheckSeams(Check& check)
{
  auto soup = Soup(Square(4));
  const auto filter = RefinedField(soup, Polyline(Line));
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  CheckBounds(check, filter, DistanceTo(Line), 1e-3 * std::sqrt(2.0), "soup");
  CheckDistances(check, filter, DistanceTo(Line), "soup");
  CheckGeometry(check, filter, soup, "soup");
  CheckSquareIsWhole(check, output, "soup");

  std::map<vtkIdType, std::set<vtkIdType>> cellsOfPoint;
  std::map<vtkIdType, std::set<vtkIdType>> pointsOfCell;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const auto original = static_cast<vtkIdType>(Originals(filter)->GetTuple1(cell));
    for (const vtkIdType point : IdsOf(output->GetPolys(), cell))
    {
      cellsOfPoint[point].insert(original);
      pointsOfCell[original].insert(point);
    }
  }
  check.Equal(cellsOfPoint.size(), output->GetNumberOfPoints(), "soup: points that are used");
  for (const auto& [point, cells] : cellsOfPoint)
  {
    check.Equal(cells.size(), 1.0, "soup: cells of a point");
  }
  for (const auto& [cell, points] : pointsOfCell)
  {
    std::set<Point> places;
    for (const vtkIdType point : points)
    {
      places.insert(PointAt(output, point));
    }
    check.Equal(places.size(), points.size(), "soup: places of a cell's points");
  }
}

/// Triangles of each original cell as the places of their corners.
std::map<vtkIdType, std::multiset<std::set<Point>>> Parts(vtkGeodesicDistanceField* filter)
{
  std::map<vtkIdType, std::multiset<std::set<Point>>> parts;
  for (vtkIdType cell = 0; cell < filter->GetOutput()->GetNumberOfCells(); ++cell)
  {
    const auto corners = CornersOf(filter->GetOutput(), cell);
    parts[static_cast<vtkIdType>(Originals(filter)->GetTuple1(cell))].insert(
      { corners.begin(), corners.end() });
  }
  return parts;
}

/// A face on the points of another has its parts; with points of its own, too. No point is there
/// twice for one face.
void CheckDuplicateFaces(Check& check, bool soup)
{
  const std::string what = soup ? "duplicates with their own points" : "duplicates";
  auto surface = Square(2);
  surface->GetPolys()->InsertNextCell({ 4, 1, 0 }); // face 0, turned over
  surface->GetPolys()->InsertNextCell({ 8, 4, 5 }); // face 6, its corners turned round
  surface = soup ? Soup(surface) : surface;
  const auto filter = RefinedField(surface, Polyline(Line));
  Messages messages(filter);
  messages.ExpectNoError(check, what);
  auto parts = Parts(filter);
  check.That(parts[0].size() > 4 && parts[0] == parts[8], what + ": one turned over");
  check.That(parts[6].size() > 4 && parts[6] == parts[9], what + ": one turned round");
  CheckGeometry(check, filter, surface, what);
  CheckDistances(check, filter, DistanceTo(Line), what);

  vtkPolyData* output = filter->GetOutput();
  std::set<vtkIdType> used;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const auto corners = IdsOf(output->GetPolys(), cell);
    used.insert(corners.begin(), corners.end());
  }
  check.Equal(used.size(), output->GetNumberOfPoints(), what + ": points that are used");

  // As many as the surface has without duplicates, and they do not fit in any more.
  const auto most = static_cast<vtkIdType>(
    static_cast<std::size_t>(output->GetNumberOfCells()) - parts[8].size() - parts[9].size() + 2);
  filter->SetMaximumNumberOfCells(most);
  messages.Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), most,
    what + ": triangles when the duplicates stay whole");
  parts = Parts(filter);
  check.That(parts[8].size() == 1 && parts[9].size() == 1, what + ": they stay whole");
}

void CheckLimit(Check& check)
{
  auto surface = Square(16);
  const double limit = 0.2;
  const auto filter = RefinedField(surface, Polyline(Line));
  filter->SetMaximumDistance(limit);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  CheckBounds(check, filter, DistanceTo(Line), 1e-3 * std::sqrt(2.0), "with a limit", limit);
  CheckGeometry(check, filter, surface, "with a limit");
  CheckSquareIsWhole(check, output, "with a limit");
  vtkIdType beyond = 0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    double nearest = VTK_DOUBLE_MAX;
    double farthest = 0.0;
    for (const vtkIdType point : IdsOf(output->GetPolys(), cell))
    {
      nearest = std::min(nearest, DistanceTo(Line)(PointAt(output, point)));
      farthest = std::max(farthest, Distances(filter)->GetTuple1(point));
    }
    check.That(nearest > limit || std::isfinite(farthest), "each triangle in the limit is reached");
    beyond += std::isfinite(farthest) ? 0 : 1;
  }
  check.That(beyond > 50, "triangles beyond the limit stay");
}

void CheckCap(Check& check)
{
  const auto filter = RefinedField(Square(8), Polyline(Line));
  Messages messages(filter);
  filter->SetRefinementTolerance(1e-12);
  filter->SetMaximumNumberOfCells(3000);
  messages.Update();
  std::cout << messages.Warning();
  const auto count = static_cast<double>(filter->GetOutput()->GetNumberOfCells());
  check.That(count <= 3000 && count > 2900, "the cap is used, and kept");
  check.That(Contains(messages.Warning(), "MaximumNumberOfCells (3000) is reached"),
    "a warning that the cap is reached");
  std::ostringstream met;
  met << "meets a tolerance of " << filter->GetInterpolationErrorBound() << " instead of";
  check.That(
    Contains(messages.Warning(), met.str()), "the warning names the tolerance that is met");
  CheckSquareIsWhole(check, filter->GetOutput(), "at the cap");
  CheckBounds(check, filter, DistanceTo(Line), 0.01, "at the cap");

  filter->SetRefinementTolerance(0.01);
  messages.ExpectNoWarning(check, "no warning below the cap");
  filter->SetMaximumNumberOfCells(0);
  messages.ExpectNoWarning(check, "no warning without a cap");

  filter->SetMaximumNumberOfCells(127);
  messages.Update();
  std::cout << messages.Warning();
  check.That(Contains(messages.Warning(), "128 triangles") && Contains(messages.Warning(), "(127)"),
    "a warning that the input is over the cap");
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 128.0, "triangles of an input over the cap");
  check.That(std::isinf(filter->GetInterpolationErrorBound()), "its bound");
  CheckDistances(check, filter, DistanceTo(Line), "an input over the cap");
  filter->SetMaximumNumberOfCells(128);
  messages.Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 128.0, "triangles of an input at the cap");
  check.That(Contains(messages.Warning(), "is reached"), "an input at the cap");
}

// Merging wide windows would change the distance by more than the tolerance.
void CheckApproximate(Check& check)
{
  const auto filter = RefinedField(Square(8), Polyline({ { 0.33, 0.41, 0 } }));
  filter->SetAccuracy(vtkGeodesicDistanceField::APPROXIMATE);
  Messages messages(filter);
  for (const double epsilon : { 1e-3, 1e-2, 1e-1 })
  {
    filter->SetRelativeError(epsilon);
    messages.Update();
    const std::string what = "approximate, " + std::to_string(epsilon);
    check.That(messages.Warning().empty(), what + ": no warning, " + messages.Warning());
    check.That(filter->GetInterpolationErrorBound() <= 1e-3 * std::sqrt(2.0),
      what + ": the tolerance is met, " + std::to_string(filter->GetInterpolationErrorBound()));
    CheckSquareIsWhole(check, filter->GetOutput(), what);
  }
}

}

int TestGeodesicRefinement(int, char*[])
{
  Check check;
  CheckTolerances(check, VTK_DOUBLE);
  CheckTolerances(check, VTK_FLOAT);
  CheckInsideOfFaces(check);
  CheckNothingToRefine(check);
  CheckClosedIsWhole(check);
  CheckSeams(check);
  CheckDuplicateFaces(check, false);
  CheckDuplicateFaces(check, true);
  CheckLimit(check);
  CheckCap(check);
  CheckApproximate(check);
  return check.Result();
}
