// SPDX-License-Identifier: BSD-3-Clause
// The precision of output points, and that the certified bound holds for them as they are stored,
// also far from the origin, where coordinates in single precision are rounded by more than the
// tolerance.
#include "GeodesicTesting.h"

#include "Seeds.h"
#include "truth/BruteForce.h"
#include "truth/RandomMeshKinds.h"

#include "vtkCellData.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicPaths.h"
#include "vtkMultiBlockDataSet.h"

#include <cfloat>
#include <map>

using namespace GeodesicTesting;

namespace
{

constexpr int Single = vtkAlgorithm::SINGLE_PRECISION;
constexpr int Double = vtkAlgorithm::DOUBLE_PRECISION;
constexpr int Default = vtkAlgorithm::DEFAULT_PRECISION;

const std::vector<std::pair<int, std::string>> Precisions = { { Default, "default precision" },
  { Single, "single precision" }, { Double, "double precision" } };

/// Like coordinates of a map (UTM, in meters): numbers so large are multiples of 1/2 in single
/// precision.
constexpr Point Corner = { 654000.0, 5412000.0, 100.0 };
constexpr double CellSize = 1024.0;
const Point Source = { Corner[0] + 2500.0, Corner[1] + 3100.5, Corner[2] };
/// Many roundings of a double there.
constexpr double DoubleRounding = 8.0 * DBL_EPSILON * 5.42e6;

/// A grid of 8 x 8 cells whose points are exact in single precision, and whole numbers.
vtkSmartPointer<vtkPolyData> Grid(int dataType, double height)
{
  auto grid = Square(8);
  MovePoints(grid,
    [height](const Point& p)
    {
      return Point{ Corner[0] + 8.0 * CellSize * p[0], Corner[1] + 8.0 * CellSize * p[1],
        Corner[2] + std::round(height * std::sin(5.0 * p[0]) * std::cos(7.0 * p[1])) };
    });
  grid->SetPoints(PointSources(PlacesOf(grid), dataType)->GetPoints());
  return grid;
}

/// A vertex of such a grid.
vtkSmartPointer<vtkPolyData> VertexOf(vtkPolyData* grid)
{
  const Point p = PointAt(grid, 30);
  return PointSources({ p });
}

vtkIdType OriginalOf(vtkPolyData* output, vtkIdType cell)
{
  return static_cast<vtkIdType>(CellValue(output, "OriginalCellIds", cell));
}

/// A place on a triangle of an output as it is stored, and the value interpolated there.
struct Sample
{
  vtkIdType original;
  Point place;
  double value;
};

/// All corners of all triangles, and some places inside.
std::vector<Sample> SamplesOf(vtkPolyData* output, std::size_t numberInside, std::uint64_t seed)
{
  std::vector<Sample> samples;
  vtkDataArray* distances = output->GetPointData()->GetArray("GeodesicDistance");
  geodesictest::Random random(seed);
  const auto add = [&](vtkIdType cell, const geodesictest::Barycentric& weights)
  {
    const auto ids = IdsOf(output->GetPolys(), cell);
    const auto corners = CornersOf(output, cell);
    Sample sample{ OriginalOf(output, cell), corners[0], 0.0 };
    for (std::size_t k = 0; k < 3; ++k)
    {
      sample.value += weights[k] * distances->GetTuple1(ids[k]);
      for (std::size_t x = 0; x < 3; ++x)
      {
        sample.place[x] += weights[k] * (corners[k][x] - corners[0][x]);
      }
    }
    samples.push_back(sample);
  };
  const auto count = static_cast<std::size_t>(output->GetNumberOfCells());
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    add(static_cast<vtkIdType>(cell), { 1.0, 0.0, 0.0 });
    add(static_cast<vtkIdType>(cell), { 0.0, 1.0, 0.0 });
    add(static_cast<vtkIdType>(cell), { 0.0, 0.0, 1.0 });
  }
  for (std::size_t i = 0; i < numberInside; ++i)
  {
    add(static_cast<vtkIdType>(random.below(count)), geodesictest::randomWeights(random));
  }
  return samples;
}

