// SPDX-License-Identifier: BSD-3-Clause
// Faces as sources: distances are those on the surface without these faces, from their outline; the
// surface's faces that they cover are the source itself.
#include "GeodesicTesting.h"
#include "RegionTesting.h"

#include "vtkAppendFilter.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>

using namespace GeodesicTesting;

namespace
{

vtkSmartPointer<vtkUnstructuredGrid> Grid(vtkPolyData* data)
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(data);
  append->Update();
  return append->GetOutput();
}

/// In a region values are those of the source itself.
void CheckInside(Check& check, vtkGeodesicDistanceField* filter, const std::vector<bool>& isInside,
  const std::string& name)
{
  vtkPointData* values = filter->GetOutput()->GetPointData();
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(isInside.size()); ++i)
  {
    if (!isInside[static_cast<std::size_t>(i)])
    {
      continue;
    }
    check.That(
      TupleAt(values->GetArray("ClosestSourcePoint"), i) == PointAt(filter->GetOutput(), i),
      name + ": a point inside is its own closest point");
    check.That(
      TupleAt(values->GetArray("DistanceGradient"), i) == Point{}, name + ": no gradient inside");
    const double distance = values->GetArray("SignedGeodesicDistance")->GetTuple1(i);
    check.That(distance == 0.0 && !std::signbit(distance), name + ": the distance inside is +0");
    check.Equal(values->GetArray("SourceId")->GetTuple1(i), 0.0, name + ": the id inside");
  }
}

void CheckRegion(Check& check, const Region& region, const std::string& name)
{
  const std::vector<double> truth = TruthOf(region);
  const auto source = SourceOf(region);
  const auto grid = Grid(source);
  for (vtkDataObject* data : std::initializer_list<vtkDataObject*>{ source, grid })
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->RefineMeshOff();
    AskForAllArrays(filter);
    filter->SetInputData(region.Surface);
    filter->SetSourceData(data);
    filter->SetSourceIdArrayName("One");
    RunWithoutError(check, filter, name);
    CompareWithTruth(check, filter, truth, name);
    CheckInside(check, filter, PointsInside(region), name);
    const double length = OutlineLength(region);
    check.That(std::abs(filter->GetSourceLength() - length) <= 1e-12 * length,
      name + ": the length is the outline's");
  }
}

void CheckOtherFilters(Check& check, const Region& region, const std::string& name)
{
  const std::vector<double> truth = TruthOf(region);
  const double largest = LargestOf(truth);
  const auto source = SourceOf(region);
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  matrix->SetInputData(region.Surface);
  matrix->SetSourceData(source);
  matrix->SetSourceIdArrayName("One");
  matrix->SetTargetsData(region.Surface);
  Messages messages(matrix);
  messages.Update();
  check.That(messages.Error().empty(), name + ", matrix: " + messages.Error());
  vtkTable* table = matrix->GetOutput();
  vtkNew<vtkGeodesicPaths> paths;
  paths->SetInputData(region.Surface);
  paths->SetSourceData(source);
  paths->SetSourceIdArrayName("One");
  paths->SetTargetsData(region.Surface);
  paths->Update();
  vtkDataArray* lengths = paths->GetOutput()->GetCellData()->GetArray("GeodesicDistance");
  vtkDataArray* targets = paths->GetOutput()->GetCellData()->GetArray("TargetId");
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const double expected = truth[static_cast<std::size_t>(i)];
    const double found = table->GetValueByName(i, "Source0").ToDouble();
    check.That(found == expected || std::abs(found - expected) <= 1e-11 * largest,
      name + ": matrices have the same distances");
  }
  for (vtkIdType i = 0; i < lengths->GetNumberOfTuples(); ++i)
  {
    const double expected = truth[static_cast<std::size_t>(targets->GetTuple1(i))];
    check.That(std::abs(lengths->GetTuple1(i) - expected) <= 1e-11 * largest,
      name + ": paths end at the outline");
  }
}

