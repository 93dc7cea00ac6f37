// SPDX-License-Identifier: BSD-3-Clause
// A vtkUnstructuredGrid of two-dimensional cells is a surface as the vtkPolyData of the same faces
// is, bit for bit: fields, contours, paths and matrices of random meshes, in blocks, with ghosts
// and barriers. Ids are those of the grid's cells. Other grids are errors that say what to do.
#include "GridTesting.h"

#include "Seeds.h"

#include "vtkAppendFilter.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkStructuredGrid.h"
#include "vtkThreshold.h"

#include <numeric>

using namespace GeodesicTesting;

namespace
{

/// What is asked about a random surface, by each filter.
struct Question
{
  vtkSmartPointer<vtkPolyData> Source;
  vtkSmartPointer<vtkPolyData> Targets;
  int SourceType = vtkGeodesicAlgorithm::SOURCE_CURVE;
  bool HasBarriers = false;
  std::vector<vtkSmartPointer<vtkGeodesicAlgorithm>> Filters() const
  {
    vtkNew<vtkGeodesicDistanceField> plain;
    plain->RefineMeshOff();
    vtkNew<vtkGeodesicDistanceField> refined;
    refined->SetRefinementTolerance(0.005);
    for (vtkGeodesicDistanceField* field : { plain.Get(), refined.Get() })
    {
      field->GenerateSourceIdsOn();
      field->GenerateClosestPointsOn();
      field->GenerateGradientsOn();
      field->GenerateSourceArcLengthOn();
    }
    vtkNew<vtkGeodesicContour> contour;
    contour->SetValue(0, 0.2);
    contour->SetValue(1, 0.5);
    vtkNew<vtkGeodesicPaths> paths;
    paths->SetTargetsData(this->Targets);
    vtkNew<vtkGeodesicDistanceMatrix> matrix;
    matrix->SetTargetsData(this->Targets);
    return { plain, refined, contour, paths, matrix };
  }
  void Ask(vtkGeodesicAlgorithm* filter) const
  {
    filter->SetSourceData(this->Source);
    filter->SetSourceType(this->SourceType);
    filter->SetBarrierArrayName(this->HasBarriers ? "barrier" : nullptr);
  }
};

void CompareOutputs(
  Check& check, vtkGeodesicAlgorithm* a, vtkGeodesicAlgorithm* b, const std::string& what)
{
  for (int port = 0; port < a->GetNumberOfOutputPorts(); ++port)
  {
    if (auto* table = vtkTable::SafeDownCast(a->GetOutputDataObject(port)))
    {
      auto* other = vtkTable::SafeDownCast(b->GetOutputDataObject(port));
      CompareArrays(check, table->GetRowData(), other->GetRowData(), what);
      continue;
    }
    const auto ofA = LeavesOf(a->GetOutputDataObject(port));
    const auto ofB = LeavesOf(b->GetOutputDataObject(port));
    check.That(ofA.size() == ofB.size(), what + ": as many blocks");
    for (std::size_t i = 0; i < std::min(ofA.size(), ofB.size()); ++i)
    {
      check.That(ofA[i] && ofB[i], what + ": a vtkPolyData");
      if (ofA[i] && ofB[i])
      {
        ComparePolyData(check, ofA[i], ofB[i], what + ", port " + std::to_string(port));
      }
    }
  }
}

/// Runs all filters with either form of a surface. \returns how many of them had a result.
int CompareForms(Check& check, vtkDataObject* grid, vtkDataObject* polyData,
  const Question& question, const std::string& name)
{
  const auto forGrid = question.Filters();
  const auto forPolyData = question.Filters();
  int results = 0;
  for (std::size_t i = 0; i < forGrid.size(); ++i)
  {
    const std::string what = name + ", " + forGrid[i]->GetClassName() + " " + std::to_string(i);
    std::vector<std::string> errors;
    for (const auto& [filter, surface] :
      { std::make_pair(forGrid[i], grid), std::make_pair(forPolyData[i], polyData) })
    {
      question.Ask(filter);
      filter->SetInputDataObject(0, surface);
      Messages messages(filter);
      messages.Update();
      errors.push_back(messages.Error());
    }
    check.That(errors[0].empty() == errors[1].empty(), what + ": " + errors[0] + " / " + errors[1]);
    results += errors[0].empty() ? 1 : 0;
    CompareOutputs(check, forGrid[i], forPolyData[i], what);
  }
  return results;
}

Question RandomQuestion(const RandomBarriers& made, bool hasBarriers, geodesictest::Random& random)
{
  Question question;
  question.SourceType = random.chance(0.8) ? vtkGeodesicAlgorithm::SOURCE_CURVE
                                           : vtkGeodesicAlgorithm::CURVE_AND_BOUNDARY;
  question.Source = SourceOf(made.open, RandomSources(made.open, random));
  std::vector<Point> targets;
  for (int i = 0; i < 5; ++i)
  {
    targets.push_back(PositionOf(made.open, geodesictest::randomPoint(made.open, random)));
  }
  question.Targets = PointSources(targets);
  question.HasBarriers = hasBarriers;
  return question;
}

/// \returns how many filters had a result.
int CompareRandom(Check& check, const geodesictest::MeshKind& kind, std::uint64_t seed)
{
  geodesictest::Random random(seed);
  const RandomBarriers made = MakeBarriers(kind, random);
  const auto cells = static_cast<GridKind>(seed % 3);
  const bool hasGhosts = random.chance(0.3);
  const GridAndPolyData surface = GridMaker(made, cells, hasGhosts, random).Make();
  const Question question = RandomQuestion(made, random.chance(0.5), random);
  const std::string name = std::string(kind.name) + ", seed " + std::to_string(seed);
  if (random.chance(0.7))
  {
    const auto grid = surface.Grid();
    if (question.HasBarriers && random.chance(0.5))
    {
      surface.LeaveFacesOnly(grid);
    }
    return CompareForms(check, grid, surface.PolyData(), question, name);
  }
  // In two blocks, of which one is a vtkPolyData always.
  GridAndPolyData halves[] = { surface, surface };
  const auto middle = static_cast<std::ptrdiff_t>(random.below(surface.Cells.size()));
  halves[0].Cells.erase(halves[0].Cells.begin() + middle, halves[0].Cells.end());
  halves[1].Cells.erase(halves[1].Cells.begin(), halves[1].Cells.begin() + middle);
  const std::size_t other = random.below(2);
  const bool arePartitions = random.chance(0.5);
  const auto blocks = [&](bool isGrid)
  {
    vtkNew<vtkMultiBlockDataSet> blocksOfAll;
    vtkNew<vtkPartitionedDataSet> partitions;
    for (unsigned int half = 0; half < 2; ++half)
    {
      const auto block = isGrid && half != other
        ? vtkSmartPointer<vtkDataSet>(halves[half].Grid())
        : vtkSmartPointer<vtkDataSet>(halves[half].PolyData(half == other));
      blocksOfAll->SetBlock(1 + half, block); // the first one is null
      partitions->SetPartition(1 + half, block);
    }
    return arePartitions ? vtkSmartPointer<vtkDataObject>(partitions)
                         : vtkSmartPointer<vtkDataObject>(blocksOfAll);
  };
  return CompareForms(check, blocks(true), blocks(false), question, name + " in blocks");
}

void CheckRandomMeshes(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(geodesictest::meshesOfAKind(6));
  int results = 0;
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      results += CompareRandom(check, kind, seed);
    }
  }
  std::cout << results << " results of grids and of vtkPolyData are the same\n";
  check.That(results > 0, "there are results");
}

