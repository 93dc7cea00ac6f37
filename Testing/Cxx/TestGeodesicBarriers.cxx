// SPDX-License-Identifier: BSD-3-Clause
// No path passes through faces that a cell array marks: distances are those of the brute-force
// solver on the surface without them, and around a wall those of the plane. The output has them.
#include "BarrierTesting.h"
#include "RandomBarriers.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

#include <map>
#include <set>

using namespace GeodesicTesting;

namespace
{

using geodesictest::Index;
using geodesictest::PlainMesh;
using geodesictest::Random;

/// \returns the error, of the largest distance.
double CompareWithBruteForce(Check& check, const geodesictest::MeshKind& kind, std::uint64_t seed)
{
  RandomCase one(kind, seed);
  one.filter->RefineMeshOff();
  if (!one.CanRun(check))
  {
    return 0.0;
  }
  check.Equal(one.filter->GetOutput()->GetNumberOfCells(), one.made.whole.triangles.size(),
    one.name + ": cells");
  const std::vector<double> truth =
    geodesictest::bruteForceDistances(one.made.open, one.sources).vertices;
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    worst = std::max(worst, ErrorOf(one.DistanceAt(i), truth[i]));
  }
  const double largest = LargestFinite(truth);
  worst = largest > 0.0 ? worst / largest : worst;
  check.That(worst <= one.accuracy, one.name + ": wrong by " + std::to_string(worst));
  return worst;
}

/// Where a point of a face is in it.
geodesictest::Barycentric WeightsIn(const PlainMesh& mesh, Index face, const Point& p)
{
  const geodesictest::Triangle& t = mesh.triangles[face];
  const Point u = Minus(mesh.points[t[1]], mesh.points[t[0]]);
  const Point v = Minus(mesh.points[t[2]], mesh.points[t[0]]);
  const Point w = Minus(p, mesh.points[t[0]]);
  const Point normal = Cross(u, v);
  const auto along = [&normal](const Point& a) { return Dot(a, normal) / Dot(normal, normal); };
  // Clamped, as new points on edges are off by rounding.
  const double second = std::clamp(along(Cross(w, v)), 0.0, 1.0);
  const double third = std::clamp(along(Cross(u, w)), 0.0, 1.0 - second);
  return { 1.0 - second - third, second, third };
}

/// Refined neighbours fit, barriers are whole, and new points have the true distance.
void CheckRefinedRandom(Check& check, const geodesictest::MeshKind& kind, std::uint64_t seed)
{
  RandomCase one(kind, seed);
  one.filter->SetRefinementTolerance(0.003);
  one.filter->SetMaximumNumberOfCells(20000);
  if (!one.CanRun(check))
  {
    return;
  }
  vtkPolyData* input = vtkPolyData::SafeDownCast(one.filter->GetInputDataObject(0, 0));
  vtkPolyData* output = one.filter->GetOutput();
  check.That(EdgeLengthsDiffer(input, output) < 1e-9, one.name + ": refined neighbours fit");
  check.That(AreaError(input, output) < 1e-9, one.name + ": each cell is covered by its parts");

  std::vector<Index> openFaces; // of the whole's
  for (Index f = 0, next = 0; f < one.made.whole.triangles.size(); ++f)
  {
    openFaces.push_back(one.made.isBarrier[f] ? 0 : next++);
  }
  vtkDataArray* originals = output->GetCellData()->GetArray("OriginalCellIds");
  std::map<vtkIdType, geodesictest::MeshPoint> places; // of new points that an open face has
  std::set<vtkIdType> inBarriers;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const auto face = static_cast<std::size_t>(originals->GetTuple1(cell));
    vtkNew<vtkIdList> ids;
    output->GetCellPoints(cell, ids);
    for (const vtkIdType id : { ids->GetId(0), ids->GetId(1), ids->GetId(2) })
    {
      if (id < input->GetNumberOfPoints())
      {
        continue;
      }
      if (one.made.isBarrier[face])
      {
        inBarriers.insert(id);
        continue;
      }
      const Point p = PointAt(output, id);
      places[id] = { openFaces[face], WeightsIn(one.made.open, openFaces[face], p) };
    }
  }
  for (const vtkIdType id : inBarriers)
  {
    check.That(places.count(id) > 0, one.name + ": new points of barriers are on their rims");
  }
  std::vector<geodesictest::MeshPoint> queries;
  std::vector<vtkIdType> ids;
  const std::size_t step = std::max<std::size_t>(1, places.size() / 80);
  for (auto place = places.begin(); place != places.end();)
  {
    ids.push_back(place->first);
    queries.push_back(place->second);
    for (std::size_t i = 0; i < step && place != places.end(); ++i)
    {
      ++place;
    }
  }
  const auto truth = geodesictest::bruteForceDistances(one.made.open, one.sources, queries);
  const double largest = LargestFinite(truth.vertices);
  double worst = 0.0;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    worst =
      std::max(worst, ErrorOf(one.DistanceAt(static_cast<std::size_t>(ids[i])), truth.queries[i]));
  }
  // Places are found again from coordinates, in needles from rounded ones.
  check.That(worst <= 10.0 * one.accuracy * largest,
    one.name + ": refined points are wrong by " + std::to_string(worst / largest));
}

