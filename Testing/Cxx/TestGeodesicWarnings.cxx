// SPDX-License-Identifier: BSD-3-Clause
// What the filter keeps working with but the user should know is counted in a warning, once; what
// every data set may have is not mentioned.
#include "GeodesicTesting.h"

#include "vtkDoubleArray.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTrivialProducer.h"

using namespace GeodesicTesting;

namespace
{

vtkSmartPointer<vtkPolyData> WithFaces(
  vtkSmartPointer<vtkPolyData> data, const std::vector<std::array<vtkIdType, 3>>& faces)
{
  for (const auto& face : faces)
  {
    data->GetPolys()->InsertNextCell(3, face.data());
  }
  return data;
}

vtkSmartPointer<vtkPolyData> WithPoints(vtkSmartPointer<vtkPolyData> data, int count)
{
  for (int i = 0; i < count; ++i)
  {
    data->GetPoints()->InsertNextPoint(5.0 + i, 0.0, 0.0);
  }
  return data;
}

vtkSmartPointer<vtkPolyData> WithLinesAndVertices(vtkSmartPointer<vtkPolyData> data)
{
  data->SetLines(CellArray({ { 0, 1 }, { 1, 2, 3 } }));
  data->SetVerts(CellArray({ { 0 }, { 1 }, { 2 } }));
  return data;
}

vtkSmartPointer<vtkPolyData> WithPolygon(vtkSmartPointer<vtkPolyData> data)
{
  // A pentagon on the square's lower side, not convex.
  vtkPoints* points = data->GetPoints();
  const vtkIdType first = points->InsertNextPoint(0.0, -1.0, 0.0);
  points->InsertNextPoint(0.5, -0.5, 0.0);
  points->InsertNextPoint(1.0, -1.0, 0.0);
  data->GetPolys()->InsertNextCell({ 0, first, first + 1, first + 2, 1 });
  return data;
}

/// Two polygons beside the square that cross themselves: a bow tie of a large and a small
/// triangle, and a pentagram.
vtkSmartPointer<vtkPolyData> WithCrossingPolygons(vtkSmartPointer<vtkPolyData> data)
{
  const auto add = [&](const std::vector<Point>& outline)
  {
    std::vector<vtkIdType> ids;
    for (const Point& p : outline)
    {
      ids.push_back(data->GetPoints()->InsertNextPoint(p.data()));
    }
    data->GetPolys()->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  };
  add({ { 5, 0, 0 }, { 6, 1, 0 }, { 6, 0, 0 }, { 5, 2, 0 } });
  add({ { 9, 0, 0 }, { 10, 3, 0 }, { 11, 0, 0 }, { 8, 2, 0 }, { 12, 2, 0 } });
  return data;
}

std::vector<Case> Cases()
{
  const Point origin = { 0, 0, 0 };
  const auto corner = PointSources({ origin });
  return {
    { "lines", WithLinesAndVertices(Square(2)), corner,
      { "2 lines among the surface's cells dropped" } },
    { "vertices", WithLinesAndVertices(Square(2)), corner,
      { "3 vertex cells among the surface's cells dropped" } },
    { "faces a,a,b", WithFaces(Square(2), { { 0, 0, 1 }, { 3, 4, 3 } }), corner,
      { "2 faces with two corners at one point left out" } },
    { "polygons that cross themselves", WithCrossingPolygons(Square(2)), corner,
      { "2 polygons of the surface with an outline that crosses itself, first cell 8: cut",
        "Repair" } },
    { "a point far from the surface", Square(2), PointSources({ { 0, 0, 0.75 } }),
      { "up to 0.75 away from the surface (53 % of its size), at 1 of 1 points: point 0." } },
    { "a curve far from the surface", Square(2),
      Polyline({ origin, { 0.5, 0, 0.25 }, { 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.01 } }),
      { "up to 0.5 away from the surface (35 % of its size)", "at 2 of 4 points",
        "point 1 of cell 0, point 2 of cell 0." } },
    { "many points far from the surface", Square(2),
      PointSources({ origin, { 0, 0, 1 }, { 0, 0, 2 }, { 0, 0, 3 }, { 0, 0, 4 }, { 0, 0, 5 } }),
      { "up to 5 away", "at 5 of 6 points: point 1, point 2, point 3 and 2 more." } },
  };
}

/// Nothing is wrong with these.
std::vector<Case> QuietCases()
{
  const Point origin = { 0, 0, 0 };
  const auto corner = PointSources({ origin });
  const std::vector<Point> ring = { { 0.2, 0.2, 0 }, { 0.8, 0.2, 0 }, { 0.5, 0.8, 0 } };
  std::vector<Point> ringAgain = ring;
  ringAgain.push_back(ring.front());
  return {
    { "points", Square(2), PointSources({ origin, { 0.3, 0.4, 0 } }), {} },
    { "quads", Square(2, Cells::Quads), corner, {} },
    { "a polygon", WithPolygon(Square(1)), corner, {} },
    { "strips", Square(2, Cells::Strips), corner, {} },
    { "a duplicate face", WithFaces(Square(2), { { 1, 4, 0 } }), corner, {} },
    { "a face without area", WithFaces(Square(2), { { 0, 1, 2 } }), corner, {} },
    { "unused points", WithPoints(Square(2), 3), corner, {} },
    { "repeated curve points", Square(2),
      Polyline({ origin, origin, { 0.5, 0, 0 }, { 0.5, 0, 0 }, { 1, 0, 0 } }), {} },
    { "a closed curve", Square(2), Polyline(ring, true), {} },
    { "a closed curve with its first point twice", Square(2), Polyline(ringAgain), {} },
    { "a curve a little beside the surface", Square(2),
      Polyline({ { 0.1, 0.1, 0.014 }, { 0.9, 0.1, -0.014 } }), {} },
  };
}

void CheckCase(Check& check, const Case& odd)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(check, filter, messages, odd);
  check.That(messages.Error().empty(), odd.Name + " is no error: " + messages.Error());
  CheckWords(check, odd, messages.Warning());
  const double reached = Distances(filter) ? Distances(filter)->GetTuple1(8) : -1.0;
  check.That(odd.Source->GetNumberOfPoints() > 1 || std::abs(reached - std::sqrt(2.0)) < 1e-15,
    odd.Name + ": the distance to the opposite corner");
}