vtkSmartPointer<vtkUnstructuredGrid> AsGrid(vtkPolyData* data)
{
  vtkNew<vtkAppendFilter> append; // of one data set
  append->AddInputData(data);
  append->Update();
  return append->GetOutput();
}

/// What a grid has is not copied where the output has it as it is.
void CheckSharing(Check& check)
{
  const auto grid = AsGrid(Square(4));
  AddPointArray(grid);
  AddCellArrays(std::vector<GridCell>(32), std::vector<std::size_t>(32, 0), grid->GetCellData());
  AddArray<vtkIntArray>(grid->GetFieldData(), "Title", { 5 });
  const vtkMTimeType time = grid->GetMTime();
  const auto filter = PlainField(grid, PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  messages.Update();
  vtkPolyData* output = filter->GetOutput();
  check.That(messages.Error().empty() && messages.Warning().empty(),
    "a grid of triangles: " + messages.Error() + messages.Warning());
  check.That(output->GetPoints() == grid->GetPoints(), "the points of a grid are shared");
  check.That(output->GetPolys() == grid->GetCells(), "the triangles of a grid are shared");
  check.That(output->GetPointData()->GetArray("point") == grid->GetPointData()->GetArray("point"),
    "the point arrays of a grid are shared");
  check.That(output->GetCellData()->GetArray("number") == grid->GetCellData()->GetArray("number"),
    "the cell arrays of a grid are shared");
  check.That(output->GetFieldData()->HasArray("Title") != 0, "field data of a grid");
  check.That(grid->GetMTime() == time && !grid->GetFieldData()->HasArray("RelativeErrorBound"),
    "a grid is left untouched");
  CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "a grid of triangles");
}