void CheckRandomMeshes(Check& check)
{
  constexpr std::uint64_t meshesOfAKind = 40;
  constexpr std::uint64_t refinedMeshesOfAKind = 8;
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < meshesOfAKind; ++seed)
    {
      worst = std::max(worst, CompareWithBruteForce(check, kind, seed));
    }
    for (std::uint64_t seed = 0; seed < refinedMeshesOfAKind; ++seed)
    {
      CheckRefinedRandom(check, kind, seed);
    }
    std::cout << "worst relative error with barriers on " << kind.name << ": " << worst << "\n";
  }
}

const Point Source{ 0.125, 0.1875, 0 };

void CheckWall(Check& check)
{
  const Distance truth = AroundWall(Source);
  for (const bool refine : { false, true })
  {
    for (const Cells cells : { Cells::Triangles, Cells::Quads })
    {
      const std::string what = refine ? "a refined wall" : "a wall";
      vtkNew<vtkGeodesicDistanceField> filter;
      filter->SetRefineMesh(refine);
      filter->ToleranceIsAbsoluteOn();
      filter->SetAbsoluteRefinementTolerance(0.0005);
      const auto surface = SquareWithWall(16, cells);
      const std::string warning =
        RunWithBarriers(check, filter, surface, PointSources({ Source }), what);
      check.That(warning.empty(), "barriers give no warning: " + warning);
      vtkPolyData* output = filter->GetOutput();
      CheckTruth(check, output, truth, what);
      if (!refine)
      {
        check.Equal(output->GetNumberOfCells(), 512.0, "cells of a square with a wall");
        continue;
      }
      check.That(CountBarrierParts(output, IsInWall) > 48, "the rim of a barrier is split");
      check.Equal(CountHangingPoints({ output }), 0.0, "hanging points around a barrier");
      check.That(
        AreaError(surface, output) < 1e-13, "each cell is covered by its parts, barriers too");
      check.That(
        InterpolationError(output, IsInWall, truth) <= filter->GetInterpolationErrorBound(),
        "the tolerance is met beside a barrier");
      check.That(filter->GetInterpolationErrorBound() <= 0.0005, "the bound is met");
    }
  }
}