void CheckQuietCase(Check& check, const Case& plain)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  Run(check, filter, messages, plain);
  check.That(messages.Error().empty() && messages.Warning().empty(),
    plain.Name + " is not worth a word: " + messages.Error() + messages.Warning());
  check.That(Distances(filter) && std::isfinite(Distances(filter)->GetTuple1(8)),
    plain.Name + ": there is a distance");
}

void CheckExistingArray(Check& check)
{
  auto surface = Square(2);
  vtkNew<vtkDoubleArray> mine;
  mine->SetName("GeodesicDistance");
  mine->SetNumberOfTuples(surface->GetNumberOfPoints());
  mine->Fill(-7.0);
  surface->GetPointData()->AddArray(mine);
  const auto filter = RefinedField(surface, PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  messages.ExpectWarning(
    check, { "already has a point array named GeodesicDistance" }, "an existing array is told");
  CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "beside an existing array");
  check.That(surface->GetPointData()->GetArray("GeodesicDistance") == mine.Get(),
    "the input keeps its array");
  check.Equal(mine->GetValue(4), -7.0, "a value of the input's array");

  filter->SetDistanceArrayName("Other");
  filter->RefineMeshOff();
  messages.ExpectNoWarning(check, "no warning with another name");
  check.That(filter->GetOutput()->GetPointData()->GetArray("GeodesicDistance") == mine.Get(),
    "the output passes the input's array on");
}

/// What was noticed of the surface is told with the first execution that gives a result.
void CheckWarningsAfterFailure(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(WithLinesAndVertices(Square(2)));
  Messages messages(filter);
  messages.ExpectError(check, { "no source" }, "the first execution fails");
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  messages.ExpectWarning(check, { "2 lines among the surface's cells" },
    "after a failed execution the surface's warnings are told");
  filter->SetSourceData(PointSources({ { 1, 0, 0 } }));
  messages.ExpectNoWarning(check, "they are told once");
}