/// The structure is used again as long as the grid is the same.
void CheckCache(Check& check)
{
  const std::vector<Point> places = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const std::vector<GridCell> cells = { { VTK_LINE, { 0, 1 }, {} },
    { VTK_PIXEL, { 0, 1, 3, 2 }, {} } };
  const std::vector<GridCell> turned = { cells[1], cells[0] };
  const std::vector<GridCell> asQuad = { cells[0], { VTK_QUAD, { 0, 1, 2, 3 }, {} } };
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  BuildWatch builds(filter);
  const auto expect =
    [&](const std::vector<GridCell>& now, const Point& source, int times, const std::string& what)
  {
    filter->SetInputDataObject(0, GridOf(places, now));
    filter->SetSourceData(PointSources({ source }));
    messages.Update();
    check.Equal(builds.Count(), times, what + ": builds");
    CheckDistances(check, filter, DistanceTo({ source }), what);
    vtkDataArray* cell = filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds");
    check.Equal(cell->GetTuple1(0), now[0].Type == VTK_LINE ? 1.0 : 0.0, what + ": the face");
  };
  expect(cells, places[0], 1, "a grid");
  expect(cells, places[2], 0, "another source");
  expect(asQuad, places[1], 0, "the same faces, of another type");
  expect(turned, places[1], 1, "another order of cells");
}

/// Filters that make grids of surfaces.
void CheckFiltersThatMakeGrids(Check& check)
{
  const auto field = [&](vtkAlgorithm* upstream, const Point& source, const std::string& what)
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetInputConnection(upstream->GetOutputPort());
    filter->SetSourceData(PointSources({ source }));
    RunWithoutError(check, filter, what);
    check.That(
      upstream->GetOutputDataObject(0)->IsA("vtkUnstructuredGrid") != 0, what + " gives a grid");
    CheckDistances(check, filter, DistanceTo({ source }), what);
  };
  auto left = Square(8, Cells::Quads);
  AddPointArray(left);
  vtkNew<vtkThreshold> threshold; // to the lower half
  threshold->SetInputData(left);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "point");
  threshold->SetLowerThreshold(44.5);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_LOWER);
  field(threshold, { 0.1, 0.4, 0 }, "a threshold");
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(left);
  const auto right = Moved(Square(8), MovedBy(1.0));
  append->AddInputData(right);
  field(append, { 0.1, 0.4, 0 }, "data sets appended");
}

/// Where cells stand between the corners of quadratic ones.
Point Between(const std::vector<Point>& corners, const std::vector<double>& weights)
{
  Point sum{};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (std::size_t x = 0; x < 3; ++x)
    {
      sum[x] += weights[i] * corners[i][x];
    }
  }
  return sum;
}