/// What is nearest has no value inside barriers, and has one on their rims.
void CheckArrays(Check& check)
{
  for (const bool refine : { false, true })
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetRefineMesh(refine);
    filter->GenerateSourceIdsOn();
    filter->GenerateClosestPointsOn();
    filter->GenerateGradientsOn();
    filter->GenerateSignedDistanceOn();
    RunWithBarriers(check, filter, SquareWithWall(16), PointSources({ Source }), "arrays");
    vtkPolyData* output = filter->GetOutput();
    const auto array = [&](const char* name) { return output->GetPointData()->GetArray(name); };
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Point p = PointAt(output, i);
      const Point closest = TupleAt(array("ClosestSourcePoint"), i);
      const Point gradient = TupleAt(array("DistanceGradient"), i);
      const bool isReached = !IsInWall(p);
      const bool isSource = p == Source;
      check.Equal(array("SourceId")->GetTuple1(i), isReached ? 0.0 : -1.0, "the source's id");
      check.That(
        Length(closest, isReached ? Source : p) < 1e-14, "the closest point of the source");
      check.Near(std::hypot(gradient[0], gradient[1]), (isReached && !isSource ? 1.0 : 0.0), 1e-12,
        "the gradient's length");
      check.Equal(array("SignedGeodesicDistance")->GetTuple1(i),
        array("GeodesicDistance")->GetTuple1(i), "the sign of an isolated point");
    }
  }
}

/// Also with the barrier in another block, whose points are its own.
void CheckBlocks(Check& check)
{
  const auto isLeft = [](const Point& p) { return p[0] < WallBegin; };
  const auto isRight = [](const Point& p) { return p[0] > WallBegin; };
  for (const bool refine : { false, true })
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetRefineMesh(refine);
    filter->SetRefinementTolerance(2e-4);
    auto left = Part(Square(16), isLeft); // without the array
    auto right = WithBarriers(Part(Square(16), isRight), IsInWall);
    RunWithBarriers(check, filter, Blocks({ left, right }), PointSources({ Source }), "blocks");
    const auto outputs = LeavesOf(filter->GetOutputDataObject(0));
    for (std::size_t i = 0; i < 2; ++i)
    {
      CheckTruth(check, outputs.at(i), AroundWall(Source), "block " + std::to_string(i));
    }
    check.Equal(CountHangingPoints(outputs), 0.0, "hanging points in blocks");
    check.That(!refine || CountBarrierParts(outputs[1], IsInWall) > 48,
      "the rim is split in a block of its own");
  }
}

/// Copies by ghost arrays of what is a barrier look like it; whether they are marked does not
/// matter.
void CheckGhostsWithin(Check& check, vtkIdType most)
{
  const double seam = 0.5625; // through the wall
  const auto isBefore = [](const Point& p) { return p[0] < 0.5625; };
  const auto isAfter = [](const Point& p) { return p[0] > 0.5625; };
  const auto none = [](const Point&) { return false; };
  const auto execute = [&](vtkGeodesicDistanceField* filter, vtkDataObject* surface)
  {
    filter->SetMaximumNumberOfCells(most);
    RunWithBarriers(check, filter, surface, PointSources({ Source, { 0.7, 0.4, 0 } }), "ghosts");
  };
  vtkNew<vtkGeodesicDistanceField> plain;
  execute(plain,
    Blocks({ WithBarriers(Part(Square(16), isBefore), IsInWall),
      WithBarriers(Part(Square(16), isAfter), IsInWall) }));
  vtkNew<vtkGeodesicDistanceField> ghosted;
  execute(ghosted,
    Blocks({ WithGhosts(WithBarriers(
                          Part(Square(16), [](const Point& p) { return p[0] < 0.6875; }), IsInWall),
               isAfter),
      WithGhosts(WithBarriers(Part(Square(16), [](const Point& p) { return p[0] > 0.4375; }), none),
        isBefore) }));
  // The second block's own half of the wall is open there, and its copies are not marked.
  const auto trianglesOf = [](vtkAlgorithm* filter, unsigned int block, double begin, double end)
  { return TrianglesIn(Block(filter, block), begin, end); };
  check.That(trianglesOf(ghosted, 1, 0.4375, seam) == trianglesOf(ghosted, 0, 0.4375, seam),
    "copies of a barrier look like it");
  check.That(trianglesOf(ghosted, 0, seam, 0.6875) == trianglesOf(ghosted, 1, seam, 0.6875),
    "copies of what is open look like it");

  vtkNew<vtkGeodesicDistanceField> same;
  execute(same,
    Blocks({ WithGhosts(WithBarriers(
                          Part(Square(16), [](const Point& p) { return p[0] < 0.6875; }), IsInWall),
               isAfter),
      WithBarriers(Part(Square(16), isAfter), IsInWall) }));
  check.That(trianglesOf(same, 0, 0.0, seam) == trianglesOf(plain, 0, 0.0, seam) &&
      trianglesOf(same, 1, seam, 1.0) == trianglesOf(plain, 1, seam, 1.0),
    "barriers with ghosts and without");
}

