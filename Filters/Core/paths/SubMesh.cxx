// SPDX-License-Identifier: BSD-3-Clause
#include "paths/SubMesh.h"

#include <algorithm>
#include <utility>

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

/// A point of one mesh as a point of another, whose numbers of vertices and faces are given.
SurfacePoint transferred(const TriangleMesh& from, const SurfacePoint& point,
  const TriangleMesh& to, const std::vector<Id>& vertices, const std::vector<Id>& faces)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return SurfacePoint::atVertex(vertices[point.id]);
  }
  const Id face = someFace(from, point);
  return fromBarycentric(to, faces[face], barycentric(from, point, face));
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
    workSpace.patchFace.resize(mesh.numberOfFaces(), NoId);
  }
  ~FaceGatherer()
  {
    for (const Id vertex : this->vertices)
    {
      this->workSpace_.patchVertex[vertex] = NoId;
    }
    for (const Id face : this->touchedFaces_)
    {
      this->workSpace_.patchFace[face] = NoId;
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
      if (this->workSpace_.patchFace[face] == NoId)
      {
        this->workSpace_.patchFace[face] = LeftOut;
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

  /// The numbers in the patch of the surface's vertices and faces.
  const std::vector<Id>& patchVertices() const { return this->workSpace_.patchVertex; }
  const std::vector<Id>& patchFaces() const { return this->workSpace_.patchFace; }

  /// The surface's numbers of the patch's vertices and faces.
  std::vector<Id> vertices;
  std::vector<Id> faces;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;

private:
  static constexpr Id LeftOut = NoId - 1;

  void take(Id face)
  {
    this->workSpace_.patchFace[face] = static_cast<Id>(this->faces.size());
    this->faces.push_back(face);
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
  const auto onPatch = [&](const SurfacePoint& point)
  {
    return transferred(
      surface, point, *this->mesh_, gatherer.patchVertices(), gatherer.patchFaces());
  };
  this->first_ = onPatch(first);
  this->second_ = onPatch(second);
  this->vertices_ = gatherer.vertices; // which it needs to clean the work space
  this->faces_ = std::move(gatherer.faces);
}

SurfacePoint SubMesh::onSurface(const SurfacePoint& point) const
{
  return this->mesh_
    ? transferred(*this->mesh_, point, this->surface_, this->vertices_, this->faces_)
    : point;
}

}
