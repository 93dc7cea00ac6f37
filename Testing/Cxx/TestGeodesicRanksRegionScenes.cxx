// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: random regions as the source of surfaces in pieces, with barriers, faces without area
// and ghost cells, which the source may have, too. Distances are those on the surface without the
// regions' faces. GEODESIC_TEST_SEEDS=FIRST,COUNT takes other seeds.
#include "RanksTesting.h"
#include "RegionScenes.h"
#include "Seeds.h"

using namespace GeodesicTesting;

namespace
{

/// A part of the surface; the array "point" has the numbers of its points.
vtkSmartPointer<vtkPolyData> Numbered(vtkSmartPointer<vtkPolyData> part, bool hasGlobalIds)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->DeepCopy(part->GetPointData()->GetGlobalIds());
  numbers->SetName("point");
  if (!hasGlobalIds)
  {
    part->GetPointData()->SetGlobalIds(nullptr);
    part->GetPointData()->RemoveArray("GlobalPointIds");
  }
  part->GetPointData()->AddArray(numbers);
  return part;
}

/// The cells of a part that are in a region, as Threshold leaves them; with its ghost array.
vtkSmartPointer<vtkPolyData> RegionsOf(vtkPolyData* part)
{
  std::vector<vtkIdType> faces;
  vtkDataArray* regions = part->GetCellData()->GetArray("region");
  for (vtkIdType face = 0; face < part->GetNumberOfPolys(); ++face)
  {
    if (regions->GetTuple1(face) >= 0.0)
    {
      faces.push_back(face);
    }
  }
  return Part(part, faces);
}

vtkSmartPointer<vtkPolyData> SurfaceWithRegions(const RegionScene& scene)
{
  auto surface = SurfaceOf(scene.made);
  vtkNew<vtkIntArray> regions;
  regions->SetName("region");
  for (const int region : scene.regionOf)
  {
    regions->InsertNextValue(10 * region);
  }
  surface->GetCellData()->AddArray(regions);
  return surface;
}

double ErrorOfPart(const RegionScene& scene, vtkPolyData* output, const std::vector<double>& truth)
{
  const std::vector<bool> isOutside = PointsOutsideBarriers(scene.made);
  vtkDataArray* numbers = output->GetPointData()->GetArray("point");
  vtkDataArray* distances = output->GetPointData()->GetArray("GeodesicDistance");
  double worst = 0.0;
  for (vtkIdType i = 0; numbers && i < output->GetNumberOfPoints(); ++i)
  {
    const auto point = static_cast<std::size_t>(numbers->GetTuple1(i));
    const auto expected = TruthAt(scene.made, isOutside, truth, point);
    worst = expected ? std::max(worst, ErrorOf(distances->GetTuple1(i), *expected)) : worst;
  }
  return worst;
}

double CheckScene(Check& check, Ranks ranks, RegionScene& scene)
{
  geodesictest::Random random(SeedOf(scene.name));
  const auto whole = SurfaceWithRegions(scene);
  const bool hasGlobalIds = random.chance(0.5);
  const bool hasGhosts = random.chance(0.5);
  const Cut cut = random.chance(0.5) ? InSpace(whole, ranks.Count) : AtRandom(ranks.Count);
  const auto part = Numbered(hasGhosts ? PartWithGhosts(whole, cut, ranks.Rank, true)
                                       : Part(whole, FacesOf(whole, cut, ranks.Rank), true),
    hasGlobalIds);
  const bool isWhole = random.chance(0.3);
  const auto source = RegionsOf(isWhole ? whole : part);
  scene.name += std::string(hasGlobalIds ? ", global ids" : "") + (hasGhosts ? ", ghosts" : "") +
    (isWhole ? ", all of the source on each rank" : "");
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetBarrierArrayName("barrier");
  filter->SetSourceIdArrayName("region");
  filter->GenerateSourceIdsOn();
  filter->SetInputData(part);
  filter->SetSourceData(source);
  Messages messages(filter);
  messages.Update();
  if (!HasRegion(scene))
  {
    check.That(Contains(messages.Error(), "barrier"), scene.name + ": " + messages.Error());
    return 0.0;
  }
  check.That(messages.Error().empty(), scene.name + ": " + messages.Error());
  check.That(scene.hasFlatFaces ||
      std::abs(filter->GetSourceLength() - OutlineLengthOf(scene)) <=
        1e-11 * std::max(1.0, OutlineLengthOf(scene)),
    scene.name + ": the length is " + std::to_string(filter->GetSourceLength()) + " instead of " +
      std::to_string(OutlineLengthOf(scene)));
  const std::vector<double> truth = TruthOf(scene);
  return messages.Error().empty()
    ? ErrorOfPart(scene, filter->GetOutput(), truth) / std::max(1.0, LargestFinite(truth))
    : 0.0;
}

}

int TestGeodesicRanksRegionScenes(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      const geodesictest::Seeds seeds = geodesictest::seedsOfTest(2);
      for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
      {
        for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
        {
          RegionScene scene = MakeRegionScene(kind, seed);
          if (IsClear(scene))
          {
            const double error = CheckScene(check, ranks, scene);
            check.That(
              error <= AccuracyOn(kind), scene.name + ": wrong by " + std::to_string(error));
          }
        }
      }
    });
}
