// SPDX-License-Identifier: BSD-3-Clause
// Random regions as the source: with holes, touching, beside and across barriers, over blocks,
// beside faces without area. Distances are those on the surface without the regions' faces.
// GEODESIC_TEST_SEEDS=FIRST,COUNT takes other seeds.
#include "RegionScenes.h"
#include "Seeds.h"

#include "vtkAppendFilter.h"
#include "vtkUnstructuredGrid.h"

using namespace GeodesicTesting;

namespace
{

/// For each point of the whole the ids of the regions that have it.
std::vector<std::set<double>> IdsAtPoints(const RegionScene& scene)
{
  std::vector<std::set<double>> ids(scene.made.whole.points.size());
  for (std::size_t f = 0; f < scene.made.whole.triangles.size(); ++f)
  {
    for (const geodesictest::Index v : scene.made.whole.triangles[f])
    {
      if (scene.isInRegion(f))
      {
        ids[v].insert(10.0 * scene.regionOfWhole[f]);
      }
    }
  }
  return ids;
}

/// At a point of a region values are those of the source itself.
void CheckInside(Check& check, const RegionScene& scene, vtkPolyData* block, vtkIdType point,
  const std::set<double>& ids)
{
  Point closest;
  Point place;
  Point gradient;
  block->GetPoint(point, place.data());
  vtkPointData* values = block->GetPointData();
  values->GetArray("ClosestSourcePoint")->GetTuple(point, closest.data());
  values->GetArray("DistanceGradient")->GetTuple(point, gradient.data());
  const double away = geodesictest::spaceDistance(closest, place);
  check.That(scene.hasFlatFaces ? away < 1e-11 : away == 0.0,
    scene.name + ": a point inside is its own closest point, apart by " + std::to_string(away));
  check.That(gradient == Point{}, scene.name + ": no gradient inside");
  vtkDataArray* sides = values->GetArray("SignedGeodesicDistance");
  check.That(
    !sides || !std::signbit(sides->GetTuple1(point)), scene.name + ": the sign inside is +");
  const double id = values->GetArray("SourceId")->GetTuple1(point);
  check.That(
    ids.empty() || ids.count(id) > 0, scene.name + ": the id inside is " + std::to_string(id));
}

/// \param isNamed whether ids are checked.
/// \returns the largest error.
double ErrorOfBlock(Check& check, const RegionScene& scene, vtkPolyData* block,
  const std::vector<double>& truth, bool isNamed)
{
  const std::vector<bool> isOutside = PointsOutsideBarriers(scene.made);
  const std::vector<std::set<double>> ids = IdsAtPoints(scene);
  vtkDataArray* distances = block->GetPointData()->GetArray("GeodesicDistance");
  if (!distances)
  {
    check.That(block->GetNumberOfPoints() == 0, scene.name + ": there are distances");
    return 0.0;
  }
  double worst = 0.0;
  for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> corners;
    block->GetCellPoints(cell, corners);
    for (const vtkIdType id : { corners->GetId(0), corners->GetId(1), corners->GetId(2) })
    {
      const auto point = static_cast<std::size_t>(id);
      const auto expected = TruthAt(scene.made, isOutside, truth, point);
      worst = expected ? std::max(worst, ErrorOf(distances->GetTuple1(id), *expected)) : worst;
      if (expected == 0.0 && distances->GetTuple1(id) == 0.0)
      {
        CheckInside(check, scene, block, id,
          isNamed ? ids[scene.made.pointOfWhole[point]] : std::set<double>());
      }
    }
  }
  return worst;
}

vtkSmartPointer<vtkDataObject> GridOf(vtkPolyData* data)
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(data);
  append->Update();
  return append->GetOutput();
}

/// The source as a user may have it.
vtkSmartPointer<vtkDataObject> AnySourceOf(const RegionScene& scene, geodesictest::Random& random)
{
  const auto source = SourceOf(scene);
  if (random.chance(0.2))
  {
    auto soup = Soup(source);
    soup->GetCellData()->ShallowCopy(source->GetCellData());
    return soup;
  }
  return random.chance(0.2) ? GridOf(source) : vtkSmartPointer<vtkDataObject>(source);
}

double CheckScene(Check& check, RegionScene& scene)
{
  geodesictest::Random random(SeedOf(scene.name));
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  AskForAllArrays(filter);
  filter->SetBarrierArrayName("barrier");
  const bool isNamed = random.chance(0.7);
  filter->SetSourceIdArrayName(isNamed ? "region" : nullptr);
  filter->SetJoinLines(random.chance(0.7));
  filter->SetInputData(SurfaceOf(scene.made));
  filter->SetInputDataObject(1, AnySourceOf(scene, random));
  scene.name += std::string(scene.hasFlatFaces ? ", with flat faces" : "") +
    (isNamed ? ", named" : "") + (filter->GetJoinLines() ? "" : ", not joined");
  if (random.chance(0.5))
  {
    const geodesictest::Index count = random.between(1, 4);
    const SceneInBlocks blocks(scene, count, random);
    filter->SetInputDataObject(0, blocks.surface);
    scene.name += ", " + std::to_string(count) + " blocks";
    if (random.chance(0.5))
    {
      filter->SetInputDataObject(1, blocks.source);
      scene.name += " of the source, too";
    }
  }
  Messages messages(filter);
  messages.Update();
  if (Contains(messages.Error(), "GenerateSignedDistance needs a surface"))
  {
    filter->GenerateSignedDistanceOff();
    filter->GenerateTextureCoordinatesOff();
    messages.Update();
  }
  if (!HasRegion(scene))
  {
    check.That(Contains(messages.Error(), "barrier"), scene.name + ": " + messages.Error());
    return 0.0;
  }
  check.That(messages.Error().empty(), scene.name + ": " + messages.Error());
  if (!messages.Error().empty())
  {
    return 0.0;
  }
  if (isNamed && !scene.hasFlatFaces)
  {
    const double length = OutlineLengthOf(scene);
    check.That(std::abs(filter->GetSourceLength() - length) <= 1e-11 * std::max(1.0, length),
      scene.name + ": the length is " + std::to_string(filter->GetSourceLength()) + " instead of " +
        std::to_string(length));
  }
  const std::vector<double> truth = TruthOf(scene);
  double error = 0.0;
  for (vtkPolyData* block : LeavesOf(filter->GetOutputDataObject(0)))
  {
    error = std::max(error, ErrorOfBlock(check, scene, block, truth, isNamed));
  }
  return error / std::max(1.0, LargestFinite(truth));
}

void CheckRandomScenes(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(3);
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    double worst = 0.0;
    int compared = 0;
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      RegionScene scene = MakeRegionScene(kind, seed);
      if (!IsClear(scene))
      {
        continue;
      }
      const double error = CheckScene(check, scene);
      check.That(error <= AccuracyOn(kind), scene.name + ": wrong by " + std::to_string(error));
      worst = std::max(worst, error);
      ++compared;
    }
    std::cout << kind.name << ": worst relative error " << worst << " of " << compared << "\n";
  }
}

} // anonymous namespace

int TestGeodesicRegionScenes(int, char*[])
{
  Check check;
  CheckRandomScenes(check);
  return check.Result();
}
