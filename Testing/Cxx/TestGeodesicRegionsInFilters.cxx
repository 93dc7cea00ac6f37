// SPDX-License-Identifier: BSD-3-Clause
// Random regions as the source of contours, paths, matrices and refined fields: the truth is the
// brute-force solver's, or these filters', on the surface without the regions' faces.
// GEODESIC_TEST_SEEDS=FIRST,COUNT takes other seeds.
#include "RegionScenes.h"
#include "RegionTesting.h"
#include "Seeds.h"

#include "vtkAppendPolyData.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkTable.h"

using namespace GeodesicTesting;

namespace
{

template <typename Filter>
void SetUp(Filter* filter, const RegionScene& scene)
{
  filter->SetInputData(SurfaceOf(scene.made));
  filter->SetBarrierArrayName("barrier");
  filter->SetSourceData(SourceOf(scene));
  filter->SetSourceIdArrayName("region");
}

/// The open faces without the others.
vtkSmartPointer<vtkPolyData> OpenSurface(const RegionScene& scene)
{
  RandomBarriers open;
  open.surface = scene.made.open;
  open.isBarrier.assign(open.surface.triangles.size(), false);
  return SurfaceOf(open);
}

Point Middle(const Point& a, const Point& b)
{
  return { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) };
}

/// Points of lines are at their value, and lines lie in open faces.
void CheckContours(Check& check, const RegionScene& scene, double largest)
{
  vtkNew<vtkGeodesicContour> contour;
  SetUp(contour.Get(), scene);
  const double value = 0.3 * largest;
  contour->SetNumberOfContours(2);
  contour->SetValue(0, 0.0);
  contour->SetValue(1, value);
  contour->Update();
  vtkPolyData* lines = contour->GetOutput();
  std::vector<Point> points;
  std::vector<Point> middles;
  double lengthOfSource = 0.0;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    vtkNew<vtkIdList> ids;
    lines->GetLines()->GetCellAtId(line, ids);
    const bool isSource = lines->GetCellData()
                            ->GetArray("GeodesicDistance")
                            ->GetTuple1(lines->GetNumberOfVerts() + line) == 0.0;
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      const Point a = PointAt(lines, ids->GetId(i - 1));
      const Point b = PointAt(lines, ids->GetId(i));
      lengthOfSource += isSource ? geodesictest::spaceDistance(a, b) : 0.0;
      if (!isSource)
      {
        points.push_back(b);
        middles.push_back(Middle(a, b));
      }
    }
  }
  const double outline = OutlineLengthOf(scene);
  check.That(
    lengthOfSource >= outline * (1.0 - 1e-11), scene.name + ": a value of 0 is the outline");
  if (points.empty())
  {
    return;
  }
  vtkNew<vtkGeodesicPaths> paths;
  paths->SetInputData(OpenSurface(scene));
  paths->SetSourceData(SourceOf(scene.made.open, scene.sources));
  for (const std::vector<Point>& targets : { points, middles })
  {
    paths->SetTargetsData(PointSources(targets));
    paths->Update();
    vtkCellData* found = paths->GetOutput()->GetCellData();
    check.Equal(static_cast<double>(paths->GetOutput()->GetNumberOfLines()),
      static_cast<double>(targets.size()), scene.name + ": paths from a line");
    for (vtkIdType i = 0; i < paths->GetOutput()->GetNumberOfLines(); ++i)
    {
      const double apart = found->GetArray("TargetSnapDistance")->GetTuple1(i);
      check.That(apart <= 1e-9 * largest, scene.name + ": lines lie in open faces");
      const double error = std::abs(found->GetArray("GeodesicDistance")->GetTuple1(i) - value);
      check.That(&targets != &points || error <= 1e-8 * largest,
        scene.name + ": points of a line are wrong by " + std::to_string(error));
    }
  }
}

