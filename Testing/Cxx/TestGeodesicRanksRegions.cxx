// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: regions go over the pieces of the ranks, and each rank has the faces of the region in
// its piece, or all of them; distances are those of one process, and of the surface without the
// region.
#include "GeodesicTesting.h"
#include "RanksTesting.h"
#include "RegionTesting.h"

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
      }
    });
}
