// SPDX-License-Identifier: BSD-3-Clause
// Faces without area: distances are those of the surface without them, outputs keep the input's
// cells, and refined seams of blocks beside them fit.
// GEODESIC_TEST_SEEDS=FIRST,COUNT takes other seeds.
#include "BarrierTesting.h"
#include "RandomBarriers.h"
#include "Seeds.h"

#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkIdTypeArray.h"
#include "vtkTable.h"

using namespace GeodesicTesting;

namespace
{

/// The last face lies on a line: point 5 is in the middle of the edge from 2 to 3. A shortest path
/// bends there and crosses the face.
vtkSmartPointer<vtkPolyData> Folded()
{
  return Mesh({ { 0, 12, 0 }, { 0, 16, 0 }, { 4, 12, 2 }, { 4, 16, 2 }, { 8, 12, 2 }, { 4, 14, 2 },
                { 16.0 / 3.0, 14, 3 } },
    { { 0, 2, 3 }, { 0, 3, 1 }, { 3, 5, 6 }, { 5, 4, 6 }, { 2, 5, 3 } });
}

void CheckMatrixAndPaths(Check& check)
{
  const double truth = std::sqrt(20.0) + std::sqrt(24.0);
  const auto matrix =
    FilterOn<vtkGeodesicDistanceMatrix>(Folded(), PointSources({ { 8, 12, 2 }, { 0, 16, 0 } }));
  matrix->Update();
  for (vtkIdType row = 0; row < 2; ++row)
  {
    const double distance =
      matrix->GetOutput()->GetValueByName(row, row == 0 ? "Source1" : "Source0").ToDouble();
    check.Near(distance, truth, 1e-13, "matrix: there and back");
  }
  const auto paths = FilterOn<vtkGeodesicPaths>(Folded(), PointSources({ { 8, 12, 2 } }));
  paths->SetTargetsData(PointSources({ { 0, 16, 0 } }));
  paths->GenerateFaceIdsOn();
  paths->Update();
  vtkPolyData* path = paths->GetOutput();
  check.Near(TotalLength(path), truth, 1e-13, "path: its length");
  vtkDataArray* faces = path->GetPointData()->GetArray("FaceId");
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    check.That(faces->GetTuple1(i) < 4, "path: goes through faces with area");
  }
}

/// The last face lies on a line, inside or at the boundary; the one before is a barrier.
void CheckBoundaryWithBarriers(Check& check)
{
  const auto expect = [&](const vtkSmartPointer<vtkPolyData>& surface,
                        const std::vector<double>& truth, const std::string& what)
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->RefineMeshOff();
    RunWithBarriers(check, filter, WithBarriers(surface, [](const Point& p) { return p[0] > 6.5; }),
      nullptr, what);
    vtkDataArray* distances = Distances(filter);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      // Where the face is removed, points move by a millionth of a millionth.
      check.Near(distances->GetTuple1(static_cast<vtkIdType>(i)), truth[i], 1e-11, what);
    }
  };
  expect(Mesh({ { 0, 0, 0 }, { 8, 0, 0 }, { 8, 8, 0 }, { 0, 8, 0 }, { 2, 4, 0 }, { 6, 4, 0 },
                { 4, 4, 0 } },
           { { 0, 1, 5 }, { 0, 5, 4 }, { 4, 6, 3 }, { 6, 2, 3 }, { 6, 5, 2 }, { 0, 4, 3 },
             { 1, 2, 5 }, { 4, 5, 6 } }),
    { 0, 0, 0, 0, 2, 4, 4 }, "a face without area inside");
  expect(Mesh({ { 0, 0, 0 }, { 8, 8, 0 }, { 0, 8, 0 }, { 4, 0, 0 }, { 8, 0, 0 } },
           { { 0, 3, 2 }, { 3, 1, 2 }, { 3, 4, 1 }, { 0, 4, 3 } }),
    { 0, 0, 0, 0 }, "a face without area at the boundary");
}

void CheckUnrefinedCells(Check& check)
{
  const vtkSmartPointer<vtkPolyData> surface = Folded();
  const auto filter = PlainField(surface, PointSources({ { 8, 12, 2 } }));
  filter->Update();
  check.That(filter->GetOutput()->GetPolys() == surface->GetPolys(),
    "unrefined: the cells are the input's own");
}

void CheckRefined(
  Check& check, const std::vector<vtkSmartPointer<vtkPolyData>>& blocks, const std::string& name)
{
  vtkNew<vtkMultiBlockDataSet> surface;
  for (unsigned int i = 0; i < blocks.size(); ++i)
  {
    surface->SetBlock(i, blocks[i]);
  }
  const Point source = { 0.7, 0.2, 0 };
  const auto filter = RefinedField(surface, PointSources({ source }));
  filter->SetRefinementTolerance(0.002);
  filter->GenerateSourceIdsOn();
  filter->GenerateGradientsOn();
  filter->Update();
  std::set<Point> onDiagonal[2];
  for (unsigned int i = 0; i < blocks.size(); ++i)
  {
    vtkPolyData* block = Block(filter, i);
    vtkDataArray* distances = block->GetPointData()->GetArray("GeodesicDistance");
    vtkDataArray* gradients = block->GetPointData()->GetArray("DistanceGradient");
    vtkDataArray* cells = block->GetCellData()->GetArray("OriginalCellIds");
    check.Equal(block->GetPointData()->GetArray("SourceId")->GetRange()[0], 0.0, name + ": ids");
    std::set<vtkIdType> original;
    for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
    {
      original.insert(static_cast<vtkIdType>(cells->GetTuple1(cell)));
    }
    check.Equal(original.size(), blocks[i]->GetNumberOfCells(), name + ": every cell is there");
    for (vtkIdType point = 0; point < block->GetNumberOfPoints(); ++point)
    {
      const Point p = PointAt(block, point);
      const double truth = std::hypot(p[0] - source[0], p[1] - source[1]);
      check.Near(distances->GetTuple1(point), truth, 1e-14, name + ": the distance");
      const double error =
        std::hypot(gradients->GetComponent(point, 0) - (p[0] - source[0]) / truth,
          gradients->GetComponent(point, 1) - (p[1] - source[1]) / truth);
      check.That(truth == 0.0 || error < 1e-7, name + ": the gradient");
      if (p[0] == p[1])
      {
        onDiagonal[i].insert(p);
      }
    }
  }
  check.That(onDiagonal[0].size() > 5, name + ": the diagonal is refined");
  check.That(blocks.size() == 1 || onDiagonal[0] == onDiagonal[1], name + ": both sides fit");
}