/// Paths from all points and from the middles of all faces.
void CheckPaths(Check& check, const RegionScene& scene, const std::vector<double>& truth)
{
  std::vector<Point> targets = { scene.made.whole.points.begin(), scene.made.whole.points.end() };
  std::vector<double> expected = truth;
  std::vector<geodesictest::MeshPoint> queries;
  const geodesictest::Barycentric middle = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };
  geodesictest::Index open = 0;
  for (geodesictest::Index f = 0; f < scene.made.whole.triangles.size(); ++f)
  {
    targets.push_back(PositionOf(scene.made.whole, { f, middle }));
    expected.push_back(scene.isInRegion(f) ? 0.0 : INFINITY);
    if (scene.regionOfWhole[f] < 0 && !scene.isBarrierOfWhole[f])
    {
      queries.push_back({ open++, middle });
      expected.back() = -1.0;
    }
  }
  std::vector<double> atQueries(queries.size(), INFINITY);
  if (!queries.empty() && !scene.sources.points.empty())
  {
    atQueries = geodesictest::bruteForceDistances(scene.made.open, scene.sources, queries).queries;
  }
  auto query = atQueries.begin();
  for (double& distance : expected)
  {
    distance = distance < 0.0 ? *query++ : distance;
  }
  vtkNew<vtkGeodesicPaths> paths;
  SetUp(paths.Get(), scene);
  paths->SetTargetsData(PointSources(targets));
  paths->Update();
  vtkPolyData* found = paths->GetOutput();
  const double largest = std::max(1.0, LargestFinite(expected));
  std::vector<double> lengths(targets.size(), INFINITY);
  for (vtkIdType line = 0; line < found->GetNumberOfLines(); ++line)
  {
    vtkNew<vtkIdList> ids;
    found->GetLines()->GetCellAtId(line, ids);
    double length = 0.0;
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      length += geodesictest::spaceDistance(
        PointAt(found, ids->GetId(i - 1)), PointAt(found, ids->GetId(i)));
    }
    lengths[static_cast<std::size_t>(found->GetCellData()->GetArray("TargetId")->GetTuple1(line))] =
      length;
  }
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    // Where faces cross, which of them the middle of one lies on is open.
    const std::size_t points = scene.made.whole.points.size();
    if (i >= points &&
      IsOnOtherFace(scene.made.whole, { static_cast<geodesictest::Index>(i - points), middle }))
    {
      continue;
    }
    const bool isReached = std::isfinite(expected[i]);
    check.That(
      isReached ? std::abs(lengths[i] - expected[i]) <= 1e-8 * largest : std::isinf(lengths[i]),
      scene.name + ": path " + std::to_string(i) + " has the length " + std::to_string(lengths[i]) +
        " instead of " + std::to_string(expected[i]));
  }
}

/// Of each region alone to all points.
void CheckMatrix(Check& check, const RegionScene& scene, double accuracy)
{
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  SetUp(matrix.Get(), scene);
  matrix->SetTargetsData(SurfaceOf(scene.made));
  matrix->Update();
  for (int region = 0; region < 3; ++region)
  {
    RegionScene one = scene;
    std::vector<bool> isClosed = scene.isBarrierOfWhole;
    for (std::size_t f = 0; f < one.regionOfWhole.size(); ++f)
    {
      one.regionOfWhole[f] = one.regionOfWhole[f] == region ? region : -1;
      isClosed[f] = isClosed[f] || one.regionOfWhole[f] >= 0;
    }
    const std::string column = "Source" + std::to_string(10 * region);
    if (!HasRegion(one) || !matrix->GetOutput()->GetColumnByName(column.c_str()))
    {
      check.That(!HasRegion(one), scene.name + ": " + column + " is there");
      continue;
    }
    one.made.open = {};
    one.sources = {};
    AddOpenFaces(one.made, isClosed);
    AddWhereRegionsMeetOpenFaces(one);
    const std::vector<double> truth = TruthOf(one);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      const double found =
        matrix->GetOutput()->GetValueByName(static_cast<vtkIdType>(i), column.c_str()).ToDouble();
      check.That(ErrorOf(found, truth[i]) <= accuracy * std::max(1.0, LargestFinite(truth)),
        scene.name + ": " + column + " of point " + std::to_string(i) + " is " +
          std::to_string(found) + " instead of " + std::to_string(truth[i]));
    }
  }
}

geodesictest::Barycentric WeightsIn(
  const geodesictest::PlainMesh& mesh, geodesictest::Index f, const Point& p)
{
  const geodesictest::Triangle& t = mesh.triangles[f];
  Point corner[3];
  double weights[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    corner[k] = mesh.points[t[k]];
  }
  Point n;
  const auto cross = [](const Point& a, const Point& b, const Point& c)
  {
    const Point u = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const Point v = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    return Point{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
  };
  n = cross(corner[0], corner[1], corner[2]);
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point a = cross(p, corner[(k + 1) % 3], corner[(k + 2) % 3]);
    weights[k] = std::max(0.0, a[0] * n[0] + a[1] * n[1] + a[2] * n[2]);
    sum += weights[k];
  }
  return { weights[0] / sum, weights[1] / sum, weights[2] / sum };
}