/// Cells with points on their edges become triangles through all of these, in one orientation.
void CheckCurvedCells(Check& check)
{
  const std::vector<Point> square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const auto nodes = [&square](std::size_t corners, const std::vector<std::vector<double>>& between)
  {
    const std::vector<Point> own(
      square.begin(), square.begin() + static_cast<std::ptrdiff_t>(corners));
    std::vector<Point> all = own;
    for (const std::vector<double>& weights : between)
    {
      all.push_back(Between(own, weights));
    }
    return all;
  };
  const std::vector<std::vector<double>> ofTriangle = { { .5, .5, 0 }, { 0, .5, .5 },
    { .5, 0, .5 } };
  auto andCentre = ofTriangle;
  andCentre.push_back({ 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 });
  const std::vector<std::vector<double>> ofQuad = { { .5, .5, 0, 0 }, { 0, .5, .5, 0 },
    { 0, 0, .5, .5 }, { .5, 0, 0, .5 } };
  auto andMiddle = ofQuad;
  andMiddle.push_back({ .25, .25, .25, .25 });
  const std::vector<std::vector<double>> ofLinearQuad = { ofQuad[0], ofQuad[2] };
  struct Curved
  {
    int Type;
    std::vector<Point> Nodes;
    double Area;
  };
  for (const Curved& one : { Curved{ VTK_QUADRATIC_TRIANGLE, nodes(3, ofTriangle), 0.5 },
         Curved{ VTK_BIQUADRATIC_TRIANGLE, nodes(3, andCentre), 0.5 },
         Curved{ VTK_LAGRANGE_TRIANGLE, nodes(3, ofTriangle), 0.5 },
         Curved{ VTK_QUADRATIC_QUAD, nodes(4, ofQuad), 1.0 },
         Curved{ VTK_BIQUADRATIC_QUAD, nodes(4, andMiddle), 1.0 },
         Curved{ VTK_QUADRATIC_LINEAR_QUAD, nodes(4, ofLinearQuad), 1.0 },
         Curved{ VTK_LAGRANGE_QUADRILATERAL, nodes(4, andMiddle), 1.0 },
         Curved{ VTK_QUADRATIC_POLYGON, nodes(4, ofQuad), 1.0 } })
  {
    const std::string what = "cells of type " + std::to_string(one.Type);
    std::vector<vtkIdType> ids(one.Nodes.size());
    std::iota(ids.begin(), ids.end(), vtkIdType(0));
    GridAndPolyData surface{ one.Nodes, { { VTK_VERTEX, { 0 }, {} }, { one.Type, ids, {} } } };
    for (const bool isRefined : { false, true })
    {
      const auto filter =
        RefinedField(surface.Grid(), Polyline({ { 0, 0, 0 }, { 0.25, 0.125, 0 } }));
      filter->SetRefineMesh(isRefined);
      filter->GenerateSignedDistanceOn(); // needs one orientation
      Messages messages(filter);
      messages.ExpectNoError(check, what);
      check.That(Contains(messages.Warning(), "1 vertex cell") &&
          !Contains(messages.Warning(), "two corners"),
        what + ": " + messages.Warning());
      CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 }, { 0.25, 0.125, 0 } }), what);
      vtkPolyData* output = filter->GetOutput();
      double area = 0.0;
      for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
      {
        const std::vector<Point> c = CornersOf(output, i);
        area += 0.5 *
          ((c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]));
        check.Equal(CellValue(output, "number", i), 1.0, what + ": the cell that a triangle is of");
      }
      check.Near(area, one.Area, 1e-12, what + ": area");
    }
  }
}

/// The points between the corners need not lie in their plane.
void CheckBentTriangle(Check& check)
{
  GridAndPolyData surface{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.5, 0, 0.3 },
                             { 0.5, 0.5, 0.3 }, { 0, 0.5, 0.3 } },
    { { VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 3, 4, 5 },
      { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 }, { 4, 5, 3 } } } } };
  std::vector<double> distances[2];
  for (const bool isGrid : { false, true })
  {
    const auto filter = PlainField(isGrid ? vtkSmartPointer<vtkDataObject>(surface.Grid())
                                          : vtkSmartPointer<vtkDataObject>(surface.PolyData()),
      PointSources({ { 0, 0, 0 } }));
    filter->Update();
    distances[isGrid ? 1 : 0] = NumbersOf(Distances(filter));
  }
  for (std::size_t i = 0; i < 6; ++i)
  {
    check.Near(distances[0][i], distances[1][i], 1e-14, "a bent quadratic triangle");
  }
}

/// A grid is the source or the targets, too.
void CheckOneGridOnAllPorts(Check& check)
{
  const auto grid = GridOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    { { VTK_QUAD, { 0, 1, 2, 3 }, {} }, { VTK_LINE, { 0, 1 }, {} } });
  vtkNew<vtkGeodesicPaths> paths;
  for (int port = 0; port < 3; ++port)
  {
    paths->SetInputDataObject(port, grid);
  }
  Messages messages(paths);
  messages.ExpectNoError(check, "one grid on all ports");
  check.That(Contains(messages.Warning(), "1 line among the surface's cells"),
    "one grid: " + messages.Warning());
  vtkDataArray* lengths = paths->GetOutput()->GetCellData()->GetArray("GeodesicDistance");
  for (vtkIdType i = 0; i < 4; ++i)
  {
    check.Equal(lengths->GetTuple1(i), 0.0, "a path of one grid");
    const double id = CellValue(paths->GetOutput(), "SourceId", i);
    check.That(id == 0.0 || (i < 2 && id == 1.0), "the grid's cell is the source");
  }
}

