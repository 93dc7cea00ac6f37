// SPDX-License-Identifier: BSD-3-Clause
// FaceId of paths: each piece lies in the cell of the input that its first point names, on random
// meshes with barriers, in blocks, quads and strips, beside cells that are no surface.
#include "PathFaces.h"
#include "RandomBarriers.h"

#include "Seeds.h"

#include "vtkGeodesicPaths.h"
#include "vtkMultiBlockDataSet.h"

using namespace GeodesicTesting;

namespace
{

/// Of the diagonal of the surface: what a place in a face is off it by rounding.
constexpr double OffFace = 2e-15;

double DiagonalOf(vtkPolyData* surface)
{
  surface->ComputeBounds();
  return surface->GetLength();
}

/// A vertex and a line before the faces, which move the numbers of these.
void AddOtherCells(vtkPolyData* surface)
{
  surface->SetVerts(CellArray({ { 0 } }));
  surface->SetLines(CellArray({ { 0, 1 } }));
}

/// Blocks with the faces at random, each with its own points; block 1 is null, block 2 has other
/// cells, too.
///
/// \param faceOf filled with the face of each cell in the order of all blocks, or -1.
vtkSmartPointer<vtkMultiBlockDataSet> AtRandomInBlocks(
  const RandomBarriers& made, geodesictest::Random& random, std::vector<std::ptrdiff_t>& faceOf)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  std::vector<unsigned int> blockOf(made.surface.triangles.size());
  for (unsigned int& block : blockOf)
  {
    block = std::array<unsigned int, 3>{ 0, 2, 3 }[random.below(3)];
  }
  for (const unsigned int index : { 0U, 2U, 3U })
  {
    RandomBarriers part;
    part.surface.points = made.surface.points;
    const std::ptrdiff_t others = index == 2 ? 2 : 0;
    faceOf.insert(faceOf.end(), static_cast<std::size_t>(others), -1);
    for (std::size_t face = 0; face < blockOf.size(); ++face)
    {
      if (blockOf[face] == index)
      {
        part.surface.triangles.push_back(made.surface.triangles[face]);
        part.isBarrier.push_back(made.isBarrier[face]);
        faceOf.push_back(static_cast<std::ptrdiff_t>(face));
      }
    }
    const auto block = SurfaceOf(part);
    if (others > 0)
    {
      AddOtherCells(block);
      // Cell data of all cells: vertices and lines are no barriers.
      std::vector<int> barriers(static_cast<std::size_t>(others), 0);
      barriers.insert(barriers.end(), part.isBarrier.begin(), part.isBarrier.end());
      AddArray<vtkIntArray>(block->GetCellData(), "barrier", barriers);
    }
    blocks->SetBlock(index, block);
  }
  return blocks;
}

/// \param pieces how many there are is added.
/// \returns the error, of the diagonal.
double CheckRandom(
  Check& check, const geodesictest::MeshKind& kind, std::uint64_t seed, vtkIdType& pieces)
{
  const std::string name = std::string(kind.name) + ", seed " + std::to_string(seed);
  geodesictest::Random random(seed);
  const RandomBarriers made = MakeBarriers(kind, random);
  const geodesictest::Sources sources = RandomSources(made.open, random);
  const auto surface = SurfaceOf(made);
  std::vector<Point> targets;
  for (int i = 0; i < 12; ++i)
  {
    targets.push_back(PositionOf(made.open, geodesictest::randomPoint(made.open, random)));
  }
  if (!sources.points.empty())
  {
    targets.push_back(PositionOf(made.open, sources.points.front())); // two equal points
  }
  std::vector<std::ptrdiff_t> faceOf;
  const bool isInBlocks = random.chance(0.5);
  const auto blocks = AtRandomInBlocks(made, random, faceOf);
  const auto filter = FilterOn<vtkGeodesicPaths>(
    isInBlocks ? static_cast<vtkDataObject*>(blocks.Get()) : surface.Get(),
    SourceOf(made.open, sources));
  filter->GenerateFaceIdsOn();
  filter->SetMergeCoincidentPoints(isInBlocks);
  filter->SetBarrierArrayName("barrier");
  filter->SetTargetsData(PointSources(targets));
  RunWithoutError(check, filter, name);
  pieces += filter->GetOutput()->GetNumberOfPoints() - filter->GetOutput()->GetNumberOfLines();
  const double error = CheckFacesOfPaths(
    check, filter->GetOutput(),
    [&](vtkIdType cell)
    {
      const auto number = static_cast<std::size_t>(cell);
      const std::ptrdiff_t face = !isInBlocks ? static_cast<std::ptrdiff_t>(cell)
        : cell >= 0 && number < faceOf.size() ? faceOf[number]
                                              : -1;
      if (face < 0 || face >= surface->GetNumberOfCells() ||
        made.isBarrier[static_cast<std::size_t>(face)])
      {
        return std::vector<Corners>();
      }
      return TrianglesOfCell(surface, face);
    },
    name);
  const double relative = error / DiagonalOf(surface);
  check.That(relative <= OffFace,
    name + (isInBlocks ? ", in blocks" : "") + ": pieces are off their faces by " +
      std::to_string(relative * 1e15) + "e-15 of the diagonal");
  return relative;
}

