// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/CoveredFaces.h"

#include "Tolerance.h"
#include "mesh/PolygonTriangles.h"
#include "mesh/SurfaceLocator.h"
#include "mesh/SurfaceSnap.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace geodesic
{

namespace
{

Vec3 middleOf(const TriangleMesh& mesh, Id face)
{
  const Triangle& t = mesh.triangle(face);
  return (1.0 / 3.0) * (mesh.point(t[0]) + mesh.point(t[1]) + mesh.point(t[2]));
}

/// A face of a surface that lies in a face of a source.
struct FaceInside
{
  RankAddress face;
  std::size_t by;
  SurfaceCell cell;
  double area2;
};

/// Those that a face of the source consists of.
///
/// \param inside all that lie in it.
/// \param area2 twice its area, less a tolerance.
std::vector<RankAddress> partsOf(const std::vector<FaceInside>& inside, double area2)
{
  double all = 0.0;
  std::map<SurfaceCell, double> ofCells;
  for (const FaceInside& face : inside)
  {
    all += face.area2;
    ofCells[face.cell] += face.area2;
  }
  const bool isCell = std::any_of(
    ofCells.begin(), ofCells.end(), [area2](const auto& cell) { return cell.second >= area2; });
  std::vector<RankAddress> parts;
  for (const FaceInside& face : inside)
  {
    if ((isCell ? ofCells[face.cell] : all) >= area2)
    {
      parts.push_back(face.face);
    }
  }
  return parts;
}

} // anonymous namespace

SourceFaceMesh::SourceFaceMesh(const std::vector<SourceFace>& faces, double coordinatePrecision)
  : precision_(coordinatePrecision)
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    const Id offset = static_cast<Id>(points.size());
    this->first_.push_back(static_cast<Id>(triangles.size()));
    for (const Triangle& t : triangulatePolygon(faces[face].outline.points).triangles)
    {
      triangles.push_back({ offset + t[0], offset + t[1], offset + t[2] });
      this->faces_.push_back(face);
    }
    for (const Vec3& point : faces[face].outline.points)
    {
      points.push_back(point);
      this->box_.add(point);
    }
  }
  this->first_.push_back(static_cast<Id>(triangles.size()));
  this->mesh_ = TriangleMesh(std::move(points), triangles);
}

std::vector<LocatedPolyline> SourceFaceMesh::pointsInside() const
{
  std::vector<LocatedPolyline> inside(this->first_.size() - 1);
  std::vector<double> largest(inside.size(), -1.0);
  for (Id triangle = 0; triangle < this->mesh_.numberOfFaces(); ++triangle)
  {
    const std::size_t face = this->faces_[triangle];
    if (this->mesh_.shape(triangle).area2 > largest[face])
    {
      largest[face] = this->mesh_.shape(triangle).area2;
      inside[face].points = { middleOf(this->mesh_, triangle) };
    }
  }
  return inside;
}

/// Corners, middles of edges, and the middle: a polygon covers a triangle on its own corners if it
/// has these.
bool SourceFaceMesh::covers(std::size_t by, const TriangleMesh& surface, Id face) const
{
  const Triangle& t = surface.triangle(face);
  const Vec3& a = surface.point(t[0]);
  const Vec3& b = surface.point(t[1]);
  const Vec3& c = surface.point(t[2]);
  const Vec3 points[] = { a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a),
    middleOf(surface, face) };
  return std::all_of(std::begin(points), std::end(points),
    [&](const Vec3& point) { return this->holds(by, point); });
}

bool SourceFaceMesh::holds(std::size_t by, const Vec3& point) const
{
  for (Id triangle = this->first_[by]; triangle < this->first_[by + 1]; ++triangle)
  {
    const SnappedPoint there = snapToFace(this->mesh_, triangle, point, this->precision_);
    const double cut = this->mesh_.shape(triangle).roundingOfCuts();
    if (there.distance <= std::max(there.tolerance, cut))
    {
      return true;
    }
  }
  return false;
}

double SourceFaceMesh::area2(std::size_t of) const
{
  double area2 = 0.0;
  for (Id triangle = this->first_[of]; triangle < this->first_[of + 1]; ++triangle)
  {
    area2 += this->mesh_.shape(triangle).area2;
  }
  return area2;
}

std::vector<std::vector<RankAddress>> SourceFaceMesh::findCovered(
  const MeshPartition& surface, const std::function<SurfaceCell(Id)>& cellOf, const Job& job) const
{
  const TriangleMesh& onto = surface.mesh();
  std::vector<Vec3> middles;
  std::vector<std::uint8_t> isWanted;
  for (Id face = surface.firstOwnFace(); face < surface.endOfOwnFaces(); ++face)
  {
    middles.push_back(middleOf(onto, face));
    isWanted.push_back(this->box_.distanceTo(middles.back()) <= onto.shape(face).longest());
  }
  const ClosestFaces closest =
    SurfaceLocator(MeshPartition(this->mesh_)).closest(middles, isWanted, this->precision_, job);
  std::vector<FaceInside> own;
  for (Id face = surface.firstOwnFace(); face < surface.endOfOwnFaces(); ++face)
  {
    for (const ClosestFace& found : closest[face - surface.firstOwnFace()])
    {
      const std::size_t by = this->faces_[found.face.id];
      const bool isKnown = !own.empty() && own.back().face.id == face && own.back().by == by;
      if (!isKnown && this->covers(by, onto, face))
      {
        own.push_back({ surface.addressOf(face), by, cellOf(face), onto.shape(face).area2 });
      }
    }
  }
  std::vector<std::vector<FaceInside>> inside(this->first_.size() - 1);
  for (const FaceInside& face : valuesOfRanks(surface.exchange(), own))
  {
    inside[face.by].push_back(face);
  }
  std::vector<std::vector<RankAddress>> covered;
  for (std::size_t by = 0; by < inside.size(); ++by)
  {
    covered.push_back(partsOf(inside[by], (1.0 - tolerance::CoveredArea) * this->area2(by)));
  }
  return covered;
}

}