/// The interpolant is within its bound at the middles of cells; in regions it is 0, and no point is
/// inside of a face.
void CheckRefinement(Check& check, const RegionScene& scene, double largest)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  SetUp(filter.Get(), scene);
  filter->SetRefinementTolerance(0.02);
  filter->Update();
  vtkPolyData* refined = filter->GetOutput();
  const double bound = filter->GetInterpolationErrorBound() + 1e-9 * largest;
  std::vector<geodesictest::Index> numberOfOpen(scene.made.whole.triangles.size());
  geodesictest::Index open = 0;
  for (std::size_t f = 0; f < numberOfOpen.size(); ++f)
  {
    numberOfOpen[f] = scene.regionOfWhole[f] < 0 && !scene.isBarrierOfWhole[f] ? open++ : 0;
  }
  std::vector<geodesictest::MeshPoint> queries;
  std::vector<double> found;
  for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    refined->GetCellPoints(cell, ids);
    const auto f = static_cast<geodesictest::Index>(
      refined->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(cell));
    Point middle{};
    double mean = 0.0;
    for (const vtkIdType id : { ids->GetId(0), ids->GetId(1), ids->GetId(2) })
    {
      const Point p = PointAt(refined, id);
      for (std::size_t x = 0; x < 3; ++x)
      {
        middle[x] += p[x] / 3.0;
      }
      mean += Distances(filter)->GetTuple1(id) / 3.0;
      if (scene.isInRegion(f))
      {
        const auto weights = WeightsIn(scene.made.whole, f, p);
        check.That(*std::min_element(weights.begin(), weights.end()) < 1e-9,
          scene.name + ": no point inside of a region's face");
      }
    }
    check.That(!scene.isInRegion(f) || mean <= 1e-15 * largest, scene.name + ": 0 in a region");
    if (scene.regionOfWhole[f] < 0 && !scene.isBarrierOfWhole[f] && std::isfinite(mean))
    {
      queries.push_back({ numberOfOpen[f], WeightsIn(scene.made.whole, f, middle) });
      found.push_back(mean);
    }
  }
  if (queries.empty())
  {
    return;
  }
  const std::vector<double> truth =
    geodesictest::bruteForceDistances(scene.made.open, scene.sources, queries).queries;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    check.That(std::abs(found[i] - truth[i]) <= bound,
      scene.name + ": the interpolant is wrong by " + std::to_string(found[i] - truth[i]) +
        ", its bound is " + std::to_string(bound));
  }
}

void CheckRandomScenes(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(4);
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      const RegionScene scene = MakeRegionScene(kind, seed, false);
      // In needles of a thousandth of their length lines come out at their value by 1e-8 at best.
      if (!IsClear(scene) || !HasRegion(scene) || Contains(kind.name, "Needles"))
      {
        continue;
      }
      const std::vector<double> truth = TruthOf(scene);
      CheckPaths(check, scene, truth);
      CheckMatrix(check, scene, AccuracyOn(kind));
      if (LargestFinite(truth) > 0.0)
      {
        CheckContours(check, scene, LargestFinite(truth));
        CheckRefinement(check, scene, LargestFinite(truth));
      }
    }
  }
}

/// A region above the surface covers nothing: its outline is put onto it.
void CheckBeside(Check& check)
{
  Region region{ Square(8), std::vector<bool>(128, false) };
  for (std::size_t face = 36; face < 44; ++face)
  {
    region.IsInside[face] = region.IsInside[face + 16] = true;
  }
  auto above = vtkSmartPointer<vtkPolyData>::New();
  above->DeepCopy(SourceOf(region));
  MovePoints(above, [](const Point& p) { return Point{ p[0] + 0.01, p[1], 0.02 }; });
  vtkNew<vtkFeatureEdges> outline;
  outline->SetInputData(above);
  outline->FeatureEdgesOff();
  outline->Update();
  vtkNew<vtkGeodesicDistanceField> filters[2];
  for (std::size_t i = 0; i < 2; ++i)
  {
    filters[i]->RefineMeshOff();
    filters[i]->SetInputData(region.Surface);
    filters[i]->SetSourceData(i == 0 ? above.Get() : outline->GetOutput());
    filters[i]->Update();
    check.That(std::abs(filters[i]->GetSourceSnapDistance() - 0.02) < 1e-15, "beside: how far");
  }
  double largestInside = 0.0;
  for (vtkIdType i = 0; i < region.Surface->GetNumberOfPoints(); ++i)
  {
    const double expected = Distances(filters[1])->GetTuple1(i);
    check.That(std::abs(Distances(filters[0])->GetTuple1(i) - expected) <= 1e-14,
      "beside: distances from the outline");
    largestInside = PointsInside(region)[static_cast<std::size_t>(i)]
      ? std::max(largestInside, expected)
      : largestInside;
  }
  check.That(largestInside > 0.1, "beside: the region itself is not the source");
}