/// With and without a limit, for which copies do not count.
void CheckGhosts(Check& check)
{
  for (const vtkIdType most : { 0, 660, 800 })
  {
    CheckGhostsWithin(check, most);
  }
}

/// A turned duplicate of a face has the face's parts, and looks where it did before. It stays whole
/// if there would be too many cells; copies by ghost arrays are none of these, and look like their
/// originals all the same.
void CheckDuplicates(Check& check)
{
  const double seam = 0.5625; // through the wall
  const auto isBefore = [seam](const Point& p) { return p[0] < seam; };
  const auto isAfter = [seam](const Point& p) { return p[0] > seam; };
  const auto left = Part(Square(16), [](const Point& p) { return p[0] < 0.6875; });
  const auto right = Part(Square(16), [](const Point& p) { return p[0] > 0.4375; });
  const vtkIdType duplicate = left->GetNumberOfCells();
  vtkNew<vtkIdList> ids;
  left->GetCellPoints(0, ids);
  left->GetPolys()->InsertNextCell({ ids->GetId(1), ids->GetId(0), ids->GetId(2) });
  left->DeleteCells(); // which GetCellPoints() has made
  const auto surface = Blocks({ WithGhosts(WithBarriers(left, IsInWall), isAfter),
    WithGhosts(WithBarriers(right, IsInWall), isBefore) });
  vtkIdType most = 0; // of the cells that are not copies; 0: no limit
  vtkIdType parts = 0;
  for (const char* what : { "no limit", "as many as wanted", "one too few" })
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetMaximumNumberOfCells(most - (what[0] == 'o' ? 1 : 0));
    RunWithBarriers(check, filter, surface, PointSources({ { 0, 0, 0 } }), what);
    check.That(
      TrianglesIn(Block(filter, 1), 0.4375, seam) == TrianglesIn(Block(filter, 0), 0.4375, seam) &&
        TrianglesIn(Block(filter, 0), seam, 0.6875) == TrianglesIn(Block(filter, 1), seam, 0.6875),
      std::string(what) + ": copies look like their originals");
    vtkPolyData* output = Block(filter, 0);
    vtkDataArray* originals = output->GetCellData()->GetArray("OriginalCellIds");
    std::map<vtkIdType, vtkIdType> count;
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      const auto original = static_cast<vtkIdType>(originals->GetTuple1(cell));
      ++count[original];
      const std::vector<Point> p = CornersOf(output, cell);
      const double turn =
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
      check.That((turn > 0.0) == (original != duplicate), "the side of a cell");
    }
    const vtkIdType cells =
      CountBarrierParts(output, isBefore) + CountBarrierParts(Block(filter, 1), isAfter);
    if (most == 0)
    {
      most = cells;
      parts = count[duplicate];
      check.That(parts > 1, "the duplicate is refined");
    }
    const vtkIdType expected = what[0] == 'o' ? 1 : parts;
    check.Equal(count[0], parts, "the face's parts");
    check.Equal(count[duplicate], expected, "the duplicate's parts");
    check.Equal(cells, most - parts + expected, std::string(what) + ": cells that are no copies");
  }
}

