// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with cracks: points at one place that differ by roundings, as when each triangle is
// stored on its own. The truth is the surface without cracks, by the brute-force solver.
#include "CrackTesting.h"
#include "GeodesicTesting.h"

#include "vtkMultiBlockDataSet.h"

#include <cmath>
#include <limits>

using namespace GeodesicTesting;

namespace
{

/// Two squares beside each other; the second one's left side is at u.
vtkSmartPointer<vtkPolyData> TwoSquares(double u, int dataType, bool sharesCorner = false)
{
  return Mesh({ { 0, 0, 0 }, { .5, 0, 0 }, { .5, 1, 0 }, { 0, 1, 0 }, { u, 0, 0 }, { 1, 0, 0 },
                { 1, 1, 0 }, { sharesCorner ? .5 : u, 1, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 } }, dataType);
}

/// Measures from the first corner of the two squares.
std::vector<double> Measure(Check& check, vtkGeodesicDistanceField* filter, vtkDataObject* surface,
  std::string* warning = nullptr)
{
  filter->RefineMeshOff();
  filter->SetInputDataObject(surface);
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), messages.Error());
  if (warning)
  {
    *warning = messages.Warning();
  }
  else
  {
    check.That(messages.Warning().empty(), "no warning: " + messages.Warning());
  }
  std::vector<double> values;
  vtkDataArray* distances = surface->IsA("vtkPolyData") ? Distances(filter) : nullptr;
  for (vtkIdType i = 0; distances && i < distances->GetNumberOfTuples(); ++i)
  {
    values.push_back(distances->GetTuple1(i));
  }
  return values;
}

void CheckClosed(Check& check, vtkPolyData* surface, vtkIdType joined, const std::string& what)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  const std::vector<double> values = Measure(check, filter, surface);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const Point p = PointAt(surface, static_cast<vtkIdType>(i));
    check.Near(values[i], std::hypot(p[0], p[1]), 1e-6,
      what + ": distance of point " + std::to_string(i) + " is");
  }
  check.Equal(filter->GetSeamPointsJoined(), joined, what + ": joined points");
}

void CheckTwoSquares(Check& check)
{
  const double single = std::nextafterf(.5F, 1.F);
  const double twice = std::nextafter(std::nextafter(.5, 1.), 1.);
  CheckClosed(check, TwoSquares(single, VTK_FLOAT), 2, "single precision");
  CheckClosed(check, TwoSquares(single, VTK_DOUBLE), 2, "single precision, stored as double");
  CheckClosed(check, TwoSquares(twice, VTK_DOUBLE), 2, "double precision");
  CheckClosed(check, TwoSquares(single, VTK_FLOAT, true), 1, "a shared corner");

  // As two blocks.
  const auto whole = TwoSquares(single, VTK_FLOAT);
  const auto blocks = Blocks({ Part(whole, { 0, 1 }), Part(whole, { 2, 3 }) });
  vtkNew<vtkGeodesicDistanceField> filter;
  Measure(check, filter, blocks);
  check.Equal(filter->GetSeamPointsJoined(), 2.0, "joined points of blocks");
  const auto leaves = LeavesOf(filter->GetOutputDataObject(0));
  check.Near(PointValue(leaves.at(1), "GeodesicDistance", 2), std::sqrt(2.0), 1e-6,
    "distance in the second block");
}

