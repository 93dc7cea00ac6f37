// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/CoveredFaces.h"

#include "PolyData/reading/PolyDataSurface.h"
#include "Tolerance.h"
#include "mesh/Box.h"
#include "mesh/SurfaceLocator.h"
#include "mesh/SurfaceSnap.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

namespace geodesic
{

namespace
{

/// A cell of a surface: its rank, its block there, and its number in the block's input.
using SurfaceCell = std::array<vtkIdType, 3>;

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

/// The faces of a source as a mesh of triangles of their own, which tells where they lie.
class SourceFaceMesh
{
public:
  explicit SourceFaceMesh(const SourceCells& cells)
    : precision_(cells.precision)
    , first_(1, 0)
    , mesh_(this->meshOf(cells.faces))
    , locator_(MeshPartition(this->mesh_))
  {
  }

  /// A point inside each face, where it is widest.
  std::vector<LocatedPolyline> pointsInside() const
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

  /// SourceFace::covered among the open faces of a surface, or among its barriers.
  std::vector<std::vector<RankAddress>> findCovered(
    const PolyDataSurface& surface, bool amongBarriers, const Job& job)
  {
    const MeshPartition& part = amongBarriers ? surface.barriers->surface() : surface.partition;
    const TriangleMesh& onto = part.mesh();
    std::vector<Vec3> middles;
    std::vector<std::uint8_t> isWanted;
    for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
    {
      middles.push_back(middleOf(onto, face));
      isWanted.push_back(this->box_.distanceTo(middles.back()) <= onto.shape(face).longest());
    }
    const ClosestFaces closest = this->locator_.closest(middles, isWanted, this->precision_, job);
    std::vector<FaceInside> own;
    for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
    {
      const auto [block, cell] = surface.inputCellOf(
        amongBarriers ? surface.triangleOfBarrier(face) : surface.triangleOf(face));
      for (const ClosestFace& found : closest[face - part.firstOwnFace()])
      {
        const std::size_t by = this->faces_[found.face.id];
        const bool isKnown = !own.empty() && own.back().face.id == face && own.back().by == by;
        if (!isKnown && this->covers(by, onto, face))
        {
          own.push_back({ part.addressOf(face), by,
            { part.exchange().rank(), static_cast<vtkIdType>(block), cell },
            onto.shape(face).area2 });
        }
      }
    }
    std::vector<std::vector<FaceInside>> inside(this->first_.size() - 1);
    for (const FaceInside& face : valuesOfRanks(part.exchange(), own))
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

private:
  TriangleMesh meshOf(const std::vector<SourceFace>& faces)
  {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (const SourceFace& face : faces)
    {
      const Id offset = static_cast<Id>(points.size());
      for (const Triangle& t : face.triangles)
      {
        triangles.push_back({ offset + t[0], offset + t[1], offset + t[2] });
      }
      this->faces_.resize(triangles.size(), this->first_.size() - 1);
      this->first_.push_back(static_cast<Id>(triangles.size()));
      for (const Vec3& point : face.outline.points)
      {
        points.push_back(point);
        this->box_.add(point);
      }
    }
    return TriangleMesh(std::move(points), triangles);
  }

  /// Corners, middles of edges, and the middle: a polygon covers a triangle on its own corners if
  /// it has these.
  bool covers(std::size_t by, const TriangleMesh& surface, Id face) const
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

  bool holds(std::size_t by, const Vec3& point) const
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

  double area2(std::size_t of) const
  {
    double area2 = 0.0;
    for (Id triangle = this->first_[of]; triangle < this->first_[of + 1]; ++triangle)
    {
      area2 += this->mesh_.shape(triangle).area2;
    }
    return area2;
  }

  double precision_;
  Box box_;
  /// The face of each triangle, and the first triangle of each face.
  std::vector<std::size_t> faces_;
  std::vector<Id> first_;
  TriangleMesh mesh_;
  SurfaceLocator locator_;
};

void leaveOutFacesInBarriers(
  const PartsRequest& from, const Job& job, SourceFaceMesh& mesh, SourceCells& cells)
{
  const std::vector<LocatedPolyline> inside = mesh.pointsInside();
  const LocatedPlaces places = from.locator.locate(inside, cells.precision, job);
  // Thin faces, too, lie in one or in the other: no rim.
  const std::vector<RankAddress> barriers =
    from.surface.barriers->barriersAt(places.places, places.faces, cells.precision, 0.0);
  const std::vector<std::vector<RankAddress>> covered =
    mesh.findCovered(from.surface, true, job.part(1.0, 1.0));
  std::vector<SourceFace> left;
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    // An open face of another sheet may go through a barrier's middle.
    const bool isClosest = barriers[places.indexOf(inside[i].points.front())].id != NoId;
    if (!isClosest && (covered[i].empty() || !cells.faces[i].covered.empty()))
    {
      left.push_back(std::move(cells.faces[i]));
    }
  }
  cells.faces = std::move(left);
  if (cells.isEmpty())
  {
    throw InputError("All of the source (input port 1) lies in barriers (BarrierArrayName), which "
                     "no path may leave. Choose faces outside of barriers.");
  }
}

} // anonymous namespace

void placeFaces(const PartsRequest& from, const Job& job, SourceCells& cells)
{
  SourceFaceMesh mesh(cells);
  std::vector<std::vector<RankAddress>> covered =
    mesh.findCovered(from.surface, false, job.part(0.0, 0.0));
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    cells.faces[i].covered = std::move(covered[i]);
  }
  if (from.surface.barriers && !from.targets)
  {
    leaveOutFacesInBarriers(from, job, mesh, cells);
  }
}

}