/// The boundary is that of the whole; what barriers have of it is left out.
void CheckBoundary(Check& check)
{
  const auto expect = [&](const std::function<bool(const Point&)>& isBarrier, const Distance& truth,
                        const std::string& what)
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->RefineMeshOff();
    const std::string warning =
      RunWithBarriers(check, filter, WithBarriers(Square(8), isBarrier), nullptr, what);
    check.That(warning.empty(), what + ": " + warning);
    CheckTruth(check, filter->GetOutput(), truth, what);
    vtkDataArray* ids = OutputOf(filter, 1)->GetCellData()->GetArray("SourceId");
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      check.Equal(ids->GetTuple1(i), 0.0, what + ": the loop's number");
    }
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const auto isInside = [](const Point& p)
  { return p[0] > 0.25 && p[0] < 0.75 && p[1] > 0.25 && p[1] < 0.75; };
  expect(
    isInside,
    [=](const Point& p) { return isInside(p) ? infinity : DistanceToBoundaryOfSquare(p); },
    "a barrier away from the boundary");
  expect([](const Point& p) { return p[0] < 0.25; },
    [=](const Point& p) {
      return p[0] < 0.25 ? infinity : std::min({ 1.0 - p[0], p[1], 1.0 - p[1] });
    },
    "a barrier along one side");
  // A face that is given twice, once as a barrier, counts as one.
  const auto twice = Mesh({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } },
    { { 0, 1, 2 }, { 0, 1, 2 }, { 0, 2, 3 } });
  AddArrayOf<vtkIntArray>(
    twice->GetCellData(), "barrier", 3, [](vtkIdType cell) { return cell == 1 ? 1 : 0; });
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  RunWithBarriers(check, filter, twice, nullptr, "a face given twice");
  CheckTruth(
    check, filter->GetOutput(), [](const Point&) { return 0.0; }, "a face given twice");
}

void CheckCurveIsJoinedAround(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  RunWithBarriers(check, filter, SquareWithWall(16),
    Polyline({ { 0.4, 0.7, 0 }, { WallBegin, 0.7, 0 }, { 0.7, 0.7, 0 } }),
    "a curve through a wall");
  auto* curve = OutputOf(filter, 1);
  const double length = TotalLength(curve);
  const double around = 0.1 + 0.05 + (WallEnd - WallBegin) + std::hypot(0.7 - WallEnd, 0.05);
  check.Near(length, around, 1e-12, "points on both sides of a wall are joined around it");
}

/// The cap is of all cells, those of barriers too.
void CheckCap(Check& check)
{
  for (const vtkIdType most : { 530, 560, 600, 700 })
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetMaximumNumberOfCells(most);
    filter->SetRefinementTolerance(1e-5);
    const std::string warning = RunWithBarriers(
      check, filter, SquareWithWall(16), PointSources({ { 0.4375, 0.3, 0 } }), "a cap");
    const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
    check.That(cells <= most && cells > 512, "cells under a cap: " + std::to_string(cells));
    check.That(Contains(warning, "is reached"), "the cap: " + warning);
    check.Equal(CountHangingPoints({ filter->GetOutput() }), 0.0, "hanging points under a cap");
  }
}

/// Empty, null and "None" are no barriers, though cells have active scalars.
void CheckNone(Check& check)
{
  auto surface = SquareWithWall(16);
  surface->GetCellData()->SetActiveScalars("barrier");
  const auto filter = PlainField(surface, PointSources({ { 0, 0, 0 } }));
  check.That(!filter->GetBarrierArrayName(), "no barriers by default");
  for (const char* name : { static_cast<const char*>(nullptr), "", "None" })
  {
    filter->SetBarrierArrayName("barrier");
    filter->Update();
    check.That(std::isinf(LargestDistance(filter)), "with barriers");
    filter->SetBarrierArrayName(name);
    filter->Update();
    CheckDistances(
      check, filter, DistanceTo({ { 0, 0, 0 } }), std::string("none: ") + (name ? name : "null"));
  }
}