/// A square with a point on its diagonal, or a second point at its corner, which only the upper
/// half has, and a flat cell between. In blocks the halves are apart, and the flat cell is the
/// upper one's.
void CheckRefinedSurfaces(Check& check)
{
  using Triangles = std::vector<std::array<vtkIdType, 3>>;
  const std::tuple<std::string, Point, Triangles> uppers[] = {
    { "a cap", { 0.25, 0.25, 0 }, { { 0, 2, 4 }, { 0, 4, 3 }, { 4, 2, 3 } } },
    { "a needle", { 1, 1 + 3e-16, 0 }, { { 0, 2, 4 }, { 0, 4, 3 } } },
  };
  for (const auto& [name, point, upper] : uppers)
  {
    const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, point };
    const Triangles lower = { { 0, 1, 2 } };
    Triangles both = lower;
    both.insert(both.end(), upper.begin(), upper.end());
    CheckRefined(check, { Mesh(points, both) }, name + " in one block");
    CheckRefined(
      check, { Mesh(points, lower), Mesh(points, upper) }, name + " in one of two blocks");
    for (const vtkIdType most : { 40, 50, 60, 70 })
    {
      const auto filter = RefinedField(Mesh(points, both), PointSources({ { 0.7, 0.2, 0 } }));
      filter->SetRefinementTolerance(1e-5);
      filter->SetMaximumNumberOfCells(most);
      Messages messages(filter);
      messages.Update();
      const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
      check.That(cells <= most && cells > most / 2,
        name + " counts as cells: " + std::to_string(cells) + " of " + std::to_string(most));
    }
  }
}

/// Compares the distances at a block's points with the truth, by brute force on the surface without
/// faces that have no area.
/// \returns the largest error.
double ErrorOfBlock(const RandomCase& one, vtkPolyData* block, const std::vector<double>& truth)
{
  const std::vector<bool> isOutside = PointsOutsideBarriers(one.made);
  vtkDataArray* distances = block->GetPointData()->GetArray("GeodesicDistance");
  double worst = 0.0;
  for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    block->GetCellPoints(cell, ids);
    for (const vtkIdType id : { ids->GetId(0), ids->GetId(1), ids->GetId(2) })
    {
      const auto expected = TruthAt(one.made, isOutside, truth, static_cast<std::size_t>(id));
      worst = expected ? std::max(worst, ErrorOf(distances->GetTuple1(id), *expected)) : worst;
    }
  }
  return worst;
}

/// Caps, fins, pockets and needles of all offsets, across blocks and beside barriers.
void CheckRandomSurfaces(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(4);
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    double worst = 0.0;
    int compared = 0;
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      RandomCase one(kind, seed, true);
      one.filter->RefineMeshOff();
      if (!one.CanRun(check) || one.IsSourceOpen())
      {
        continue;
      }
      const std::vector<double> truth =
        geodesictest::bruteForceDistances(one.made.open, one.sources).vertices;
      double error = 0.0;
      for (vtkPolyData* block : LeavesOf(one.filter->GetOutputDataObject(0)))
      {
        error = std::max(error, ErrorOfBlock(one, block, truth));
      }
      error /= std::max(1.0, LargestFinite(truth));
      check.That(error <= one.accuracy, one.name + ": wrong by " + std::to_string(error));
      worst = std::max(worst, error);
      ++compared;
    }
    std::cout << kind.name << ": worst relative error " << worst << " of " << compared << "\n";
  }
}

/// After refinement the parts of each cell cover it.
void CheckRefinedRandomSurfaces(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(4);
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      RandomCase one(kind, seed, true);
      one.filter->SetRefinementTolerance(0.01);
      if (!one.CanRun(check))
      {
        continue;
      }
      const auto before = LeavesOf(one.filter->GetInputDataObject(0, 0));
      const auto after = LeavesOf(one.filter->GetOutputDataObject(0));
      for (std::size_t i = 0; i < before.size(); ++i)
      {
        bool hasArea = false;
        for (vtkIdType cell = 0; cell < before[i]->GetNumberOfCells(); ++cell)
        {
          hasArea = hasArea || AreaOf(before[i], cell) > 1e-9;
        }
        check.That(!hasArea || AreaError(before[i], after.at(i)) < 1e-9,
          one.name + ": parts of cells cover them in block " + std::to_string(i));
      }
    }
  }
}

} // anonymous namespace

int TestGeodesicFlatFaces(int, char*[])
{
  Check check;
  CheckMatrixAndPaths(check);
  CheckBoundaryWithBarriers(check);
  CheckUnrefinedCells(check);
  CheckRefinedSurfaces(check);
  CheckRandomSurfaces(check);
  CheckRefinedRandomSurfaces(check);
  return check.Result();
}