/// As with time steps: what is connected stays, its data change.
void CheckNothingIsSaidTwice(Check& check)
{
  vtkNew<vtkTrivialProducer> surface;
  vtkNew<vtkTrivialProducer> source;
  surface->SetOutput(WithLinesAndVertices(Square(2)));
  source->SetOutput(PointSources({ { 0, 0, 0.5 } }));
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputConnection(surface->GetOutputPort());
  filter->SetSourceConnection(source->GetOutputPort());
  Messages messages(filter);
  const auto expect = [&](bool ofSurface, bool ofSource, const std::string& what)
  {
    messages.Update();
    const std::string said = messages.Warning();
    check.That(Contains(said, "2 lines") == ofSurface && Contains(said, "away") == ofSource &&
        said.empty() == !(ofSurface || ofSource),
      what + ": " + said);
  };
  expect(true, true, "the first time step");
  check.That(messages.Warning().find("away") < messages.Warning().find("2 lines"),
    "a source far away comes first: " + messages.Warning());
  source->SetOutput(PointSources({ { 0, 0, 0.75 } }));
  expect(false, false, "a source that moves, farther off");
  surface->SetOutput(WithLinesAndVertices(Square(4)));
  expect(false, false, "a surface that changes");
  filter->SetRefinementTolerance(0.01);
  expect(false, false, "another property");
  source->SetOutput(PointSources({ { 0, 0, 0 } }));
  expect(false, false, "a source on the surface");
  source->SetOutput(PointSources({ { 0, 0, 0.75 } }));
  expect(false, true, "a source that moves off again");

  filter->SetMaximumDistance(-1.0);
  messages.Update();
  filter->SetMaximumDistance(0.0);
  expect(false, false, "after an error in between");
  vtkNew<vtkTrivialProducer> other;
  other->SetOutput(PointSources({ { 0, 0, 0.75 } }));
  filter->SetSourceConnection(other->GetOutputPort());
  expect(false, true, "another source connected");
  filter->SetInputData(WithLinesAndVertices(Square(2)));
  expect(true, false, "another surface connected");
}

/// Targets are warned of as sources are, in both filters, and not again where they are the points
/// of a source of which that was said.
template <typename Filter>
void CheckFarTargets(Check& check, const std::string& name)
{
  vtkNew<Filter> filter;
  filter->SetInputData(Square(2));
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  const auto expect = [&](const std::string& words, const std::string& what)
  {
    messages.Update();
    check.That(words.empty() == messages.Warning().empty() && Contains(messages.Warning(), words),
      name + ", " + what + ": " + messages.Warning());
  };
  filter->SetTargetsData(PointSources({ { 1, 1, 0 }, { 0.5, 0.5, 8 }, { 0, 0, 0.01 } }));
  expect("The targets are up to 8 away from the surface (566 % of its size), at 1 of 3 points: "
         "point 1. Do they belong to this surface?",
    "a target far away");
  filter->Modified();
  expect("", "the same again");
  const auto blocks = Blocks({ PointSources({ { 1, 1, 0 } }) });
  blocks->SetBlock(
    1, PointSources({ { 0, 0, 1 }, { 0, 0, 0 }, { 0, 0, 2 }, { 0, 0, 3 }, { 0, 0, 1 } }));
  filter->SetTargetsData(blocks);
  expect("at 4 of 6 points: point 0 of block 2, point 2 of block 2, point 3 of block 2 and 1 more",
    "blocks of targets");
  filter->SetTargetsData(PointSources({ { 1, 1, 0.014 }, { 0, 0, -0.014 } }));
  expect("", "targets a little beside the surface");
}

