// SPDX-License-Identifier: BSD-3-Clause
#include "paths/SubMesh.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Whether a face may contain a point whose distances in space from the two points add up to no
/// more than the bound. The sum grows by at most 2 for each unit of way.
bool isWithin(const TriangleMesh& mesh, Id face, const SurfacePoint& first,
  const SurfacePoint& second, double bound)
{
  const SurfacePoint centre = SurfacePoint::inFace(face, 1.0 / 3.0, 1.0 / 3.0);
  double radius = 0.0;
  for (const Id vertex : mesh.triangle(face))
  {
    radius = std::max(radius, distanceInSpace(mesh, mesh.point(vertex), centre));
  }
  return distanceInSpace(mesh, centre, first) + distanceInSpace(mesh, centre, second) -
    2.0 * radius <=
    bound;
}

/// The face of the mesh on these vertices, which exists.
Id faceWith(const TriangleMesh& mesh, const Triangle& vertices)
{
  const auto fewerFaces = [&](Id a, Id b)
  { return mesh.cornersAt(a).size() < mesh.cornersAt(b).size(); };
  for (const Id corner :
    mesh.cornersAt(*std::min_element(vertices.begin(), vertices.end(), fewerFaces)))
  {
    const Triangle& t = mesh.triangle(TriangleMesh::faceOf(corner));
    if (std::is_permutation(t.begin(), t.end(), vertices.begin()))
    {
      return TriangleMesh::faceOf(corner);
    }
  }
  return NoId;
}

/// A point of one mesh as a point of another mesh that has the faces around the point, with their
/// vertices renumbered.
template <typename Rename>
SurfacePoint transferred(
  const TriangleMesh& from, const SurfacePoint& point, const TriangleMesh& to, Rename&& rename)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return SurfacePoint::atVertex(rename(point.id));
  }
  const Id fromFace = someFace(from, point);
  const std::array<double, 3> weights = barycentric(from, point, fromFace);
  Triangle renamed = from.triangle(fromFace);
  std::transform(renamed.begin(), renamed.end(), renamed.begin(), rename);
  const Id toFace = faceWith(to, renamed);
  const Triangle& corners = to.triangle(toFace);
  std::array<double, 3> permuted;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto at = std::find(renamed.begin(), renamed.end(), corners[k]) - renamed.begin();
    permuted[k] = weights[static_cast<std::size_t>(at)];
  }
  return fromBarycentric(to, toFace, permuted);
}

/// Gathers the faces that a path within a bound can touch between two points, from face to face
/// across shared vertices.
class FaceGatherer
{
public:
  FaceGatherer(const TriangleMesh& mesh, SubMesh::WorkSpace& workSpace)
    : mesh_(mesh)
    , workSpace_(workSpace)
  {
    workSpace.patchVertex.resize(mesh.numberOfVertices(), NoId);
    workSpace.faceSeen.resize(mesh.numberOfFaces(), 0);
  }
  ~FaceGatherer()
  {
    for (const Id vertex : this->vertices)
    {
      this->workSpace_.patchVertex[vertex] = NoId;
    }
    for (const Id face : this->touchedFaces_)
    {
      this->workSpace_.faceSeen[face] = 0;
    }
  }
  FaceGatherer(const FaceGatherer&) = delete;
  FaceGatherer& operator=(const FaceGatherer&) = delete;

  /// Stops as soon as there are more faces than `maximum`.
  void gather(const SurfacePoint& first, const SurfacePoint& second, double bound,
    std::size_t maximum, const ProgressCallback& progress)
  {
    const auto visit = [&](Id face)
    {
      if (!this->workSpace_.faceSeen[face])
      {
        this->workSpace_.faceSeen[face] = 1;
        this->touchedFaces_.push_back(face);
        const bool holdsEnd =
          contains(this->mesh_, face, first) || contains(this->mesh_, face, second);
        if (holdsEnd || isWithin(this->mesh_, face, first, second, bound))
        {
          this->take(face);
        }
      }
    };
    forEachFace(this->mesh_, first, visit);
    for (std::size_t next = 0; next < this->vertices.size() && this->triangles.size() <= maximum;
         ++next)
    {
      forEachFace(this->mesh_, SurfacePoint::atVertex(this->vertices[next]), visit);
      constexpr std::size_t stepsPerReport = 4096;
      if ((next + 1) % stepsPerReport == 0)
      {
        reportProgress(progress, 0.0);
      }
    }
  }

  Id patchVertex(Id vertex) const { return this->workSpace_.patchVertex[vertex]; }

  std::vector<Id> vertices;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;

private:
  void take(Id face)
  {
    Triangle corners = this->mesh_.triangle(face);
    for (Id& vertex : corners)
    {
      Id& renamed = this->workSpace_.patchVertex[vertex];
      if (renamed == NoId)
      {
        renamed = static_cast<Id>(this->vertices.size());
        this->vertices.push_back(vertex);
        this->points.push_back(this->mesh_.point(vertex));
      }
      vertex = renamed;
    }
    this->triangles.push_back(corners);
  }

  const TriangleMesh& mesh_;
  SubMesh::WorkSpace& workSpace_;
  std::vector<Id> touchedFaces_;
};

} // anonymous namespace

SubMesh::SubMesh(const TriangleMesh& surface, const SurfacePoint& first, const SurfacePoint& second,
  double bound, WorkSpace& workSpace, const ProgressCallback& progress)
  : surface_(surface)
  , first_(first)
  , second_(second)
{
  // A mesh of a larger part would cost about as much as it saves.
  constexpr std::size_t largePart = 4;
  const std::size_t maximum = surface.numberOfFaces() / largePart;
  FaceGatherer gatherer(surface, workSpace);
  gatherer.gather(first, second, bound, maximum, progress);
  if (gatherer.triangles.size() > maximum)
  {
    return;
  }
  this->mesh_ = std::make_unique<TriangleMesh>(std::move(gatherer.points), gatherer.triangles);
  const auto rename = [&](Id vertex) { return gatherer.patchVertex(vertex); };
  this->first_ = transferred(surface, first, *this->mesh_, rename);
  this->second_ = transferred(surface, second, *this->mesh_, rename);
  this->vertices_ = gatherer.vertices;
}

SurfacePoint SubMesh::onSurface(const SurfacePoint& point) const
{
  return this->mesh_ ? transferred(*this->mesh_, point, this->surface_,
                         [this](Id vertex) { return this->vertices_[vertex]; })
                     : point;
}

}