void CheckRandomMeshes(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(geodesictest::meshesOfAKind(40));
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    double worst = 0.0;
    vtkIdType pieces = 0;
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      worst = std::max(worst, CheckRandom(check, kind, seed, pieces));
    }
    check.That(pieces > 0, std::string("there are paths on ") + kind.name);
    std::cout << pieces << " pieces off their faces on " << kind.name << ": " << worst << "\n";
  }
}

/// Triangles, quads that are not flat, and strips, behind cells of other kinds.
void CheckKindsOfCells(Check& check)
{
  for (const Cells cells : { Cells::Triangles, Cells::Quads, Cells::Strips })
  {
    const std::string name = "cells of kind " + std::to_string(static_cast<int>(cells));
    const auto surface = NoisySquare(12, cells);
    AddOtherCells(surface);
    std::vector<Point> targets;
    for (int i = 0; i < 60; ++i)
    {
      targets.push_back({ 0.5 + 0.5 * std::sin(1.7 * i), 0.5 + 0.5 * std::cos(2.9 * i), 0.0 });
    }
    const auto filter =
      FilterOn<vtkGeodesicPaths>(surface, Polyline({ { 0.3, 0.2, 0.0 }, { 0.4, 0.9, 0.0 } }));
    filter->SetTargetsData(PointSources(targets));
    filter->Update();
    check.That(
      !filter->GetGenerateFaceIds() && !filter->GetOutput()->GetPointData()->HasArray("FaceId"),
      name + ": FaceId is not there by default");
    filter->GenerateFaceIdsOn();
    filter->Update();
    check.Equal(filter->GetOutput()->GetNumberOfLines(), 60.0, name + ": targets that are reached");
    const double error = CheckFacesOfPaths(
      check, filter->GetOutput(),
      [&](vtkIdType cell)
      {
        return cell >= 2 && cell < surface->GetNumberOfCells() ? TrianglesOfCell(surface, cell)
                                                               : std::vector<Corners>();
      },
      name);
    check.That(error <= 1e-14, name + ": pieces are off their cells by " + std::to_string(error));
  }
}

/// A target on the source has the face of that point twice; without any paths the array is empty.
void CheckPoints(Check& check)
{
  const auto surface = Square(2);
  const auto filter = FilterOn<vtkGeodesicPaths>(surface, PointSources({ { 0.7, 0.6, 0.0 } }));
  filter->GenerateFaceIdsOn();
  filter->SetTargetsData(PointSources({ { 0.7, 0.6, 0.0 } }));
  filter->Update();
  vtkDataArray* cells = filter->GetOutput()->GetPointData()->GetArray("FaceId");
  check.That(
    cells->GetNumberOfTuples() == 2 && cells->GetTuple1(0) == 6.0 && cells->GetTuple1(1) == 6.0,
    "a target on the source: its face, twice");

  filter->SetInputData(Blocks({ surface, Moved(Square(1), MovedBy(5.0)) }));
  filter->SetTargetsData(PointSources({ { 5.5, 0.25, 0.0 } }));
  Messages messages(filter);
  messages.Update();
  cells = filter->GetOutput()->GetPointData()->GetArray("FaceId");
  check.That(cells && cells->GetNumberOfTuples() == 0, "no path: an empty array");
  filter->SetSourceData(PointSources({ { 5.25, 0.125, 0.0 } }));
  messages.Update();
  cells = filter->GetOutput()->GetPointData()->GetArray("FaceId");
  check.That(cells->GetNumberOfTuples() == 2 && cells->GetTuple1(0) == 8.0,
    "cells of the second block follow the eight of the first");
}

}

int TestGeodesicPathFaces(int, char*[])
{
  Check check;
  CheckRandomMeshes(check);
  CheckKindsOfCells(check);
  CheckPoints(check);
  return check.Result();
}