/// Runs the filter and checks its messages: a tolerance that is not met is told.
void RunAndCheckMessages(
  Check& check, vtkGeodesicDistanceField* filter, double requested, const std::string& what)
{
  Messages messages(filter);
  messages.ExpectNoError(check, what);
  const bool isMet = filter->GetInterpolationErrorBound() <= requested;
  check.That(messages.Warning().empty() == isMet, what + ": a warning if the tolerance is not met");
  if (filter->GetOutputPointsPrecision() == Single)
  {
    check.That(isMet || Contains(messages.Warning(), "OutputPointsPrecision"),
      what + ": the warning says what to do: " + messages.Warning());
  }
  else
  {
    check.That(isMet, what + ": the tolerance is met");
  }
}

/// A flat surface, where the distance is known everywhere.
void CheckPlane(
  Check& check, int dataType, int precision, double tolerance, const std::string& what)
{
  const auto grid = Grid(dataType, 0.0);
  const auto filter = RefinedField(grid, PointSources({ Source }));
  filter->SetRefinementTolerance(tolerance);
  filter->SetOutputPointsPrecision(precision);
  const double requested = tolerance * grid->GetLength();
  RunAndCheckMessages(check, filter, requested, what);
  double measured = 0.0;
  for (const Sample& sample : SamplesOf(filter->GetOutput(), 100, 17))
  {
    measured =
      std::max(measured, std::abs(sample.value - DistanceToSegment(sample.place, Source, Source)));
  }
  const double reported = filter->GetInterpolationErrorBound();
  std::cout << what << ": measured " << measured << ", reported " << reported << ", requested "
            << requested << "\n";
  check.That(measured <= reported, what + ": the measured error is below the bound");
  const double rounding = precision == Single ? 0.2520 : 0.0;
  check.That(reported <= requested + (rounding < 0.5 * requested ? 0.0 : rounding),
    what + ": the bound is below the tolerance, or over it by what is rounded");
  check.Equal(filter->GetOutput()->GetPoints()->GetDataType(),
    precision == Single ? VTK_FLOAT : VTK_DOUBLE, what + ": type of the points");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Point before = PointAt(grid, i);
    const Point after = PointAt(filter->GetOutput(), i);
    check.That(before == after, what + ": the input's points, which are exact, stay");
  }
}

/// New points lie on the planes of the input's faces, and are where a hill has them.
void CheckHill(Check& check, int dataType, int precision, const std::string& what)
{
  const auto hill = Grid(dataType, 700.0);
  const auto filter = RefinedField(hill, VertexOf(hill));
  filter->SetOutputPointsPrecision(precision);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  check.That(output->GetNumberOfPoints() > 2 * hill->GetNumberOfPoints(), what + ": it is refined");
  double farthest = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const auto face = CornersOf(hill, OriginalOf(output, cell));
    const Point normal = Cross(Minus(face[1], face[0]), Minus(face[2], face[0]));
    for (const Point& p : CornersOf(output, cell))
    {
      farthest = std::max(
        farthest, std::abs(Dot(Minus(p, face[0]), normal)) / std::sqrt(Dot(normal, normal)));
    }
  }
  std::cout << what << ": new points are off their planes by up to " << farthest << "\n";
  check.That(farthest <= (precision == Single ? 0.2520 : DoubleRounding),
    what + ": points lie on the surface, but for the rounding of the precision");
}

/// The lines of the other filters, and the source on the surface, are not rounded either.
void CheckLines(Check& check)
{
  const auto isOnPlane = [&](vtkPolyData* lines, const std::string& what)
  {
    check.That(lines->GetNumberOfPoints() > 0, what + ": there are points");
    check.Equal(lines->GetPoints()->GetDataType(), VTK_DOUBLE, what + ": type of the points");
  };
  const auto grid = Grid(VTK_FLOAT, 0.0);
  const auto contour = FilterOn<vtkGeodesicContour>(grid, PointSources({ Source }));
  contour->SetValue(0, 1000.0);
  contour->Update();
  isOnPlane(contour->GetOutput(), "a contour");
  for (const Point& p : PlacesOf(contour->GetOutput()))
  {
    check.Near(DistanceToSegment(p, Source, Source), 1000.0, DoubleRounding,
      "a contour's points have its distance");
  }
  const Point target = { Corner[0] + 7000.3, Corner[1] + 6900.1, Corner[2] };
  const auto paths = FilterOn<vtkGeodesicPaths>(grid, PointSources({ Source }));
  paths->SetTargetsData(PointSources({ target }));
  paths->Update();
  isOnPlane(paths->GetOutput(), "a path");
  for (const Point& p : PlacesOf(paths->GetOutput()))
  {
    check.That(DistanceToSegment(p, Source, target) <= DoubleRounding, "a path is straight");
  }
  for (const auto& [precision, name] : Precisions)
  {
    const auto filter = PlainField(grid, Polyline({ Source, target }));
    filter->SetOutputPointsPrecision(precision);
    filter->Update();
    isOnPlane(filter->GetOutput(1), "the source on the surface, " + name);
  }
}

