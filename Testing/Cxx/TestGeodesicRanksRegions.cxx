// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: regions go over the pieces of the ranks, and each rank has the faces of the region in
// its piece, or all of them; distances are those of one process, and of the surface without the
// region. Tables of regions need the whole surface on a rank; regions may be in pieces.
#include "GeodesicTesting.h"
#include "RanksTesting.h"
#include "RegionTesting.h"
#include "TableTesting.h"

using namespace GeodesicTesting;

namespace
{

void CheckRegion(
  Check& check, Ranks ranks, const Region& region, const Cut& cut, const std::string& what)
{
  const std::vector<double> truth = TruthOf(region);
  const std::vector<bool> isInside = PointsInside(region);
  const double length = OutlineLength(region);
  const std::vector<vtkIdType> faces = FacesOf(region.Surface, cut, ranks.Rank);
  Region own{ Part(region.Surface, faces), {} };
  for (const vtkIdType face : faces)
  {
    own.IsInside.push_back(region.IsInside[static_cast<std::size_t>(face)]);
  }
  std::map<Point, std::size_t> numbers;
  for (vtkIdType i = 0; i < region.Surface->GetNumberOfPoints(); ++i)
  {
    Point p;
    region.Surface->GetPoint(i, p.data());
    numbers.emplace(p, static_cast<std::size_t>(i));
  }
  for (const bool isWhole : { true, false })
  {
    const std::string name = what + (isWhole ? ", all faces on each rank" : ", faces of the piece");
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->RefineMeshOff();
    AskForAllArrays(filter);
    filter->SetInputData(own.Surface);
    filter->SetSourceData(SourceOf(isWhole ? region : own));
    filter->SetSourceIdArrayName("One");
    Messages messages(filter);
    messages.Update();
    check.That(messages.Error().empty(), name + ": " + messages.Error());
    check.That(std::abs(filter->GetSourceLength() - length) <= 1e-12 * std::max(length, 1.0),
      name + ": the length is the outline's");
    vtkPolyData* output = filter->GetOutput();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      Point p;
      Point closest;
      output->GetPoint(i, p.data());
      output->GetPointData()->GetArray("ClosestSourcePoint")->GetTuple(i, closest.data());
      const std::size_t number = numbers.at(p);
      const double found = Distances(filter)->GetTuple1(i);
      check.That(
        found == truth[number] || std::abs(found - truth[number]) <= 1e-11 * LargestOf(truth),
        name + ": " + std::to_string(found) + " instead of " + std::to_string(truth[number]));
      check.That(!isInside[number] || closest == p, name + ": closest point inside");
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
        const std::string name = "seed " + std::to_string(seed);
        CheckRegion(check, ranks, region, InSpace(region.Surface, ranks.Count), name);
        CheckRegion(check, ranks, region, AtRandom(ranks.Count), name + ", at random");
        CheckTable(check, ranks, seed);
      }
    });
}