/// No cell of the region is cut.
void CheckRefinement(Check& check, const Region& region, const std::string& name)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(region.Surface);
  filter->SetSourceData(SourceOf(region));
  filter->SetSourceIdArrayName("One");
  filter->RefineSourceBordersOn();
  filter->GenerateSignedDistanceOn();
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), name + ", refined: " + messages.Error());
  vtkDataArray* cells = filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds");
  vtkDataArray* distances = Distances(filter);
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    if (region.IsInside[static_cast<std::size_t>(cells->GetTuple1(i))])
    {
      vtkNew<vtkIdList> corners;
      filter->GetOutput()->GetCellPoints(i, corners);
      for (const vtkIdType corner : { corners->GetId(0), corners->GetId(1), corners->GetId(2) })
      {
        check.That(distances->GetTuple1(corner) < 1e-15, name + ": 0 all over the region");
      }
    }
  }
}

/// The surface's own faces, all of them, are a source without outline where it is closed.
void CheckWhole(Check& check, vtkPolyData* surface, double length, const std::string& name)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(surface);
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(surface);
  filter->SetSourceData(copy);
  RunWithoutError(check, filter, name);
  CheckDistances(
    check, filter, [](const Point&) { return 0.0; }, name);
  check.That(std::abs(filter->GetSourceLength() - length) < 1e-12, name + ": its outline");
}

/// Without an array, faces that meet are a region each.
void CheckRegionsWithoutNames(Check& check)
{
  const auto surface = Square(8);
  Region region{ surface, std::vector<bool>(128, false) };
  for (const std::size_t face : { 0, 1, 2, 3, 60, 61 })
  {
    region.IsInside[face] = true;
  }
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetInputData(surface);
  filter->SetSourceData(SourceOf(region));
  filter->GenerateSourceIdsOn();
  filter->Update();
  CompareWithTruth(check, filter, TruthOf(region), "regions without names");
  check.Equal(filter->GetOutput()->GetPointData()->GetArray("SourceId")->GetRange()[1], 4.0,
    "the id of a region is that of its first face");
}

/// A sheet that lies on a face of the region is no part of it.
void CheckRegionUnderASheet(Check& check)
{
  for (const auto& [name, region] : RegionsUnderASheet())
  {
    CheckRegion(check, region, name);
    CheckOtherFilters(check, region, name);
  }
}

/// A face of the region that is a barrier is left out, also where an open sheet lies on its middle.
void CheckBarrierUnderASheet(Check& check)
{
  const auto surface = Mesh({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 4, 4, 0 }, { -4, 0, 0 },
                              { 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 } },
    { { 0, 1, 2 }, { 1, 3, 2 }, { 0, 2, 4 }, { 5, 6, 7 } });
  AddArrayOf<vtkIntArray>(
    surface->GetCellData(), "barrier", 4, [](vtkIdType cell) { return cell == 0 ? 1 : 0; });
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetBarrierArrayName("barrier");
  filter->SetInputData(surface);
  filter->SetSourceData(SourceOf({ surface, { true, true, false, false } }));
  filter->Update();
  const double inf = std::numeric_limits<double>::infinity();
  CompareWithTruth(check, filter, { 4, 0, 0, 0, std::sqrt(32.0), inf, inf, inf },
    "a barrier in the region under a sheet");
}

}

int TestGeodesicRegions(int, char*[])
{
  Check check;
  for (std::uint64_t seed = 0; seed < RegionSeeds(40); ++seed)
  {
    const std::string name = "seed " + std::to_string(seed);
    const Region region = RandomRegion(seed);
    CheckRegion(check, region, name);
    if (seed % 4 == 0)
    {
      CheckOtherFilters(check, region, name);
      CheckRefinement(check, region, name);
    }
  }
  CheckWhole(check, Square(4), 4.0, "all of a square");
  CheckWhole(check, Square(4, Cells::Quads), 4.0, "all of a square of quads");
  CheckWhole(check, Square(4, Cells::Strips), 4.0, "all of a square of strips");
  CheckWhole(check, Tetrahedron(), 0.0, "all of a tetrahedron");
  CheckWhole(check, Soup(Square(4)), 4.0, "all of a soup");
  CheckRegionsWithoutNames(check);
  CheckRegionUnderASheet(check);
  CheckBarrierUnderASheet(check);
  return check.Result();
}