/// What the points of the output are, where refinement adds none.
void CheckTypes(Check& check)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    const auto grid = Grid(type, 0.0);
    for (const bool isRefined : { false, true })
    {
      for (const auto& [precision, name] : Precisions)
      {
        const std::string what =
          name + (isRefined ? ", nothing to refine, type " : ", type ") + std::to_string(type);
        vtkNew<vtkGeodesicDistanceField> filter;
        filter->SetInputData(grid);
        // The distance from a side is linear.
        filter->SetSourceData(
          Polyline({ Corner, { Corner[0], Corner[1] + 8.0 * CellSize, Corner[2] } }));
        filter->SetRefineMesh(isRefined);
        filter->SetOutputPointsPrecision(precision);
        filter->Update();
        vtkPoints* points = filter->GetOutput()->GetPoints();
        check.Equal(
          points->GetNumberOfPoints(), grid->GetNumberOfPoints(), what + ": no new points");
        const int expected = precision == Default ? type
          : precision == Single                   ? VTK_FLOAT
                                                  : VTK_DOUBLE;
        check.Equal(points->GetDataType(), expected, what + ": type of the points");
        check.That((points == grid->GetPoints()) == (expected == type),
          what + ": the input's object if nothing changes");
        for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
        {
          const Point before = PointAt(grid, i);
          const Point after = PointAt(points, i);
          check.That(before == after, what + ": the input's points");
        }
        if (isRefined && (precision == Default || type == expected))
        {
          check.That(filter->GetInterpolationErrorBound() < 1e-6,
            what + ": points that stay are not displaced");
        }
      }
    }
  }
}

/// Points of the input that are not single can be displaced, too.
void CheckInputIsRounded(Check& check)
{
  const auto grid = Moved(Grid(VTK_DOUBLE, 0.0), MovedBy(0.2, 0.24));
  const Point begin = { Corner[0] + 0.2, Corner[1] + 0.24, Corner[2] };
  const Point end = { begin[0] + 8.0 * CellSize, begin[1], begin[2] };
  const auto filter = RefinedField(grid, Polyline({ begin, end }));
  filter->SetOutputPointsPrecision(Single);
  filter->Update();
  check.That(
    filter->GetOutput()->GetNumberOfPoints() == grid->GetNumberOfPoints(), "no new points");
  double measured = 0.0;
  for (const Sample& sample : SamplesOf(filter->GetOutput(), 100, 3))
  {
    measured =
      std::max(measured, std::abs(sample.value - DistanceToSegment(sample.place, begin, end)));
  }
  check.That(measured > 0.2, "the input's points are rounded");
  check.That(measured <= filter->GetInterpolationErrorBound(), "and the bound holds");

  const auto large = Moved(Square(2), ScaledBy(1e40));
  filter->SetInputData(large);
  filter->SetSourceData(PointSources({ { 1e39, 1e39, 0.0 } }));
  Messages messages(filter);
  messages.ExpectError(check, { "OutputPointsPrecision" },
    "coordinates over the range of single precision are an error");
  filter->SetOutputPointsPrecision(Default);
  messages.ExpectNoError(check, "but not in double precision");
}

/// So far from the origin that doubles are rounded by about the tolerance.
void CheckDoublesAreRounded(Check& check)
{
  constexpr double shift = 1e12;
  auto grid = Square(8);
  MovePoints(grid,
    [](const Point& p) {
      return Point{ 8.0 * p[0] + shift, 8.0 * p[1] + shift, shift };
    });
  const Point source = { shift + 3.0, shift + 4.0, shift };
  const auto filter = RefinedField(grid, PointSources({ source }));
  filter->SetRefinementTolerance(1e-5);
  Messages messages(filter);
  messages.Update();
  double measured = 0.0;
  for (const Sample& sample : SamplesOf(filter->GetOutput(), 100, 5))
  {
    measured =
      std::max(measured, std::abs(sample.value - DistanceToSegment(sample.place, source, source)));
  }
  const double requested = 1e-5 * grid->GetLength();
  check.That(measured > requested, "no tolerance below the rounding of doubles can be met");
  check.That(measured <= filter->GetInterpolationErrorBound(), "but the bound holds");
  check.That(Contains(messages.Warning(), "far from the origin"),
    "and a warning says why: " + messages.Warning());
}