/// What is wider than roundings stays open, with a warning, unless the user closes it.
void CheckWiderCracks(Check& check)
{
  constexpr double width = 1e-7;
  const auto surface = TwoSquares(.5 + width, VTK_DOUBLE);
  vtkNew<vtkGeodesicDistanceField> filter;
  std::string warning;
  std::vector<double> values = Measure(check, filter, surface, &warning);
  check.Equal(values.at(5), std::numeric_limits<double>::infinity(), "behind an open crack");
  CheckWords(check, warning, { "2 boundary edges", "1e-07 apart", "MergeTolerance" },
    "the warning of a crack");
  filter->SetMergeTolerance(0.9 * width);
  check.Equal(Measure(check, filter, surface, &warning).at(5),
    std::numeric_limits<double>::infinity(), "a tolerance below the crack's width");
  filter->SetMergeTolerance(1.1 * width);
  values = Measure(check, filter, surface);
  check.Near(values.at(5), 1.0, 1e-6, "a tolerance above the crack's width");
  filter->MergeCoincidentPointsOff();
  check.Equal(Measure(check, filter, surface).at(5), std::numeric_limits<double>::infinity(),
    "without merging nothing is joined, and nothing said");
  filter->MergeCoincidentPointsOn();
  filter->SetMergeTolerance(10.0);
  values = Measure(check, filter, surface);
  check.Near(values.at(6), std::hypot(1.0, 1.0), 1e-6,
    "a tolerance that is longer than the edges collapses none");
  for (const double wrong : { -1.0, std::nan("") })
  {
    filter->SetMergeTolerance(wrong);
    Messages(filter).ExpectError(check, { "MergeTolerance" }, "a wrong tolerance is an error");
  }
}

/// A point of one side lies on an edge of the other: no points to join, but a warning.
void CheckHangingPoint(Check& check)
{
  const auto surface =
    Mesh({ { 0, 0, 0 }, { .5, 0, 0 }, { .5, 1, 0 }, { .5, .4, 0 }, { 1, 0, 0 }, { 1, 1, 0 } },
      { { 0, 1, 2 }, { 1, 4, 3 }, { 3, 4, 5 }, { 3, 5, 2 } });
  vtkNew<vtkGeodesicDistanceField> filter;
  std::string warning;
  Measure(check, filter, surface, &warning);
  check.That(Contains(warning, "3 boundary edges"), "a point on an edge is a crack: " + warning);
}

/// Inner points are not joined however near they are, nor points whose edges are as short as the
/// roundings.
void CheckLeftAlone(Check& check)
{
  auto ball = ChangedSphere(12, 12, [](const Point& p) { return p; });
  auto other = ChangedSphere(12, 12,
    [](const Point& p) {
      return Point{ p[0] + 4e-16, p[1], std::nextafter(p[2], 2.0) };
    });
  auto both = Mesh({}, {});
  Append(both, ball);
  Append(both, other);
  // Faces with different orientations: an inner edge is none of the boundary there, either.
  auto polygons = CellsOf(both->GetPolys());
  for (std::size_t face = 0; face < polygons.size(); face += 3)
  {
    std::swap(polygons[face][1], polygons[face][2]);
  }
  both->SetPolys(CellArrayOf(polygons));
  const auto filter = PlainField(both, PointSources({ { 0, 0, .5 } }));
  filter->Update();
  check.Equal(filter->GetSeamPointsJoined(), 0.0, "two closed surfaces in one place");

  // A strip whose squares are two roundings of single precision wide.
  constexpr double far = 1 << 22;
  auto strip = Square(8, Cells::Triangles, VTK_FLOAT);
  MovePoints(strip, [](const Point& p) { return Point{ far + 8 * p[0], far + 8 * p[1], 0.0 }; });
  filter->SetInputData(strip);
  filter->SetSourceData(PointSources({ { far, far, 0.0 } }));
  filter->Update();
  check.Equal(filter->GetSeamPointsJoined(), 0.0, "edges as short as roundings");
  CheckDistances(
    check, filter, [](const Point& p) { return std::hypot(p[0] - far, p[1] - far); },
    "edges as short as roundings");
}

/// Random surfaces in pieces that were stored separately, whole again.
void CheckRandom(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(60);
  double worst = 0.0;
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    const Cracked cracked = MakeCracked(seed);
    const std::string what = "seed " + std::to_string(seed) + ", " + cracked.Name;
    worst = std::max(worst, CheckClosed(check, cracked, cracked.Surface, what));
  }
  std::cout << "random cracks: worst error " << worst << " of what roundings explain\n";
}

}

int TestGeodesicCracks(int, char*[])
{
  Check check;
  CheckTwoSquares(check);
  CheckWiderCracks(check);
  CheckHangingPoint(check);
  CheckLeftAlone(check);
  CheckRandom(check);
  return check.Result();
}