void CheckErrors(Check& check)
{
  const std::vector<Point> places = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 1, 0 } };
  const GridCell triangle{ VTK_TRIANGLE, { 0, 1, 2 }, {} };
  const auto withCell = [&](int type, const std::vector<vtkIdType>& ids) {
    return GridOf(places, { triangle, { VTK_LINE, { 0, 1 }, {} }, { type, ids, {} }, triangle });
  };
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  const auto expect = [&](vtkDataObject* surface, const std::vector<std::string>& words)
  {
    filter->SetInputDataObject(0, surface);
    messages.ExpectError(check, words, "a grid that is no surface");
    for (vtkPolyData* leaf : LeavesOf(filter->GetOutputDataObject(0)))
    {
      check.Equal(leaf->GetNumberOfPoints(), 0.0, "points after an error");
    }
  };
  const auto tetra = withCell(VTK_TETRA, { 0, 1, 2, 3 });
  expect(tetra,
    { "Cell 2 of the surface (input port 0) is three-dimensional", "vtkTetra", "Extract Surface" });
  expect(withCell(VTK_QUADRATIC_TETRA, std::vector<vtkIdType>(10, 0)),
    { "Cell 2 of", "vtkQuadraticTetra", "Extract Surface" });
  const auto blocks = Blocks({ Square(2), tetra });
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "fluid");
  expect(blocks,
    { "Cell 2 of block 2 (fluid) of the surface (input port 0) is three-dimensional",
      "Extract Surface" });
  expect(withCell(VTK_TRIANGLE, { 0, 1, 7 }), { "Cell 2 of the surface", "point 7", "5 points" });
  expect(withCell(VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 3, 4, 9 }),
    { "Cell 2 of the surface", "point 9", "5 points" });
  expect(withCell(VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 3 }),
    { "Cell 2 of the surface", "is of type 22", "cannot be cut", "there are 4" });
  expect(withCell(VTK_LAGRANGE_TRIANGLE, { 0, 1, 2, 3, 4 }),
    { "Cell 2 of the surface", "is of type 69", "cannot be cut", "there are 5" });
  const auto withTypes = [&](const std::vector<unsigned char>& types)
  {
    const auto grid = GridOf(places, { triangle, triangle });
    vtkNew<vtkUnsignedCharArray> ofCells;
    for (const unsigned char type : types)
    {
      ofCells->InsertNextValue(type);
    }
    vtkNew<vtkCellArray> cells;
    cells->ShallowCopy(grid->GetCells());
    grid->SetCells(ofCells, cells);
    return grid;
  };
  expect(withTypes({ VTK_TRIANGLE, 200 }), { "Cell 1 of the surface", "type 200" });
  expect(withTypes({ VTK_TRIANGLE }), { "Cell 1 of the surface", "no type" });
  expect(GridOf(places, { { VTK_LINE, { 0, 1 }, {} } }), { "no faces", "lines" });
  expect(GridOf(places, {}), { "5 points and no faces" });
  expect(GridOf(places, { { VTK_EMPTY_CELL, {}, {} } }), { "5 points and no faces" });
  expect(vtkNew<vtkUnstructuredGrid>(), { "empty" });
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(2, 2, 1);
  structured->SetPoints(Square(1)->GetPoints());
  expect(structured, { "is a vtkStructuredGrid", "Extract Surface" });

  filter->SetInputDataObject(0, GridOf(places, { triangle }));
  messages.ExpectNoError(check, "after errors");
}

}

int TestGeodesicGrids(int, char*[])
{
  Check check;
  CheckRandomMeshes(check);
  CheckSharing(check);
  CheckCache(check);
  CheckFiltersThatMakeGrids(check);
  CheckCurvedCells(check);
  CheckBentTriangle(check);
  CheckOneGridOnAllPorts(check);
  CheckErrors(check);
  return check.Result();
}