/// Some faces of a surface, with all of its points.
vtkSmartPointer<vtkPolyData> Half(vtkPolyData* surface, bool isFirst, int dataType)
{
  auto polygons = CellsOf(surface->GetPolys());
  const auto middle = polygons.begin() + static_cast<std::ptrdiff_t>(polygons.size() / 2);
  isFirst ? polygons.erase(middle, polygons.end()) : polygons.erase(polygons.begin(), middle);
  auto half = PointSources(PlacesOf(surface), dataType);
  half->SetPolys(CellArrayOf(polygons));
  return half;
}

/// Blocks fit together as they are stored, whatever the precision of each block's input.
void CheckSeams(
  Check& check, const std::array<int, 2>& types, int precision, const std::string& what)
{
  const auto hill = Grid(VTK_DOUBLE, 700.0);
  const auto blocks = Blocks({ Half(hill, true, types[0]), Half(hill, false, types[1]) });
  const auto filter = RefinedField(blocks, VertexOf(hill));
  filter->SetOutputPointsPrecision(precision);
  Messages(filter).ExpectNothing(check, what);
  std::map<std::pair<Point, Point>, int> edges;
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkPolyData* block = Block(filter, i);
    check.Equal(block->GetPoints()->GetDataType(), precision == Single ? VTK_FLOAT : VTK_DOUBLE,
      what + ": type of the points");
    for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
    {
      const auto corners = CornersOf(block, cell);
      for (std::size_t k = 0; k < 3; ++k)
      {
        ++edges[std::minmax(corners[k], corners[(k + 1) % 3])];
      }
    }
  }
  const double far = 8.0 * CellSize;
  for (const auto& [edge, count] : edges)
  {
    const auto isAt = [&ends = edge](std::size_t axis, double place)
    { return ends.first[axis] == place && ends.second[axis] == place; };
    const bool isBoundary = isAt(0, Corner[0]) || isAt(0, Corner[0] + far) || isAt(1, Corner[1]) ||
      isAt(1, Corner[1] + far);
    check.That(count == (isBoundary ? 1 : 2), what + ": no gap at an edge");
  }
}

/// A block to which refinement adds nothing keeps its points.
void CheckBlocksApart(Check& check)
{
  const auto hill = Grid(VTK_FLOAT, 700.0);
  const auto second = Half(hill, false, VTK_FLOAT);
  const auto blocks = Blocks({ Half(hill, true, VTK_FLOAT), second });
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputDataObject(blocks);
  const Point vertex = PointAt(hill, 2);
  filter->SetSourceData(PointSources({ vertex }));
  filter->SetMaximumDistance(1000.0);
  filter->Update();
  check.Equal(Block(filter, 0)->GetPoints()->GetDataType(), VTK_DOUBLE, "a refined block");
  check.That(Block(filter, 1)->GetPoints() == second->GetPoints(),
    "a block that is not refined keeps its points");
}

/// Blocks whose seam differs by roundings are joined: each shows the distance a little beside its
/// place.
void CheckJoinedSeams(Check& check)
{
  for (const int precision : { Default, Single, Double })
  {
    const auto grid = Grid(VTK_DOUBLE, 0.0);
    vtkNew<vtkMultiBlockDataSet> blocks;
    const auto upper = Moved(Half(grid, false, VTK_FLOAT), MovedBy(0.0, 0.5));
    blocks->SetBlock(0, Half(grid, true, VTK_FLOAT));
    blocks->SetBlock(1, upper);
    const auto filter = RefinedField(
      blocks, Polyline({ Corner, { Corner[0] + 8.0 * CellSize, Corner[1], Corner[2] } }));
    filter->SetRefinementTolerance(1e-4);
    filter->SetOutputPointsPrecision(precision);
    filter->Update();
    check.That(filter->GetSeamPointsJoined() == 9, "blocks are joined");
    vtkPolyData* block = Block(filter, 1);
    // The seam's points are those of the lower block, from which the distance is known.
    double measured = 0.0;
    for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
    {
      const Point p = PointAt(block, i);
      const double distance = PointValue(block, "GeodesicDistance", i);
      if (std::isfinite(distance) && p[1] < Corner[1] + 4.0 * CellSize + 1.0)
      {
        measured = std::max(measured, std::abs(distance - (p[1] - Corner[1])));
      }
    }
    check.That(measured > 0.0, "the seam's points are apart");
    check.That(measured <= filter->GetInterpolationErrorBound(), "the bound covers a joined seam");
  }
}

