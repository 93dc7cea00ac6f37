// SPDX-License-Identifier: BSD-3-Clause
// Lines of two points, as sections and feature edges have them, are curves: every filter makes the
// same of them, bit for bit, as of polylines by hand. GEODESIC_TEST_SEEDS=FIRST,COUNT takes other
// random meshes.
#include "BarrierTesting.h"
#include "LineTesting.h"

#include "Seeds.h"
#include "truth/RandomMeshKinds.h"

#include "vtkCellType.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnstructuredGrid.h"

using namespace GeodesicTesting;

namespace
{

using geodesictest::Random;

template <typename Item>
void Shuffle(std::vector<Item>& items, Random& random)
{
  for (std::size_t i = items.size(); i > 1; --i)
  {
    std::swap(items[i - 1], items[random.below(i)]);
  }
}

/// The lines of curves: in any order, some turned, some twice, some without length.
std::vector<Segment> LinesAtRandom(const std::vector<Curve>& curves, Random& random)
{
  std::vector<Segment> lines;
  const double turned = random.chance(0.3) ? 0.0 : random.uniform(0.0, 1.0);
  const double repeated = random.chance(0.5) ? 0.0 : 0.3;
  for (const Curve& curve : curves)
  {
    for (std::size_t i = 0; i < curve.CountSegments(); ++i)
    {
      auto [a, b] = curve.SegmentAt(i);
      if (random.chance(turned))
      {
        std::swap(a, b);
      }
      lines.push_back({ a, b });
      if (random.chance(repeated))
      {
        lines.push_back(random.chance(0.5) ? Segment{ a, b } : Segment{ b, a });
      }
      if (random.chance(repeated))
      {
        lines.push_back({ a, a });
      }
    }
    if (curve.points.size() == 1)
    {
      lines.push_back({ curve.points[0], curve.points[0] });
    }
  }
  if (!random.chance(0.2))
  {
    Shuffle(lines, random);
  }
  return lines;
}

/// The lines as one of the data sets that may be a source.
vtkSmartPointer<vtkDataObject> SourceOf(const std::vector<Segment>& lines, Random& random)
{
  const bool arePointsShared = random.chance(0.5);
  if (random.chance(0.3))
  {
    const auto data = LinesOf(lines, arePointsShared);
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(data->GetPoints());
    for (const std::vector<vtkIdType>& ids : CellsOf(data->GetLines()))
    {
      grid->InsertNextCell(random.chance(0.5) ? VTK_LINE : VTK_POLY_LINE, 2, ids.data());
    }
    return grid;
  }
  if (random.chance(0.5))
  {
    return LinesOf(lines, arePointsShared);
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t first = 0; first < lines.size();)
  {
    const auto count =
      std::min(lines.size() - first, static_cast<std::size_t>(1 + random.below(lines.size())));
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(first);
    blocks->SetBlock(blocks->GetNumberOfBlocks(),
      LinesOf({ begin, begin + static_cast<std::ptrdiff_t>(count) }, arePointsShared));
    first += count;
  }
  return blocks;
}

/// A curve through random points of faces of which each has a vertex in common with the next.
Curve RandomCurve(const geodesictest::PlainMesh& mesh, Random& random)
{
  std::vector<std::vector<geodesictest::Index>> facesAt(mesh.points.size());
  for (geodesictest::Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (const geodesictest::Index vertex : mesh.triangles[f])
    {
      facesAt[vertex].push_back(f);
    }
  }
  Curve curve;
  curve.closed = random.chance(0.4);
  const std::size_t count = random.between(curve.closed ? 3 : 1, 8);
  geodesictest::Index face = random.below(mesh.triangles.size());
  while (curve.points.size() < count)
  {
    const Point p = geodesictest::position(mesh, { face, geodesictest::randomWeights(random) });
    if (std::find(curve.points.begin(), curve.points.end(), p) == curve.points.end())
    {
      curve.points.push_back(p);
    }
    const auto& around = facesAt[mesh.triangles[face][random.below(3)]];
    face = around[random.below(around.size())];
  }
  return curve;
}

/// Whether curves have a place in common; then they are not these curves any more.
bool DoMeet(const std::vector<Curve>& curves)
{
  std::set<Point> places;
  std::size_t count = 0;
  for (const Curve& curve : curves)
  {
    places.insert(curve.points.begin(), curve.points.end());
    count += curve.points.size();
  }
  return places.size() < count;
}

void CheckRandomCurves(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(3);
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      Random random(seed);
      const geodesictest::PlainMesh mesh = kind.make(random.between(30, 150), random);
      std::vector<Curve> curves(random.between(1, 4));
      do
      {
        for (Curve& curve : curves)
        {
          curve = RandomCurve(mesh, random);
        }
      } while (DoMeet(curves));
      const std::vector<Segment> lines = LinesAtRandom(curves, random);
      CompareAll(check, Mesh(mesh.points, mesh.triangles), SourceOf(lines, random),
        JoinedByHand(curves, lines), std::string(kind.name) + ", seed " + std::to_string(seed));
    }
  }
}

