// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: pieces that are unstructured grids, on some ranks, give what the same pieces give as
// vtkPolyData, bit for bit: fields, contours and paths, with ghost cells, global ids and barriers.
#include "GridTesting.h"
#include "RanksTesting.h"

#include "Seeds.h"

#include "vtkGeodesicContour.h"
#include "vtkGeodesicPaths.h"

using namespace GeodesicTesting;

namespace
{

using Random = std::mt19937_64;

/// The triangles of a piece, whose number in the grid becomes the array "number", with a line
/// before some of them.
vtkSmartPointer<vtkUnstructuredGrid> AsGrid(vtkPolyData* piece, Random& random)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(piece->GetPoints());
  grid->GetPointData()->ShallowCopy(piece->GetPointData());
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("number");
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < piece->GetNumberOfPolys(); ++face)
  {
    piece->GetPolys()->GetCellAtId(face, ids);
    if (random() % 4 == 0)
    {
      grid->InsertNextCell(VTK_LINE, 2, ids->GetPointer(0));
    }
    numbers->InsertNextValue(grid->InsertNextCell(VTK_TRIANGLE, ids));
  }
  piece->GetCellData()->AddArray(numbers);
  for (int i = 0; i < piece->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* ofPiece = piece->GetCellData()->GetArray(i);
    const auto ofGrid =
      vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(ofPiece->GetDataType()));
    ofGrid->SetName(ofPiece->GetName());
    ofGrid->SetNumberOfTuples(grid->GetNumberOfCells());
    ofGrid->Fill(1.0); // of lines it means nothing
    for (vtkIdType face = 0; face < piece->GetNumberOfPolys(); ++face)
    {
      ofGrid->SetTuple(numbers->GetValue(face), face, ofPiece);
    }
    grid->GetCellData()->AddArray(ofGrid);
  }
  return grid;
}

vtkSmartPointer<vtkPolyData> SurfaceWithBarriers(Random& random)
{
  auto surface = NoisySquare(8);
  AddArrayOf<vtkIntArray>(surface->GetCellData(), "barrier", surface->GetNumberOfPolys(),
    [&](vtkIdType face) { return face > 1 && random() % 10 == 0 ? 1 : 0; });
  return surface;
}

std::vector<vtkSmartPointer<vtkGeodesicAlgorithm>> Filters()
{
  vtkNew<vtkGeodesicDistanceField> plain;
  plain->RefineMeshOff();
  plain->GenerateSourceIdsOn();
  vtkNew<vtkGeodesicDistanceField> refined;
  vtkNew<vtkGeodesicContour> contour;
  contour->SetValue(0, 0.4);
  vtkNew<vtkGeodesicPaths> paths;
  paths->SetTargetsData(PointSources({ { 0.9, 0.8, 0 }, { 0.4, 0.7, 0 } }));
  return { plain, refined, contour, paths };
}

void CheckSeed(Check& check, Ranks ranks, std::uint64_t seed)
{
  Random random(seed); // the same on all ranks
  const auto surface = SurfaceWithBarriers(random);
  const Cut cut = random() % 2 == 0 ? AtRandom(ranks.Count) : Strips(surface, ranks.Count);
  const bool hasGlobalIds = random() % 2 == 0;
  const auto piece = random() % 2 == 0 ? PartWithGhosts(surface, cut, ranks.Rank, hasGlobalIds)
                                       : PieceOf(surface, cut, ranks.Rank, hasGlobalIds);
  const bool isGrid = (random() + static_cast<std::uint64_t>(ranks.Rank)) % 3 != 0;
  const auto grid = AsGrid(piece, random);
  const auto source = Polyline({ CentreOf(surface, 0), CentreOf(surface, 1) });
  const auto forPolyData = Filters();
  const auto forGrids = Filters();
  for (std::size_t i = 0; i < forGrids.size(); ++i)
  {
    const std::string what =
      "seed " + std::to_string(seed) + ", filter " + std::to_string(i) + ", grids on ranks";
    for (const auto& filter : { forPolyData[i], forGrids[i] })
    {
      const bool takesGrid = isGrid && filter == forGrids[i];
      filter->SetInputDataObject(0,
        takesGrid ? vtkSmartPointer<vtkDataObject>(grid) : vtkSmartPointer<vtkDataObject>(piece));
      filter->SetSourceData(source);
      filter->SetBarrierArrayName("barrier");
      RunWithoutError(check, filter, what);
    }
    for (int port = 0; port < forGrids[i]->GetNumberOfOutputPorts(); ++port)
    {
      auto* ofGrid = vtkPolyData::SafeDownCast(forGrids[i]->GetOutputDataObject(port));
      auto* ofPolyData = vtkPolyData::SafeDownCast(forPolyData[i]->GetOutputDataObject(port));
      check.That(ofGrid && ofPolyData, what + ": a vtkPolyData");
      if (isGrid)
      {
        ComparePolyData(check, ofGrid, ofPolyData, what);
      }
    }
  }
}

/// A rank that has a volume tells all others.
void CheckVolume(Check& check, Ranks ranks)
{
  const auto surface = Square(4);
  vtkNew<vtkUnstructuredGrid> volume;
  volume->SetPoints(Tetrahedron()->GetPoints());
  const vtkIdType ids[] = { 0, 1, 2, 3 };
  volume->InsertNextCell(VTK_TETRA, 4, ids);
  const auto filter = RefinedField(ranks.Rank == ranks.Count - 1
      ? vtkSmartPointer<vtkDataObject>(volume)
      : vtkSmartPointer<vtkDataObject>(PieceOf(surface, AtRandom(ranks.Count), ranks.Rank)),
    PointSources({ { 0, 0, 0 } }));
  Messages(filter).ExpectError(
    check, { "vtkTetra", "Extract Surface" }, "all ranks tell of a volume");
  CheckOutputsEmpty(check, filter, "a volume on one rank");
}

}

int TestGeodesicRanksGrids(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      const geodesictest::Seeds seeds = geodesictest::seedsOfTest(12);
      for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
      {
        CheckSeed(check, ranks, seed);
      }
      CheckVolume(check, ranks);
    });
}
