// SPDX-License-Identifier: BSD-3-Clause
#ifndef RegionTesting_h
#define RegionTesting_h

#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkFeatureEdges.h"
#include "vtkIntArray.h"

#include <cstdlib>
#include <map>
#include <set>

namespace GeodesicTesting
{

/// Some faces of a surface without vertices and lines.
struct Region
{
  vtkSmartPointer<vtkPolyData> Surface;
  std::vector<bool> IsInside;
};

inline vtkSmartPointer<vtkPolyData> FacesOfRegion(const Region& region, bool inside)
{
  vtkNew<vtkCellArray> polys;
  for (vtkIdType f = 0; f < region.Surface->GetNumberOfPolys(); ++f)
  {
    if (region.IsInside[static_cast<std::size_t>(f)] == inside)
    {
      vtkNew<vtkIdList> ids;
      region.Surface->GetPolys()->GetCellAtId(f, ids);
      polys->InsertNextCell(ids);
    }
  }
  auto faces = vtkSmartPointer<vtkPolyData>::New();
  faces->SetPoints(region.Surface->GetPoints());
  faces->SetPolys(polys);
  return faces;
}

/// The faces of the region with the array One, which makes one source of them. Without faces it has
/// no points either, which would be a set of points.
inline vtkSmartPointer<vtkPolyData> SourceOf(const Region& region)
{
  auto faces = FacesOfRegion(region, true);
  if (faces->GetNumberOfCells() == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  vtkNew<vtkIntArray> one;
  one->SetName("One");
  one->SetNumberOfTuples(faces->GetNumberOfCells());
  one->Fill(0.0);
  faces->GetCellData()->AddArray(one);
  return faces;
}

inline vtkSmartPointer<vtkPolyData> OutlineOf(const Region& region)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(FacesOfRegion(region, true));
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  return edges->GetOutput();
}

inline double OutlineLength(const Region& region)
{
  return TotalLength(OutlineOf(region));
}

/// For each point whether it is a corner of the region.
inline std::vector<bool> PointsInside(const Region& region)
{
  std::vector<bool> inside(static_cast<std::size_t>(region.Surface->GetNumberOfPoints()), false);
  const auto faces = FacesOfRegion(region, true);
  for (vtkIdType f = 0; f < faces->GetNumberOfPolys(); ++f)
  {
    vtkNew<vtkIdList> ids;
    faces->GetPolys()->GetCellAtId(f, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      inside[static_cast<std::size_t>(ids->GetId(k))] = true;
    }
  }
  return inside;
}

using EdgesOfFaces = std::set<std::pair<vtkIdType, vtkIdType>>;

inline EdgesOfFaces EdgesOf(vtkPolyData* faces)
{
  EdgesOfFaces edges;
  for (vtkIdType f = 0; f < faces->GetNumberOfPolys(); ++f)
  {
    vtkNew<vtkIdList> ids;
    faces->GetPolys()->GetCellAtId(f, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      edges.insert(std::minmax({ ids->GetId(k), ids->GetId((k + 1) % ids->GetNumberOfIds()) }));
    }
  }
  return edges;
}

/// The edges and corners that a region shares with the other faces.
inline vtkSmartPointer<vtkPolyData> WhereItMeetsOthers(const Region& region)
{
  const EdgesOfFaces inside = EdgesOf(FacesOfRegion(region, true));
  const std::vector<bool> isCorner = PointsInside(region);
  auto shared = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> corners;
  for (const auto& [a, b] : EdgesOf(FacesOfRegion(region, false)))
  {
    if (inside.count({ a, b }) > 0)
    {
      lines->InsertNextCell({ a, b });
    }
    for (const vtkIdType end : { a, b })
    {
      if (isCorner[static_cast<std::size_t>(end)])
      {
        corners->InsertNextCell({ end });
      }
    }
  }
  shared->SetPoints(region.Surface->GetPoints());
  shared->SetLines(lines);
  shared->SetVerts(corners);
  return shared;
}

/// At the points: from where the region meets the others, on the surface without it.
inline std::vector<double> TruthOf(const Region& region)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->JoinLinesOff();
  filter->SetInputData(FacesOfRegion(region, false));
  filter->SetSourceData(WhereItMeetsOthers(region));
  filter->Update();
  const std::vector<bool> inside = PointsInside(region);
  std::vector<double> truth;
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    truth.push_back(inside[i] ? 0.0 : Distances(filter)->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return truth;
}

inline double LargestOf(const std::vector<double>& truth)
{
  double largest = 1e-300;
  for (const double value : truth)
  {
    largest = std::isinf(value) ? largest : std::max(largest, value);
  }
  return largest;
}

inline void CompareWithTruth(Check& check, vtkGeodesicDistanceField* filter,
  const std::vector<double>& truth, const std::string& name)
{
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const double found = Distances(filter)->GetTuple1(static_cast<vtkIdType>(i));
    check.That(found == truth[i] || std::abs(found - truth[i]) <= 1e-11 * LargestOf(truth),
      name + ": point " + std::to_string(i) + ", " + std::to_string(found) + " instead of " +
        std::to_string(truth[i]));
  }
}