/// The point of a face closest to a place, as weights of its corners.
geodesictest::Barycentric ClosestIn(const std::vector<Point>& face, const Point& p)
{
  const Point u = Minus(face[1], face[0]);
  const Point v = Minus(face[2], face[0]);
  const Point normal = Cross(u, v);
  const Point w = Minus(p, face[0]);
  const double second = Dot(Cross(w, v), normal) / Dot(normal, normal);
  const double third = Dot(Cross(u, w), normal) / Dot(normal, normal);
  if (second >= 0.0 && third >= 0.0 && second + third <= 1.0)
  {
    return { 1.0 - second - third, second, third };
  }
  geodesictest::Barycentric closest{};
  double least = VTK_DOUBLE_MAX;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point& a = face[k];
    const Point& b = face[(k + 1) % 3];
    const double along =
      std::clamp(Dot(Minus(p, a), Minus(b, a)) / Dot(Minus(b, a), Minus(b, a)), 0.0, 1.0);
    const double distance = DistanceToSegment(p, a, b);
    if (distance < least)
    {
      least = distance;
      closest = {};
      closest[k] = 1.0 - along;
      closest[(k + 1) % 3] = along;
    }
  }
  return closest;
}

/// A random surface far from the origin, in the precision of its points.
geodesictest::PlainMesh RandomFarMesh(
  const geodesictest::MeshKind& kind, geodesictest::Random& random, int dataType)
{
  geodesictest::PlainMesh mesh = kind.make(random.between(30, 120), random);
  const double size = std::pow(10.0, random.uniform(-1.0, 3.0));
  const double far = size * std::pow(10.0, random.uniform(0.0, 4.0));
  const Point shift = { random.uniform(-far, far), random.uniform(-far, far),
    random.uniform(-far, far) };
  for (geodesictest::Vec3& p : mesh.points)
  {
    for (std::size_t x = 0; x < 3; ++x)
    {
      p[x] = size * p[x] + shift[x];
      p[x] = dataType == VTK_FLOAT ? static_cast<double>(static_cast<float>(p[x])) : p[x];
    }
  }
  return mesh;
}

/// Faces that rounding has squeezed are no task of this test.
bool IsUsable(const geodesictest::PlainMesh& mesh)
{
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
    [&mesh](const geodesictest::Triangle& t)
    {
      const Point u = Minus(mesh.points[t[1]], mesh.points[t[0]]);
      const Point v = Minus(mesh.points[t[2]], mesh.points[t[0]]);
      const Point normal = Cross(u, v);
      return Dot(normal, normal) > 1e-8 * Dot(u, u) * Dot(v, v);
    });
}

/// Whether no face touches a vertex without having it: a source in space names one of both.
bool IsOnOneSheet(const geodesictest::PlainMesh& mesh, geodesictest::Index vertex)
{
  const Point& p = mesh.points[vertex];
  return std::none_of(mesh.triangles.begin(), mesh.triangles.end(),
    [&](const geodesictest::Triangle& t)
    {
      const std::vector<Point> face = { mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]] };
      const geodesictest::Barycentric weights = ClosestIn(face, p);
      Point offset = Minus(face[0], p);
      double size = 0.0;
      for (std::size_t x = 0; x < 3; ++x)
      {
        offset[x] +=
          weights[1] * (face[1][x] - face[0][x]) + weights[2] * (face[2][x] - face[0][x]);
        size = std::max(size, std::abs(p[x]) + std::abs(face[1][x] - face[0][x]));
      }
      const bool hasVertex = std::find(t.begin(), t.end(), vertex) != t.end();
      return !hasVertex && Dot(offset, offset) < 1e-12 * size * size;
    });
}

