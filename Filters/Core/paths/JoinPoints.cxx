// SPDX-License-Identifier: BSD-3-Clause
#include "paths/JoinPoints.h"

#include "Errors.h"
#include "Tolerance.h"
#include "field/DistanceField.h"
#include "field/RetentionAround.h"
#include "paths/PathCorridor.h"
#include "paths/PathInWindows.h"
#include "paths/PathTracer.h"

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

/// The straight distance from a point to a vertex of its faces, by the lengths of edges: faces
/// without area that conduct have a height that they do not have in space.
double distanceInFaces(const TriangleMesh& mesh, const SurfacePoint& point, Id vertex)
{
  double distance = Infinity;
  forEachFace(mesh, point,
    [&](Id face)
    {
      const Triangle& corners = mesh.triangle(face);
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (corners[k] == vertex)
        {
          const Vec2 way = wayInFrame(
            mesh, longestHalfedge(mesh, face), barycentric(mesh, point, face), cornerWeights(k));
          distance = std::min(distance, norm(way));
        }
      }
    });
  return distance;
}

struct QueuedVertex
{
  double estimate;
  double length;
  Id vertex;
  bool operator<(const QueuedVertex& other) const
  {
    return this->estimate != other.estimate ? this->estimate > other.estimate
                                            : this->vertex > other.vertex;
  }
};