//------------------------------------------------------------------------------
std::vector<Segment> SegmentsOf(vtkPolyData* data)
{
  std::vector<Segment> lines;
  const std::vector<Point> places = PlacesOf(data);
  for (const std::vector<vtkIdType>& ids : CellsOf(data->GetLines()))
  {
    lines.push_back(
      { places[static_cast<std::size_t>(ids[0])], places[static_cast<std::size_t>(ids[1])] });
  }
  return lines;
}

/// The closed curves that lines are: the plainest way, from each line to any that continues it.
std::vector<Curve> LoopsOf(std::vector<Segment> lines)
{
  std::vector<Curve> loops;
  while (!lines.empty())
  {
    Curve loop{ { lines[0][0] }, true, true };
    Point end = lines[0][1];
    lines.erase(lines.begin());
    while (end != loop.points.front())
    {
      const auto next = std::find_if(lines.begin(), lines.end(),
        [&](const Segment& line) { return line[0] == end || line[1] == end; });
      loop.points.push_back(end);
      end = (*next)[0] == end ? (*next)[1] : (*next)[0];
      lines.erase(next);
    }
    loops.push_back(loop);
  }
  return loops;
}

/// Sections of a body with four loops: from a torus, by two planes.
void CheckSections(Check& check)
{
  const geodesictest::PlainMesh mesh = geodesictest::torus(12, 30, 3.0);
  const auto torus = Mesh(mesh.points, mesh.triangles);
  std::vector<Segment> lines;
  for (const Point& normal : { Point{ 1, 0.1, 0.02 }, Point{ 0.1, -1, 0.3 } })
  {
    const std::vector<Segment> more =
      SegmentsOf(Section(torus, normal, { 0.0123, 0.0217, 0.0312 }));
    lines.insert(lines.end(), more.begin(), more.end());
  }
  const std::vector<Curve> loops = LoopsOf(lines);
  check.Equal(loops.size(), 4.0, "loops of the sections");
  const ByHand curves = JoinedByHand(loops, lines);
  CompareAll(check, torus, LinesOf(lines), curves, "sections of a torus", true);
  Random random(5);
  Shuffle(lines, random);
  CompareAll(check, torus, LinesOf(lines, false), JoinedByHand(loops, lines),
    "sections of a torus, shuffled");

  const auto off = PlainField(torus, LinesOf(lines));
  off->JoinLinesOff();
  off->Update();
  check.Equal(
    OutputOf(off, 1)->GetNumberOfLines(), lines.size(), "curves where lines are not joined");
}

//------------------------------------------------------------------------------
/// In the unit square, with n lines.
Curve Arc(const Point& centre, double radius, double from, double to, int n)
{
  Curve curve;
  for (int i = 0; i <= n; ++i)
  {
    const double angle = from + (to - from) * i / n;
    curve.points.push_back(
      { centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), 0.0 });
  }
  return curve;
}

Curve Ring(const Point& centre, double radius, int n, bool isFree, double from = 0.0)
{
  constexpr double fullAngle = 6.283185307179586;
  Curve curve = Arc(centre, radius, from, from + fullAngle, n);
  curve.points.pop_back();
  curve.closed = true;
  curve.isFree = isFree;
  return curve;
}

void CheckCurves(Check& check, const std::vector<Curve>& curves, const std::string& name)
{
  const auto surface = Square(8);
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(12);
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    Random random(seed);
    const std::vector<Segment> lines = LinesAtRandom(curves, random);
    CompareAll(check, surface, SourceOf(lines, random), JoinedByHand(curves, lines),
      name + ", seed " + std::to_string(seed));
  }
}