void CheckFarPointsOfSourceAsTargets(Check& check)
{
  const auto matrix =
    FilterOn<vtkGeodesicDistanceMatrix>(Square(2), PointSources({ { 0, 0, 1 }, { 1, 0, 0 } }));
  Messages messages(matrix);
  messages.Update();
  check.That(Contains(messages.Warning(), "The source is up to 1 away") &&
      !Contains(messages.Warning(), "targets"),
    "a source that is the targets too: " + messages.Warning());
  matrix->SetSourceData(PointSources({ { 0, 0, 1 }, { 1, 0, 0 } }));
  matrix->SetSourceTypeToSurfaceBoundary();
  messages.ExpectWarning(
    check, { "The targets are up to 1 away" }, "a source that is the targets only");
  const auto blocks =
    Blocks({ PointSources({ { 1, 0, 0 } }), PointSources({ { 1, 0, 0 }, { 0, 0, 1 } }) });
  matrix->SetSourceData(blocks);
  messages.ExpectWarning(check, { "at 1 of 3 points: point 1 of block 2." },
    "blocks of a source that are the targets only");
}

/// What a property is the cause of is told for each of its values.
void CheckWarningsOfProperties(Check& check)
{
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(PointSources({ { 0, 0, 0 } }));
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Square(4));
  filter->SetSourceConnection(source->GetOutputPort());
  filter->SetMaximumNumberOfCells(10);
  Messages messages(filter);
  const auto expect = [&](const std::string& words, const std::string& what)
  {
    messages.Update();
    check.That(words.empty() == messages.Warning().empty() && Contains(messages.Warning(), words),
      what + ": " + messages.Warning());
  };
  expect("more than MaximumNumberOfCells (10)", "a surface that is not refined");
  source->SetOutput(PointSources({ { 1, 0, 0 } }));
  expect("", "at the next time step");
  filter->SetMaximumNumberOfCells(40);
  expect("MaximumNumberOfCells (40) is reached", "a cap that is reached");
  source->SetOutput(PointSources({ { 1, 1, 0 } }));
  expect("", "at the next time step");
  filter->SetMaximumNumberOfCells(45);
  expect("MaximumNumberOfCells (45) is reached", "another cap");
}

/// Lengths are fractions of the extent of the surface, to which points that no face uses do not
/// belong.
void CheckUnusedPointsDoNotCount(Check& check)
{
  auto surface = Square(10);
  surface->GetPoints()->InsertNextPoint(1e4, 0.0, 0.0);
  const auto filter = RefinedField(surface, PointSources({ { 0, 0, 0.1 } }));
  Messages(filter).ExpectWarning(
    check, { "up to 0.1 away from the surface" }, "beside an unused point a far source is far");
  check.That(filter->GetInterpolationErrorBound() <= 0.001 * std::sqrt(2.0),
    "beside an unused point the surface is refined: to " +
      std::to_string(filter->GetInterpolationErrorBound()));
}

/// A plate of n x n squares with two sides, joined at its edges.
vtkSmartPointer<vtkPolyData> Plate(int n, double thickness)
{
  auto plate = Square(n);
  const vtkIdType count = plate->GetNumberOfPoints();
  const vtkIdType faces = plate->GetNumberOfCells();
  for (vtkIdType i = 0; i < count; ++i)
  {
    Point p = PointAt(plate, i);
    p[2] = thickness;
    plate->GetPoints()->InsertNextPoint(p.data());
  }
  for (vtkIdType i = 0; i < faces; ++i)
  {
    vtkNew<vtkIdList> corners;
    plate->GetCellPoints(i, corners);
    plate->GetPolys()->InsertNextCell(
      { corners->GetId(2) + count, corners->GetId(1) + count, corners->GetId(0) + count });
  }
  const auto addWall = [&](vtkIdType a, vtkIdType b) {
    plate->GetPolys()->InsertNextCell({ b, a, a + count, b + count });
  };
  for (vtkIdType i = 0; i < n; ++i)
  {
    addWall(i, i + 1);
    addWall((n + 1) * n + i + 1, (n + 1) * n + i);
    addWall((n + 1) * (i + 1), (n + 1) * i);
    addWall((n + 1) * i + n, (n + 1) * (i + 1) + n);
  }
  return plate;
}