template <typename Array>
void CheckType(Check& check)
{
  auto surface = SquareWithWall(16);
  vtkDataArray* values = surface->GetCellData()->GetArray("barrier");
  vtkNew<Array> array;
  array->SetName("other");
  array->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    array->SetComponent(i, 0, values->GetComponent(i, 0));
  }
  surface->GetCellData()->AddArray(array);
  const auto filter = PlainField(surface, PointSources({ Source }));
  filter->SetBarrierArrayName("other");
  filter->Update();
  CheckTruth(check, filter->GetOutput(), AroundWall(Source), array->GetClassName());
  // Changed in place, told by the surface alone.
  array->Fill(0);
  surface->Modified();
  filter->Update();
  CheckDistances(check, filter, DistanceTo({ Source }),
    std::string("changed in place: ") + array->GetClassName());
}

/// Where there are other cells than faces, an array may have a value for each cell or for each
/// face. Beside the square with the wall are strips, the lower four of which are barriers.
void CheckValuesOfFaces(Check& check)
{
  auto surface = SquareWithWall(16);
  vtkSmartPointer<vtkDataArray> ofFaces = surface->GetCellData()->GetArray("barrier");
  vtkNew<vtkCellArray> strips;
  surface->GetPoints()->InsertNextPoint(1.0625, 0, 0);
  for (int j = 0; j < 16; ++j)
  {
    const vtkIdType corner = 16 + 17 * j;
    const vtkIdType beside = surface->GetPoints()->InsertNextPoint(1.0625, (j + 1) / 16.0, 0);
    strips->InsertNextCell({ corner, beside - 1, corner + 17, beside });
    ofFaces->InsertTuple1(512 + j, j < 4 ? 1.0 : 0.0);
  }
  const auto truth = [around = AroundWall(Source)](const Point& p)
  { return p[0] > 1.0 && p[1] < 0.25 ? std::numeric_limits<double>::infinity() : around(p); };
  surface->SetVerts(CellArray({ { 0 }, { 1, 2 } }));
  surface->SetLines(CellArray({ { 0, 1, 2 } }));
  surface->SetStrips(strips);
  vtkNew<vtkIntArray> ofCells;
  ofCells->SetName("barrier of cells");
  ofCells->SetNumberOfValues(531);
  ofCells->Fill(1); // of vertices and lines it means nothing
  ofCells->InsertTuples(3, 528, 0, ofFaces);
  surface->GetCellData()->AddArray(ofCells);
  for (const bool isRefined : { false, true })
  {
    vtkNew<vtkPolyData> outputs[2];
    for (const char* name : { "barrier of cells", "barrier" })
    {
      const bool isOfFaces = std::string(name) == "barrier";
      const std::string what = name + std::string(isRefined ? ", refined" : "");
      auto input = vtkSmartPointer<vtkPolyData>::New();
      input->ShallowCopy(surface);
      input->GetCellData()->RemoveArray(isOfFaces ? "barrier of cells" : "barrier");
      const auto filter = RefinedField(input, PointSources({ Source }));
      filter->SetRefineMesh(isRefined);
      filter->SetBarrierArrayName(name);
      RunWithoutError(check, filter, what);
      check.That(
        input->GetCellData()->GetArray("barrier") == (isOfFaces ? ofFaces.Get() : nullptr) &&
          ofFaces->GetNumberOfTuples() == 528,
        what + ": the input keeps its array");
      CheckTruth(check, filter->GetOutput(), truth, what);
      outputs[isOfFaces ? 1 : 0]->ShallowCopy(filter->GetOutput());
    }
    vtkDataArray* expected = outputs[0]->GetCellData()->GetArray("barrier of cells");
    vtkDataArray* handed = outputs[1]->GetCellData()->GetArray("barrier");
    check.That(handed && handed->GetNumberOfTuples() == outputs[1]->GetNumberOfCells() &&
        outputs[0]->GetNumberOfCells() == outputs[1]->GetNumberOfCells(),
      "a value for each face of the output");
    vtkIdType barriers = 0;
    for (vtkIdType i = 0; handed && i < handed->GetNumberOfTuples(); ++i)
    {
      check.Equal(handed->GetTuple1(i), expected->GetTuple1(i), "the value of a face");
      barriers += handed->GetTuple1(i) != 0.0 ? 1 : 0;
    }
    check.That(barriers > 0, "there are barriers in the output");
  }
}