void CheckBranchings(Check& check)
{
  const Point middle = { 0.52, 0.47, 0.0 };
  const Point other = { 0.2, 0.85, 0.0 };
  const auto armTo = [&](double x, double y) -> Curve
  {
    return { { { x, y, 0.0 }, { 0.5 * (x + middle[0]), 0.4 * y + 0.6 * middle[1], 0.0 }, middle } };
  };
  CheckCurves(check, { armTo(0.1, 0.1), armTo(0.9, 0.2), armTo(0.4, 0.95) }, "a Y");
  const auto wayBy = [&](double x, double y) -> Curve {
    return { { middle, { x, y, 0.0 }, { x - 0.07, y + 0.03, 0.0 }, other } };
  };
  CheckCurves(check, { wayBy(0.12, 0.3), wayBy(0.35, 0.6), wayBy(0.7, 0.8) }, "a theta");
  CheckCurves(check, { wayBy(0.12, 0.3), wayBy(0.35, 0.6), armTo(0.9, 0.2), wayBy(0.7, 0.8) },
    "a theta with an arm");
  CheckCurves(check, { { { middle, other } } }, "one line");
  CheckCurves(check, { { { middle } }, { { other } } }, "lines without length");

  // The rings begin at the same point, bit by bit.
  Curve left = Ring({ 0.3, 0.5, 0.0 }, 0.2, 7, false);
  Curve right = Ring({ 0.7, 0.5, 0.0 }, 0.2, 6, false, 3.141592653589793);
  right.points.front() = left.points.front();
  CheckCurves(check, { left, right }, "two loops that touch");
  left.isFree = true;
  CheckCurves(check, { left, Ring({ 0.75, 0.5, 0.0 }, 0.2, 6, true) }, "two loops");
  left.isFree = false;
  CheckCurves(check, { left, { { left.points.front(), { 0.6, 0.55, 0 }, { 0.9, 0.6, 0 } } } },
    "a loop with a tail");
}

/// Polylines of more points stay as they are, though lines meet their ends and each other there.
void CheckPolylines(Check& check)
{
  const std::vector<Point> p = { { 0.1, 0.2, 0 }, { 0.3, 0.4, 0 }, { 0.5, 0.35, 0 },
    { 0.7, 0.6, 0 }, { 0.9, 0.7, 0 }, { 0.4, 0.8, 0 } };
  auto source = PointSources(p);
  source->SetLines(CellArray({ { 0, 1, 2 }, { 2, 3 }, { 4, 3 }, { 4, 5, 0 } }));
  const auto filter = PlainField(Square(8), source);
  filter->Update();
  vtkPolyData* output = OutputOf(filter, 1);
  vtkDataArray* ids = output->GetCellData()->GetArray("SourceId");
  check.Equal(output->GetNumberOfLines(), 3.0, "polylines and joined lines");
  check.That(NumbersOf(ids) == std::vector<double>{ 0.0, 1.0, 3.0 }, "their ids");

  // Loops of the boundary go on after the cells.
  const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(Square(8), source);
  matrix->SetSourceTypeToCurveAndBoundary();
  matrix->Update();
  check.That(ColumnsOf(matrix->GetOutput()) ==
      std::vector<std::string>{ "TargetId", "Source0", "Source1", "Source3", "Source4" },
    "the names of columns");
}

/// Messages name a point by the cell that was given, not by the curve.
void CheckMessages(Check& check)
{
  const std::vector<Segment> lines = { { Point{ 0.6, 0.6, 0 }, Point{ 0.6, 0.3, 0.5 } },
    { Point{ 0.1, 0.1, 0 }, Point{ 0.3, 0.3, 0 } },
    { Point{ 0.6, 0.6, 0 }, Point{ 0.3, 0.3, 0 } } };
  const auto filter = PlainField(Square(8), LinesOf(lines));
  Messages messages(filter);
  messages.ExpectWarning(
    check, { "at 1 of 4 points: point 1 of cell 0." }, "a far point of joined lines");

  filter->SetInputData(Blocks({ Square(2), Moved(Square(2), MovedBy(2.0)) }));
  filter->SetSourceData(LinesOf({ { Point{ 0.1, 0.1, 0 }, Point{ 0.3, 0.3, 0 } },
    { Point{ 2.6, 0.6, 0 }, Point{ 0.3, 0.3, 0 } } }));
  messages.ExpectError(check,
    { "Point 1 of cell 1 of the source (input port 1) and point 0 of cell 1 of the source" },
    "lines between two parts");
}

}

int TestGeodesicLines(int, char*[])
{
  Check check;
  CheckSections(check);
  CheckBranchings(check);
  CheckRandomCurves(check);
  CheckPolylines(check);
  CheckMessages(check);
  return check.Result();
}