/// A curve beside a plate stays on one side of it; a segment that does not is told.
void CheckThinWalls(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Plate(16, 0.002));
  filter->RefineMeshOff();
  std::vector<Point> line;
  for (int i = 0; i <= 40; ++i)
  {
    // The sixth and every eleventh one is closer to the lower side.
    line.push_back({ 0.1 + 0.02 * i, 0.51, i % 11 == 5 ? 0.0008 : 0.002 + 0.0003 * (i % 5) });
  }
  filter->SetSourceData(Polyline(line));
  Messages messages(filter);
  messages.ExpectNothing(check, "a curve beside a plate is not worth a word");
  check.Near(filter->GetSourceLength(), 0.8, 1e-12, "the length beside a plate");
  line[20][2] = -0.0001;
  filter->SetSourceData(Polyline(line));
  messages.ExpectWarning(check,
    { "2 segments of the source are several times as long on the surface as straight",
      "segment 19 of cell 0, segment 20 of cell 0." },
    "a detour");
}

/// Curves that run over each other in opposite directions are told where signs are asked for.
void CheckOpposedCurves(Check& check)
{
  const std::vector<Point> there = { { 0.1, 0.2, 0 }, { 0.4, 0.6, 0 }, { 0.9, 0.7, 0 } };
  const auto closed = Polyline({ there[0], there[1], there[2], there[1] }, true);
  const auto filter = RefinedField(Square(4), closed);
  Messages messages(filter);
  messages.ExpectNoWarning(check, "no signs, no word");
  filter->GenerateSignedDistanceOn();
  messages.ExpectWarning(check,
    { "2 segments of the source run over another in the opposite direction: segment 2 of "
      "cell 0, segment 3 of cell 0. Signs need one direction" },
    "there and back");
  filter->SetSourceData(Polyline(there, true));
  messages.ExpectNoWarning(check, "a plain closed curve");

  auto edges =
    PointSources({ { 0.25, 0.5, 0 }, { 0.75, 0.5, 0 }, { 0.5, 0.5, 0 }, { 0.25, 0.5, 0 } });
  edges->SetLines(CellArray({ { 0, 1 }, { 2, 3 } }));
  filter->SetSourceData(edges);
  filter->JoinLinesOff();
  messages.ExpectWarning(check,
    { "1 segment of the source runs over another", "segment 0 of cell 1." },
    "two curves along an edge");
}

void CheckHalfMeantSources(Check& check)
{
  const auto filter = RefinedField(Tetrahedron(), PointSources({ { 0, 0, 0 } }));
  filter->SetSourceTypeToCurveAndBoundary();
  Messages messages(filter);
  messages.ExpectWarning(
    check, { "the curve alone is the source" }, "a closed surface with curve and boundary");

  filter->SetInputData(Square(2));
  filter->SetSourceData(nullptr);
  messages.ExpectNoError(check, "curve and boundary without a curve");
  CheckWords(check, messages.Warning(), { "the boundary alone is the source" },
    "curve and boundary without a curve");
  CheckDistances(check, filter, DistanceToBoundaryOfSquare, "the boundary alone");
}

void CheckSurfaceAsItsOwnSource(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  const auto square = Square(2);
  filter->SetInputData(square);
  filter->SetSourceData(square);
  Messages messages(filter);
  messages.ExpectWarning(
    check, { "The surface itself is the source" }, "the surface as its own source");
  filter->SetSourceTypeToSurfaceBoundary();
  messages.ExpectNoWarning(check, "no source of its own where the boundary is the source");
}

}

int TestGeodesicWarnings(int, char*[])
{
  Check check;
  for (const Case& odd : Cases())
  {
    CheckCase(check, odd);
  }
  for (const Case& plain : QuietCases())
  {
    CheckQuietCase(check, plain);
  }
  CheckNothingIsSaidTwice(check);
  CheckFarTargets<vtkGeodesicPaths>(check, "paths");
  CheckFarTargets<vtkGeodesicDistanceMatrix>(check, "matrix");
  CheckFarPointsOfSourceAsTargets(check);
  CheckWarningsOfProperties(check);
  CheckExistingArray(check);
  CheckHalfMeantSources(check);
  CheckThinWalls(check);
  CheckOpposedCurves(check);
  CheckWarningsAfterFailure(check);
  CheckUnusedPointsDoNotCount(check);
  CheckSurfaceAsItsOwnSource(check);
  return check.Result();
}