/// The length of a shortest path along mesh edges, by best-first search (A*: the remaining distance
/// in space is a lower bound). Infinite if no path joins the points.
double lengthAlongEdges(
  const TriangleMesh& mesh, const SurfacePoint& first, const SurfacePoint& second, const Job& job)
{
  std::unordered_map<Id, double> lengthTo;
  std::priority_queue<QueuedVertex> queue;
  const auto shorten = [&](Id vertex, double length)
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
    shorten(vertex, distanceInFaces(mesh, first, vertex));
  }
  const std::vector<Id> goals = verticesAround(mesh, second); // the way from there is straight
  double best = Infinity;
  for (std::size_t step = 1; !queue.empty() && queue.top().estimate < best; ++step)
  {
    const QueuedVertex top = queue.top();
    queue.pop();
    if (top.length == lengthTo[top.vertex])
    {
      const bool isGoal = std::find(goals.begin(), goals.end(), top.vertex) != goals.end();
      best = isGoal ? std::min(best, top.length + distanceInFaces(mesh, second, top.vertex)) : best;
      for (const Id corner : mesh.cornersAt(top.vertex))
      {
        const Id previous = TriangleMesh::previousInFace(corner);
        shorten(mesh.destination(corner), top.length + mesh.length(corner));
        shorten(mesh.origin(previous), top.length + mesh.length(previous));
      }
    }
    constexpr std::size_t stepsPerReport = 4096;
    if (step % stepsPerReport == 0)
    {
      job.look();
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

/// The faces that paths of at most this length between two points can touch: those whose distances
/// in space from the two points add up to no more. None if they are a large part of the surface: a
/// mesh of these would cost about as much as it saves.
std::vector<Id> facesWithin(const TriangleMesh& surface, const SurfacePoint& first,
  const SurfacePoint& second, double longest, const Job& job)
{
  constexpr std::size_t largePart = 4;
  const std::size_t maximum = surface.numberOfFaces() / largePart;
  std::vector<Id> faces;
  std::vector<bool> isVisited(surface.numberOfFaces(), false);
  const auto visit = [&](Id face)
  {
    const bool isNew = !isVisited[face];
    isVisited[face] = true;
    if (isNew &&
      (contains(surface, face, first) || contains(surface, face, second) ||
        isWithin(surface, face, first, second, longest)))
    {
      faces.push_back(face);
    }
  };
  // Goes from face to face across shared vertices.
  forEachFace(surface, first, visit);
  for (std::size_t next = 0; next < faces.size() && faces.size() <= maximum; ++next)
  {
    const Triangle& corners = surface.triangle(faces[next]);
    for (const Id vertex : corners)
    {
      forEachFace(surface, SurfacePoint::atVertex(vertex), visit);
    }
    constexpr std::size_t stepsPerReport = 4096;
    if ((next + 1) % stepsPerReport == 0)
    {
      job.look();
    }
  }
  return faces.size() <= maximum ? faces : std::vector<Id>();
}

/// The fraction of the job at which the search ends.
constexpr double ShareOfSearch = 0.7;

std::vector<double> distancesInSpace(const TriangleMesh& mesh, const SurfacePoint& point)
{
  std::vector<double> distances;
  distances.reserve(mesh.numberOfVertices());
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    distances.push_back(distanceInSpace(mesh, mesh.point(vertex), point));
  }
  return distances;
}

/// Finds a shortest path between two points of a surface.
///
/// \param length an upper bound of the path's length. The mesh must contain all faces that a path
///        of that length can touch.
/// \returns the path from the first point to the second; empty if there is none.
std::vector<SurfacePoint> shortestPath(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, double length, const Job& job)
{
  const Corridor within{ distancesInSpace(mesh, first), length };
  const Corridor corridor = corridorTo(MeshPartition(mesh), ReplicatedPatch(mesh), second, first,
    &within, job.part(0.0, ShareOfSearch));
  FrontOptions options;
  options.corridor = &corridor;
  options.keepArrivals = true;
  options.job = job.part(ShareOfSearch, 1.0);
  RetentionAround aroundSecond(mesh, { second });
  aroundSecond.keepForPaths(MeshPartition(mesh));
  FrontResult front = propagate(mesh, { pointCurve(first) }, options, aroundSecond);
  const DistanceField field(MeshPartition(mesh), std::move(front), aroundSecond.release());
  TracedPath path = beginPath(field, second);
  followPath(field, path);
  if (path.next == PathState::Next::Lost)
  {
    // Seldom: by windows that are all kept, in the corridor alone.
    options.job = job.part(1.0, 1.0);
    path.points =
      pathInWindows(solve(mesh, { pointCurve(first) }, options, KeepWindows::All), second);
  }
  std::reverse(path.points.begin(), path.points.end());
  return std::move(path.points);
}

/// The same on a mesh of some of the faces, where a search does not cost as much as on the whole
/// surface. The points are those of the surface.
std::vector<SurfacePoint> shortestPathIn(const std::vector<Id>& faces, const TriangleMesh& surface,
  const SurfacePoint& first, const SurfacePoint& second, double length, const Job& job)
{
  std::unordered_map<Id, Id> renamed;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  for (const Id face : faces)
  {
    Triangle& corners = triangles.emplace_back(surface.triangle(face));
    for (Id& vertex : corners)
    {
      const auto [name, isNew] = renamed.try_emplace(vertex, static_cast<Id>(points.size()));
      if (isNew)
      {
        points.push_back(surface.point(vertex));
      }
      vertex = name->second;
    }
  }
  const TriangleMesh part(std::move(points), triangles);
  const auto onPart = [&](const SurfacePoint& point)
  {
    const Id face = someFace(surface, point);
    const auto found = std::find(faces.begin(), faces.end(), face);
    return fromBarycentric(
      part, static_cast<Id>(found - faces.begin()), barycentric(surface, point, face));
  };
  std::vector<SurfacePoint> path = shortestPath(part, onPart(first), onPart(second), length, job);
  for (SurfacePoint& point : path)
  {
    const Id face = someFace(part, point);
    point = fromBarycentric(surface, faces[face], barycentric(part, point, face));
  }
  return path;
}

/// Whether consecutive points have a common face. If the path broke off or is empty, its ends have
/// none.
bool isWhole(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path)
{
  const auto areApart = [&](const SurfacePoint& a, const SurfacePoint& b)
  { return commonFace(mesh, a, b) == NoId; };
  return std::adjacent_find(path.begin(), path.end(), areApart) == path.end();
}

/// Gives a path on the surface the two points that it was looked for between as its ends: on the
/// sub-mesh they were rounded.
void setEnds(const SurfacePoint& first, const SurfacePoint& second, std::vector<SurfacePoint>& path)
{
  path.resize(std::max<std::size_t>(path.size(), 2));
  path.front() = first;
  path.back() = second;
}

/// If an end lies beside a vertex or an edge by a rounding, the path goes over the vertex or edge:
/// there the sub-mesh has the end, so that the path may leave through another face.
void linkEnds(const TriangleMesh& mesh, std::vector<SurfacePoint>& path)
{
  if (commonFace(mesh, path[0], path[1]) == NoId)
  {
    path.insert(path.begin() + 1, normalized(mesh, path.front()));
  }
  if (commonFace(mesh, path[path.size() - 2], path.back()) == NoId)
  {
    path.insert(path.end() - 1, normalized(mesh, path.back()));
  }
}

std::vector<SurfacePoint> pathBetween(
  const TriangleMesh& mesh, const SurfacePoint& first, const SurfacePoint& second, const Job& job)
{
  if (commonFace(mesh, first, second) != NoId)
  {
    return { first, second };
  }
  const double longest =
    (1.0 + tolerance::BoundMargin) * lengthAlongEdges(mesh, first, second, job);
  if (longest == Infinity)
  {
    return {};
  }
  const std::vector<Id> faces = facesWithin(mesh, first, second, longest, job);
  std::vector<SurfacePoint> path = faces.empty()
    ? shortestPath(mesh, first, second, longest, job)
    : shortestPathIn(faces, mesh, first, second, longest, job);
  setEnds(first, second, path);
  path = cleanedPath(mesh, path, longest);
  linkEnds(mesh, path);
  if (!isWhole(mesh, path))
  {
    throw Error("The shortest path between two points of the source could not be traced.");
  }
  return path;
}

} // anonymous namespace

JoinPoints joinByShortestPaths(const TriangleMesh& mesh)
{
  return [&mesh](const SurfacePoint& first, const SurfacePoint& second, const Job& job)
  { return pathBetween(mesh, first, second, job); };
}

JoinPoints JoinedPaths::joinBy(JoinPoints join, const JoinedPaths& earlier)
{
  const auto keyOf = [](const SurfacePoint& p) { return PointKey(p.kind, p.id, p.u, p.v); };
  return [this, keyOf, &earlier, join = std::move(join)](
           const SurfacePoint& first, const SurfacePoint& second, const Job& job)
  {
    const auto [path, isNew] = this->paths_.try_emplace(Ends(keyOf(first), keyOf(second)));
    if (isNew)
    {
      const auto known = earlier.paths_.find(path->first);
      path->second = known != earlier.paths_.end() ? known->second : join(first, second, job);
    }
    return path->second;
  };
}

}
