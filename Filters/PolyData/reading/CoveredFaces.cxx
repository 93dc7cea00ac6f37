// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/CoveredFaces.h"

#include "PolyData/reading/SourceFaces.h"
#include "Tolerance.h"
#include "mesh/PolygonTriangles.h"
#include "mesh/SurfaceLocator.h"
#include "mesh/SurfaceSnap.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace geodesic
{

namespace
{

/// The faces of a source as a mesh of triangles of their own.
struct FaceTriangles
{
  std::vector<Vec3> points{};
  std::vector<Triangle> triangles{};
  /// The face of each triangle, and the first triangle of each face.
  std::vector<std::size_t> faces{};
  std::vector<std::size_t> first{};
  Box box{};

  explicit FaceTriangles(const std::vector<LocatedPolyline>& given)
  {
    for (const LocatedPolyline& face : given)
    {
      const Id offset = static_cast<Id>(this->points.size());
      this->first.push_back(this->triangles.size());
      for (const Triangle& t : triangulatePolygon(face.points).triangles)
      {
        this->triangles.push_back({ offset + t[0], offset + t[1], offset + t[2] });
        this->faces.push_back(this->first.size() - 1);
      }
      this->points.insert(this->points.end(), face.points.begin(), face.points.end());
      std::for_each(face.points.begin(), face.points.end(),
        [this](const Vec3& point) { this->box.add(point); });
    }
    this->first.push_back(this->triangles.size());
  }
};

/// The area of a surface's faces in a source's face: of all, and of the largest.
struct AreaInside
{
  double all = 0.0;
  double largest = 0.0;

  void add(const AreaInside& other)
  {
    this->all += other.all;
    this->largest = std::max(this->largest, other.largest);
  }
};

/// What all ranks, which call this together, have in each face.
std::vector<AreaInside> areasOfRanks(const std::vector<AreaInside>& own, Exchange& exchange)
{
  const std::vector<AreaInside> ofRanks = valuesOfRanks(exchange, own);
  std::vector<AreaInside> areas(own.size());
  for (std::size_t i = 0; i < ofRanks.size(); ++i)
  {
    areas[i % own.size()].add(ofRanks[i]);
  }
  return areas;
}

Vec3 middleOf(const TriangleMesh& mesh, Id face)
{
  const Triangle& t = mesh.triangle(face);
  return (1.0 / 3.0) * (mesh.point(t[0]) + mesh.point(t[1]) + mesh.point(t[2]));
}

/// Whether faces of a source cover faces of a surface.
struct CoverTest
{
  const TriangleMesh& surface;
  const FaceTriangles& source;
  const TriangleMesh& sourceMesh;
  double precision;

  /// Corners, middles of edges, and the middle: a polygon covers a triangle on its own corners if
  /// it has these.
  bool isCovered(Id face, std::size_t by) const
  {
    const Triangle& t = this->surface.triangle(face);
    const Vec3& a = this->surface.point(t[0]);
    const Vec3& b = this->surface.point(t[1]);
    const Vec3& c = this->surface.point(t[2]);
    return this->holds(by, a) && this->holds(by, b) && this->holds(by, c) &&
      this->holds(by, 0.5 * (a + b)) && this->holds(by, 0.5 * (b + c)) &&
      this->holds(by, 0.5 * (c + a)) && this->holds(by, middleOf(this->surface, face));
  }

  double area2(std::size_t of) const
  {
    double area2 = 0.0;
    for (std::size_t t = this->source.first[of]; t < this->source.first[of + 1]; ++t)
    {
      area2 += this->sourceMesh.shape(static_cast<Id>(t)).area2;
    }
    return area2;
  }

  bool holds(std::size_t by, const Vec3& point) const
  {
    for (std::size_t t = this->source.first[by]; t < this->source.first[by + 1]; ++t)
    {
      const auto triangle = static_cast<Id>(t);
      const SnappedPoint there = snapToFace(this->sourceMesh, triangle, point, this->precision);
      const double cut = this->sourceMesh.shape(triangle).roundingOfCuts();
      if (there.distance <= std::max(there.tolerance, cut))
      {
        return true;
      }
    }
    return false;
  }
};

} // anonymous namespace

std::vector<LocatedPolyline> pointsInside(const std::vector<LocatedPolyline>& faces)
{
  const FaceTriangles source(faces);
  const TriangleMesh mesh(source.points, source.triangles);
  std::vector<LocatedPolyline> inside;
  for (const LocatedPolyline& face : faces)
  {
    inside.push_back(firstPointOf(face));
  }
  std::vector<double> largest(faces.size(), -1.0);
  for (Id triangle = 0; triangle < mesh.numberOfFaces(); ++triangle)
  {
    const std::size_t face = source.faces[mesh.inputFace(triangle)];
    if (mesh.shape(triangle).area2 > largest[face])
    {
      largest[face] = mesh.shape(triangle).area2;
      inside[face].points = { middleOf(mesh, triangle) };
    }
  }
  return inside;
}

CoveredFaces findCoveredFaces(const MeshPartition& surface,
  const std::vector<LocatedPolyline>& faces, double coordinatePrecision, const Job& job)
{
  const FaceTriangles source(faces);
  CoveredFaces covered{ {}, std::vector<bool>(faces.size(), false) };
  if (source.triangles.empty())
  {
    return covered;
  }
  const TriangleMesh& onto = surface.mesh();
  std::vector<Vec3> middles;
  std::vector<std::uint8_t> isWanted;
  for (Id face = surface.firstOwnFace(); face < surface.endOfOwnFaces(); ++face)
  {
    middles.push_back(middleOf(onto, face));
    isWanted.push_back(source.box.distanceTo(middles.back()) <= onto.shape(face).longest());
  }
  const TriangleMesh mesh(source.points, source.triangles);
  const CoverTest test = { onto, source, mesh, coordinatePrecision };
  const ClosestFaces closest =
    SurfaceLocator(MeshPartition(mesh)).closest(middles, isWanted, coordinatePrecision, job);
  std::vector<CoveredFace> inside;
  std::vector<AreaInside> areas(faces.size());
  for (Id face = surface.firstOwnFace(); face < surface.endOfOwnFaces(); ++face)
  {
    for (const ClosestFace& found : closest[face - surface.firstOwnFace()])
    {
      const std::size_t by = source.faces[mesh.inputFace(found.face.id)];
      const bool isKnown = !inside.empty() && inside.back().face == face && inside.back().by == by;
      if (!isKnown && test.isCovered(face, by))
      {
        inside.push_back({ face, by });
        areas[by].add({ onto.shape(face).area2, onto.shape(face).area2 });
      }
    }
  }
  areas = areasOfRanks(areas, surface.exchange());
  std::vector<double> least; // a face that is one of the surface's has no others that lie on it
  for (std::size_t by = 0; by < faces.size(); ++by)
  {
    const double area2 = (1.0 - tolerance::CoveredArea) * test.area2(by);
    covered.isOnSurface[by] = areas[by].all >= area2;
    least.push_back(areas[by].largest >= area2 ? area2 : 0.0);
  }
  std::copy_if(inside.begin(), inside.end(), std::back_inserter(covered.own),
    [&](const CoveredFace& found)
    { return covered.isOnSurface[found.by] && onto.shape(found.face).area2 >= least[found.by]; });
  return covered;
}

}
