// SPDX-License-Identifier: BSD-3-Clause
#include "paths/SubMesh.h"

#include "Tolerance.h"

#include <algorithm>
#include <queue>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

/// The vertices of the faces around a point, to which the way is straight; of a vertex only itself.
std::vector<Id> verticesAround(const TriangleMesh& mesh, const SurfacePoint& point)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return { point.id };
  }
  std::vector<Id> result;
  forEachFace(mesh, point,
    [&](Id face)
    {
      const Triangle& corners = mesh.triangle(face);
      result.insert(result.end(), corners.begin(), corners.end());
    });
  return result;
}

struct Entry
{
  double estimate;
  double length;
  Id vertex;
  bool operator<(const Entry& other) const { return this->estimate > other.estimate; }
};

/// The length of a shortest path along mesh edges, by best-first search (A*: the remaining distance
/// in space is a lower bound). Infinite if no path joins the points.
double lengthAlongEdges(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, const ProgressCallback& progress)
{
  std::unordered_map<Id, double> lengthTo;
  std::priority_queue<Entry> queue;
  const auto reach = [&](Id vertex, double length)
  {
    double& known = lengthTo.try_emplace(vertex, Infinity).first->second;
    if (length < known)
    {
      known = length;
      queue.push({ length + distanceInSpace(mesh, mesh.point(vertex), second), length, vertex });
    }
  };
  for (const Id vertex : verticesAround(mesh, first))
  {
    reach(vertex, distanceInSpace(mesh, mesh.point(vertex), first));
  }
  const std::vector<Id> goals = verticesAround(mesh, second); // the way from there is straight
  double best = Infinity;
  for (std::size_t step = 1; !queue.empty() && queue.top().estimate < best; ++step)
  {
    const Entry top = queue.top();
    queue.pop();
    if (top.length == lengthTo[top.vertex])
    {
      const bool isGoal = std::find(goals.begin(), goals.end(), top.vertex) != goals.end();
      best = isGoal ? top.estimate : best;
      for (const Id corner : mesh.cornersAt(top.vertex))
      {
        const Id previous = TriangleMesh::previousInFace(corner);
        reach(mesh.destination(corner), top.length + mesh.length(corner));
        reach(mesh.origin(previous), top.length + mesh.length(previous));
      }
    }
    constexpr std::size_t stepsPerReport = 4096;
    if (step % stepsPerReport == 0)
    {
      reportProgress(progress, 0.0);
    }
  }
  return best;
}

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

Id placeOf(Id number, const std::vector<Id>& numbers)
{
  return static_cast<Id>(std::find(numbers.begin(), numbers.end(), number) - numbers.begin());
}

} // anonymous namespace

// Goes from face to face across shared vertices.
SubMesh::SubMesh(const TriangleMesh& surface, const SurfacePoint& first, const SurfacePoint& second,
  const ProgressCallback& progress)
  : surface_(surface)
  , bound_((1.0 + tolerance::BoundMargin) * lengthAlongEdges(surface, first, second, progress))
{
  if (this->bound_ == Infinity)
  {
    return;
  }
  // A mesh of a larger part would cost about as much as it saves.
  constexpr std::size_t largePart = 4;
  const std::size_t maximum = surface.numberOfFaces() / largePart;
  std::unordered_map<Id, Id> patchVertex;
  std::vector<bool> isVisited(surface.numberOfFaces(), false);
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  const auto take = [&](Id face)
  {
    this->faces_.push_back(face);
    Triangle& corners = triangles.emplace_back(surface.triangle(face));
    for (Id& vertex : corners)
    {
      const auto [renamed, isNew] = patchVertex.try_emplace(vertex, static_cast<Id>(points.size()));
      if (isNew)
      {
        this->vertices_.push_back(vertex);
        points.push_back(surface.point(vertex));
      }
      vertex = renamed->second;
    }
  };
  const auto visit = [&](Id face)
  {
    const bool isNew = !isVisited[face];
    isVisited[face] = true;
    if (isNew &&
      (contains(surface, face, first) || contains(surface, face, second) ||
        isWithin(surface, face, first, second, this->bound_)))
    {
      take(face);
    }
  };
  forEachFace(surface, first, visit);
  for (std::size_t next = 0; next < this->vertices_.size() && triangles.size() <= maximum; ++next)
  {
    forEachFace(surface, SurfacePoint::atVertex(this->vertices_[next]), visit);
    constexpr std::size_t stepsPerReport = 4096;
    if ((next + 1) % stepsPerReport == 0)
    {
      reportProgress(progress, 0.0);
    }
  }
  if (triangles.size() <= maximum)
  {
    this->mesh_.emplace(std::move(points), triangles);
  }
}

SurfacePoint SubMesh::onPatch(const SurfacePoint& point) const
{
  if (!this->mesh_)
  {
    return point;
  }
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return SurfacePoint::atVertex(placeOf(point.id, this->vertices_));
  }
  const Id face = someFace(this->surface_, point);
  return fromBarycentric(
    *this->mesh_, placeOf(face, this->faces_), barycentric(this->surface_, point, face));
}

SurfacePoint SubMesh::onSurface(const SurfacePoint& point) const
{
  if (!this->mesh_)
  {
    return point;
  }
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return SurfacePoint::atVertex(this->vertices_[point.id]);
  }
  const Id face = someFace(*this->mesh_, point);
  return fromBarycentric(
    this->surface_, this->faces_[face], barycentric(*this->mesh_, point, face));
}

}