/// \returns measured / reported.
double CheckRandom(Check& check, const geodesictest::MeshKind& kind, std::uint64_t seed)
{
  geodesictest::Random random(seed);
  const int dataType = random.chance(0.7) ? VTK_FLOAT : VTK_DOUBLE;
  const auto mesh = RandomFarMesh(kind, random, dataType);
  const geodesictest::MeshPoint source = geodesictest::randomVertexPoint(mesh, random);
  const auto corner = std::max_element(source.weights.begin(), source.weights.end());
  if (!IsUsable(mesh) ||
    !IsOnOneSheet(
      mesh, mesh.triangles[source.face][static_cast<std::size_t>(corner - source.weights.begin())]))
  {
    return 0.0;
  }
  const auto& [precision, name] = Precisions[random.below(3)];
  const std::string what =
    std::string(kind.name) + " of seed " + std::to_string(seed) + ", " + name;
  const auto surface = Mesh(mesh.points, mesh.triangles, dataType);
  const auto filter = RefinedField(surface, PointSources({ geodesictest::position(mesh, source) }));
  filter->MergeCoincidentPointsOff();
  filter->SetOutputPointsPrecision(precision);
  filter->SetRefinementTolerance(std::pow(10.0, random.uniform(-4.0, -2.0)));
  filter->SetMaximumNumberOfCells(30000);
  Messages messages(filter);
  messages.ExpectNoError(check, what);
  vtkPolyData* output = filter->GetOutput();
  std::vector<Sample> samples = SamplesOf(output, 40, seed);
  // The last ones are inside; of the others not all are needed.
  const std::size_t step = std::max<std::size_t>(1, samples.size() / 60);
  std::vector<geodesictest::MeshPoint> queries;
  std::vector<double> values;
  for (std::size_t i = 0; i < samples.size(); i += i + 40 < samples.size() ? step : 1)
  {
    const auto face = CornersOf(surface, samples[i].original);
    queries.push_back(
      { static_cast<geodesictest::Index>(samples[i].original), ClosestIn(face, samples[i].place) });
    values.push_back(samples[i].value);
  }
  const auto truth = geodesictest::bruteForceDistances(mesh, { { source }, {} }, queries);
  double measured = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    if (std::isfinite(truth.queries[i]) && std::isfinite(values[i]))
    {
      measured = std::max(measured, std::abs(values[i] - truth.queries[i]));
      largest = std::max(largest, truth.queries[i]);
    }
  }
  const double reported = filter->GetInterpolationErrorBound();
  // Both solvers round, and a weight is found from coordinates.
  const double rounding = 1e-11 * largest;
  check.That(measured <= reported + rounding,
    what + ": measured " + std::to_string(measured) + ", reported " + std::to_string(reported));
  const double requested = filter->GetRefinementTolerance() * surface->GetLength();
  check.That(reported <= requested * (1.0 + 1e-12) || !messages.Warning().empty(),
    what + ": the tolerance is met, or a warning tells");
  return measured / (reported + rounding);
}

void CheckRandomMeshes(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(geodesictest::meshesOfAKind(6));
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    double worst = 0.0;
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      worst = std::max(worst, CheckRandom(check, kind, seed));
    }
    std::cout << kind.name << ": largest part of the bound that is measured: " << worst << "\n";
  }
}

}

int TestGeodesicPrecision(int, char*[])
{
  Check check;
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (const auto& [precision, name] : Precisions)
    {
      const std::string what = (type == VTK_FLOAT ? "single input, " : "double input, ") + name;
      for (const double tolerance : { 1e-3, 1e-4, 3e-5, 1e-5 })
      {
        std::ostringstream text;
        text << what << ", tolerance " << tolerance;
        CheckPlane(check, type, precision, tolerance, text.str());
      }
      CheckHill(check, type, precision, "hill, " + what);
    }
  }
  CheckLines(check);
  CheckTypes(check);
  CheckInputIsRounded(check);
  CheckDoublesAreRounded(check);
  for (const auto& [precision, name] : Precisions)
  {
    CheckSeams(check, { VTK_FLOAT, VTK_FLOAT }, precision, "single blocks, " + name);
    CheckSeams(check, { VTK_DOUBLE, VTK_FLOAT }, precision, "double and single blocks, " + name);
    CheckSeams(check, { VTK_DOUBLE, VTK_DOUBLE }, precision, "double blocks, " + name);
  }
  CheckBlocksApart(check);
  CheckJoinedSeams(check);
  CheckRandomMeshes(check);
  return check.Result();
}
