// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: regions go over the pieces of the ranks, and each rank has the faces of the region in
// its piece, or all of them; distances are those of one process. Tables of regions need the whole
// surface on a rank; regions may be in pieces.
#include "GeodesicTesting.h"
#include "RanksTesting.h"
#include "RegionTesting.h"
#include "TableTesting.h"

using namespace GeodesicTesting;

namespace
{

/// One process is right by TestGeodesicRegions.
void CheckRegion(Check& check, Ranks ranks, const Region& region, const std::string& name)
{
  Question question{ name, SourceOf(region) };
  question.HasSides = false;
  question.HasManyWindows = false;
  question.Settings = [](vtkGeodesicDistanceField* filter)
  {
    AskForAllArrays(filter);
    filter->SetSourceIdArrayName("One");
  };
  question.Tolerances = { { "ClosestSourcePoint", 1e-12 }, { "SourceId", 0.0 } };
  Whole whole(region.Surface, question);
  for (const auto& [cutName, cut] : Cuts(region.Surface, ranks, { "in space", "at random" }))
  {
    const std::vector<vtkIdType> faces = FacesOf(region.Surface, cut, ranks.Rank);
    Region own{ Part(region.Surface, faces), {} };
    for (const vtkIdType face : faces)
    {
      own.IsInside.push_back(region.IsInside[static_cast<std::size_t>(face)]);
    }
    for (const bool isWhole : { true, false })
    {
      whole.Asked.OwnSource = SourceOf(isWhole ? region : own);
      const auto filter = Compare(check, own.Surface, whole,
        cutName + (isWhole ? ", all faces on each rank" : ", faces of the piece"));
      for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
      {
        const Point p = PointAt(filter->GetOutput(), i);
        vtkDataArray* closest = filter->GetOutput()->GetPointData()->GetArray("ClosestSourcePoint");
        check.That(whole.DistanceAt(p) > 0.0 || TupleAt(closest, i) == p,
          name + ": a point inside is its own closest point");
      }
    }
  }
}

/// The regions of a table go over the ranks' pieces, as sources, as targets or as both.
void CheckTable(Check& check, Ranks ranks, std::uint64_t seed)
{
  const auto surface = Labelled(RandomRegion(seed, false).Surface,
    [](const Point& p) { return p[2] > 0.3 ? -1 : (p[0] > 0.2 ? 5 : 0) + (p[1] > 0.4 ? 2 : 1); });
  const auto whole = WithoutNegative(surface);
  const auto own = Part(whole, FacesOf(whole, AtRandom(ranks.Count), ranks.Rank));
  vtkNew<vtkPolyData> nothing;
  for (const bool isTargets : { false, true })
  {
    const auto tableOf = [&](vtkPolyData* data, vtkPolyData* parts, bool isAlone)
    {
      vtkNew<vtkGeodesicDistanceMatrix> matrix;
      if (isAlone)
      {
        matrix->SetController(nullptr);
      }
      matrix->SetInputData(data);
      matrix->SetSourceData(parts);
      matrix->SetTargetsData(isTargets ? parts : nullptr);
      matrix->SetSourceIdArrayName("Label");
      matrix->SetTargetIdArrayName("Label");
      return TableOf(check, matrix, "table of seed " + std::to_string(seed), 0);
    };
    const Rows alone = tableOf(surface, whole, true);
    check.That(alone.size() > 1, "there are regions");
    for (const bool isOnOne : { false, true })
    {
      const bool hasSurface = !isOnOne || ranks.Rank == ranks.Count - 1;
      const Rows table = tableOf(hasSurface ? surface.Get() : nothing.Get(), own, false);
      check.Equal(static_cast<double>(table.size()),
        ranks.Rank == 0 ? static_cast<double>(alone.size()) : 0.0, "rank 0 has the rows");
      for (std::size_t row = 0; row < table.size(); ++row)
      {
        for (std::size_t column = 0; column < table[row].size(); ++column)
        {
          check.That(std::abs(table[row][column] - alone[row][column]) <= 1e-12,
            "a table of regions in pieces is that of one process");
        }
      }
    }
  }
}

}

int TestGeodesicRanksRegions(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      for (std::uint64_t seed = 0; seed < RegionSeeds(30); ++seed)
      {
        const Region region = RandomRegion(seed, false); // pieces are triangles
        CheckRegion(check, ranks, region, "seed " + std::to_string(seed));
        CheckTable(check, ranks, seed);
      }
      for (const auto& [name, region] : RegionsUnderASheet())
      {
        if (region.Surface->GetMaxCellSize() == 3)
        {
          CheckRegion(check, ranks, region, name);
        }
      }
    });
}