/// The structure is built anew when barriers change, not when other arrays do.
void CheckCache(Check& check)
{
  auto surface = SquareWithWall(8, Cells::Quads);
  vtkNew<vtkDoubleArray> other;
  other->SetName("other");
  other->SetNumberOfTuples(surface->GetNumberOfCells());
  other->Fill(0);
  surface->GetCellData()->AddArray(other);
  const auto filter = PlainField(surface, PointSources({ { 0, 0, 0 } }));
  BuildWatch builds(filter);
  const auto expect = [&](bool built, const std::string& what)
  { builds.Expect(check, built, what); };
  expect(true, "the first time");
  other->SetValue(3, 1.0);
  surface->Modified();
  expect(false, "when another array changes, without barriers");
  filter->SetBarrierArrayName("barrier");
  expect(true, "when barriers are chosen");
  other->SetValue(3, 2.0);
  other->Modified();
  surface->Modified();
  expect(false, "when another array changes");
  filter->SetSourceData(PointSources({ { 1, 1, 0 } }));
  expect(false, "for another source");
  vtkDataArray* barriers = surface->GetCellData()->GetArray("barrier");
  barriers->SetComponent(56, 0, 1.0);
  surface->Modified();
  expect(true, "when a barrier's value changes in place");
  filter->SetBarrierArrayName("None");
  expect(true, "when barriers are gone");
  CheckDistances(check, filter, DistanceTo({ { 1, 1, 0 } }), "when barriers are gone");
}

/// Barriers are surface: the relative tolerance is that of the surface with them.
void CheckTolerance(Check& check)
{
  const auto surface = WithBarriers(Square(8), [](const Point& p) { return p[0] > 0.25; });
  vtkNew<vtkGeodesicDistanceField> filter;
  RunWithBarriers(check, filter, surface, PointSources({ { 0.125, 0.125, 0 } }), "a tolerance");
  const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
  filter->ToleranceIsAbsoluteOn();
  filter->SetAbsoluteRefinementTolerance(0.001 * surface->GetLength());
  filter->Update();
  check.That(cells > surface->GetNumberOfCells(), "a surface with barriers is refined");
  check.That(filter->GetOutput()->GetNumberOfCells() == cells,
    "a relative tolerance is a fraction of the surface with its barriers");
}

/// Each is a test of its own: CMakeLists.txt reads the names from these lines.
const std::map<std::string, void (*)(Check&)> Checks = {
  { "RandomMeshes", CheckRandomMeshes },
  { "Wall", CheckWall },
  { "Arrays", CheckArrays },
  { "Blocks", CheckBlocks },
  { "Ghosts", CheckGhosts },
  { "Duplicates", CheckDuplicates },
  { "Boundary", CheckBoundary },
  { "CurveIsJoinedAround", CheckCurveIsJoinedAround },
  { "Cap", CheckCap },
  { "None", CheckNone },
  { "DoubleArray", CheckType<vtkDoubleArray> },
  { "UnsignedCharArray", CheckType<vtkUnsignedCharArray> },
  { "BitArray", CheckType<vtkBitArray> },
  { "ValuesOfFaces", CheckValuesOfFaces },
  { "Cache", CheckCache },
  { "Tolerance", CheckTolerance },
};

}

int TestGeodesicBarriers(int argc, char* argv[])
{
  Check check;
  const auto found = Checks.find(argc > 1 ? argv[1] : "");
  check.That(found != Checks.end(), "the argument names a check");
  if (found != Checks.end())
  {
    found->second(check);
  }
  return check.Result();
}