/// The same with all of the cells of both.
vtkSmartPointer<vtkPolyData> Together(vtkPolyData* a, vtkPolyData* b)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->AddInputData(a);
  append->AddInputData(b);
  append->Update();
  return append->GetOutput();
}

/// A source's face that is given twice, or that names a place twice, changes nothing.
void CheckNeedlessFaces(Check& check)
{
  for (std::uint64_t seed = 0; seed < 8; ++seed)
  {
    const Region region = RandomRegion(seed);
    const auto source = SourceOf(region);
    const auto flat = SourceOf({ region.Surface, std::vector<bool>(region.IsInside.size(), true) });
    vtkNew<vtkCellArray> needle;
    needle->InsertNextCell({ 3, 4, 3 });
    flat->SetPolys(needle);
    flat->GetCellData()->GetArray("One")->Resize(1);
    for (const auto& [name, data] : { std::pair("twice", Together(source, source)),
           std::pair("with a needle", Together(source, flat)) })
    {
      const std::string what = "seed " + std::to_string(seed) + " " + name;
      vtkNew<vtkGeodesicDistanceField> filter;
      filter->RefineMeshOff();
      filter->SetInputData(region.Surface);
      filter->SetSourceData(data);
      filter->SetSourceIdArrayName("One");
      filter->Update();
      CompareWithTruth(check, filter, TruthOf(region), what);
      const double length = OutlineLength(region);
      check.That(std::abs(filter->GetSourceLength() - length) <= 1e-12 * length, what + ": length");
    }
  }
}

/// Barriers are no part of a region: one across it, and one that holds all of it.
void CheckBarriers(Check& check)
{
  Region region{ Square(8), std::vector<bool>(128, false) };
  Region open = region;
  vtkNew<vtkIntArray> barriers;
  barriers->SetName("barrier");
  for (int face = 0; face < 128; ++face)
  {
    const int column = face / 2 % 8;
    const int row = face / 16;
    const auto number = static_cast<std::size_t>(face);
    const bool isBarrier = row == 3 && column > 0;
    region.IsInside[number] = column > 2 && column < 6 && row > 1 && row < 5;
    open.IsInside[number] = region.IsInside[number] && !isBarrier;
    barriers->InsertNextValue(isBarrier ? 1 : 0);
  }
  region.Surface->GetCellData()->AddArray(barriers);
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetBarrierArrayName("barrier");
  filter->SetInputData(region.Surface);
  filter->SetSourceData(SourceOf(region));
  vtkNew<vtkGeodesicDistanceField> expected;
  expected->RefineMeshOff();
  expected->SetBarrierArrayName("barrier");
  expected->SetInputData(region.Surface);
  expected->SetSourceData(SourceOf(open));
  filter->Update();
  expected->Update();
  check.Equal(filter->GetSourceLength(), 2.0, "across: two parts of three squares by one or two");
  for (vtkIdType i = 0; i < region.Surface->GetNumberOfPoints(); ++i)
  {
    check.Equal(Distances(filter)->GetTuple1(i), Distances(expected)->GetTuple1(i), "across");
  }
  barriers->Fill(1.0);
  barriers->SetValue(0, 0);
  barriers->Modified();
  Messages messages(filter);
  messages.Update();
  check.That(Contains(messages.Error(), "All of the source (input port 1) lies in barriers"),
    "all in barriers: " + messages.Error());
}

} // anonymous namespace

int TestGeodesicRegionsInFilters(int, char*[])
{
  Check check;
  CheckRandomScenes(check);
  CheckBeside(check);
  CheckNeedlessFaces(check);
  CheckBarriers(check);
  return check.Result();
}