/// A patch of faces with holes, or two that touch, on a plane or on a rough sphere.
inline Region RandomRegion(std::uint64_t seed, bool hasQuads = true)
{
  std::mt19937_64 random(seed + 53);
  const auto below = [&random](std::size_t count) { return random() % count; };
  Region region;
  region.Surface = below(3) == 0
    ? NoisySquare(8, below(2) == 0 && hasQuads ? Cells::Quads : Cells::Triangles)
    : ChangedSphere(12, 9,
        [&](const Point& p)
        {
          const double r = 1.0 + 0.3 * static_cast<double>(below(1000)) / 1000.0;
          return Point{ p[0] * r, p[1] * r, p[2] * r };
        });
  const auto count = static_cast<std::size_t>(region.Surface->GetNumberOfPolys());
  region.IsInside.assign(count, false);
  const std::size_t patches = 1 + below(2);
  for (std::size_t patch = 0; patch < patches; ++patch)
  {
    Point middle;
    region.Surface->GetPoint(
      static_cast<vtkIdType>(below(static_cast<std::size_t>(region.Surface->GetNumberOfPoints()))),
      middle.data());
    const double radius = 0.05 + 0.05 * static_cast<double>(below(12));
    for (std::size_t f = 0; f < count; ++f)
    {
      Point corner;
      vtkNew<vtkIdList> ids;
      region.Surface->GetPolys()->GetCellAtId(static_cast<vtkIdType>(f), ids);
      region.Surface->GetPoint(ids->GetId(0), corner.data());
      const double apart =
        std::hypot(corner[0] - middle[0], std::hypot(corner[1] - middle[1], corner[2] - middle[2]));
      if (apart <= radius && below(10) > 0)
      {
        region.IsInside[f] = true;
      }
    }
  }
  region.IsInside[below(count)] = true;
  return region;
}

/// The first cell of a surface is a region, and a sheet lies on it: on a triangle, on one that is
/// cut at a face without area, on a polygon.
inline std::map<std::string, Region> RegionsUnderASheet()
{
  using Polygons = std::vector<std::vector<vtkIdType>>;
  const std::vector<Point> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 4, 4, 0 },
    { 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 }, { 2, 2, 1 }, { 2, 0, 0 }, { 2, -4, 0 } };
  const std::pair<const char*, Polygons> others[] = { { "triangle",
                                                        { { 0, 1, 2 }, { 1, 3, 2 }, { 8, 9, 1 } } },
    { "cut triangle", { { 0, 1, 2 }, { 1, 3, 2 }, { 0, 8, 1 }, { 0, 9, 8 }, { 8, 9, 1 } } },
    { "polygon", { { 0, 1, 3, 2 }, { 8, 9, 1 } } } };
  std::map<std::string, Region> regions;
  for (auto [name, faces] : others)
  {
    faces.push_back({ 4, 5, 6 });
    faces.push_back({ 5, 7, 6 });
    Region& region = regions[std::string("under a sheet, a ") + name];
    region.Surface = Mesh(points, faces);
    region.IsInside.assign(faces.size(), false);
    region.IsInside[0] = true;
  }
  return regions;
}

/// How many random regions a test takes: GEODESIC_REGION_SEEDS, or this many.
inline std::uint64_t RegionSeeds(std::uint64_t usual)
{
  const char* wanted = std::getenv("GEODESIC_REGION_SEEDS");
  return wanted ? std::strtoull(wanted, nullptr, 10) : usual;
}

}

#endif
