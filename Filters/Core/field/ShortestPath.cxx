// SPDX-License-Identifier: BSD-3-Clause
#include "field/ShortestPath.h"

#include "Errors.h"
#include "field/Solve.h"
#include "Tolerance.h"

#include <algorithm>
#include <queue>

namespace geodesic
{

namespace
{

/// Steps of a walk over the mesh between two calls of the progress callback: well under a tenth of
/// a second.
constexpr std::size_t StepsPerReport = 4096;

void report(const ProgressCallback& progress, double fraction)
{
  if (progress && !progress(fraction))
  {
    throw Aborted();
  }
}

/// The vertices that the point sees straight within the faces around it.
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

/// Best-first search along mesh edges, from one point to another (A*: the distance in space that is
/// left is a lower bound).
class EdgeSearch
{
public:
  EdgeSearch(const TriangleMesh& mesh, const Vec3& target, std::vector<double>& lengthTo)
    : mesh_(mesh)
    , target_(target)
    , lengthTo_(lengthTo)
  {
    this->lengthTo_.resize(mesh.numberOfVertices(), Infinity);
  }
  ~EdgeSearch()
  {
    for (const Id vertex : this->touched_)
    {
      this->lengthTo_[vertex] = Infinity;
    }
  }
  EdgeSearch(const EdgeSearch&) = delete;
  EdgeSearch& operator=(const EdgeSearch&) = delete;

  void reach(Id vertex, double length)
  {
    if (length < this->lengthTo_[vertex])
    {
      if (this->lengthTo_[vertex] == Infinity)
      {
        this->touched_.push_back(vertex);
      }
      this->lengthTo_[vertex] = length;
      this->queue_.push(
        { length + norm(this->mesh_.point(vertex) - this->target_), length, vertex });
    }
  }

  /// The length of the shortest path to the target by way of one of the goals, from each of which
  /// it is straight.
  double run(const std::vector<Id>& goals, const ProgressCallback& progress)
  {
    double best = Infinity;
    for (std::size_t step = 1; !this->queue_.empty(); ++step)
    {
      const Entry top = this->queue_.top();
      this->queue_.pop();
      if (top.estimate >= best)
      {
        break;
      }
      if (top.length == this->lengthTo_[top.vertex])
      {
        const bool isGoal = std::find(goals.begin(), goals.end(), top.vertex) != goals.end();
        best = isGoal ? top.estimate : best;
        this->expand(top);
      }
      if (step % StepsPerReport == 0)
      {
        report(progress, 0.0);
      }
    }
    return best;
  }

private:
  struct Entry
  {
    double estimate;
    double length;
    Id vertex;
    bool operator<(const Entry& other) const { return this->estimate > other.estimate; }
  };

  void expand(const Entry& entry)
  {
    for (const Id corner : this->mesh_.cornersAt(entry.vertex))
    {
      const Id previous = TriangleMesh::previousInFace(corner);
      this->reach(this->mesh_.destination(corner), entry.length + this->mesh_.length(corner));
      this->reach(this->mesh_.origin(previous), entry.length + this->mesh_.length(previous));
    }
  }

  const TriangleMesh& mesh_;
  const Vec3 target_;
  std::vector<double>& lengthTo_;
  std::vector<Id> touched_;
  std::priority_queue<Entry> queue_;
};

/// The length of a path from one point to the other along mesh edges; infinite where there is none.
double boundAlongEdges(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, std::vector<double>& lengthTo, const ProgressCallback& progress)
{
  const Vec3 start = position(mesh, first);
  EdgeSearch search(mesh, position(mesh, second), lengthTo);
  for (const Id vertex : verticesAround(mesh, first))
  {
    search.reach(vertex, norm(mesh.point(vertex) - start));
  }
  return search.run(verticesAround(mesh, second), progress);
}

/// Whether a face may hold a point whose distances in space to the two points add up to no more
/// than the bound. The sum grows by at most 2 for each unit of way.
bool isWithin(
  const TriangleMesh& mesh, Id face, const Vec3& first, const Vec3& second, double bound)
{
  const Triangle& corners = mesh.triangle(face);
  const Vec3& origin = mesh.point(corners[0]);
  const Vec3 toCentre =
    (1.0 / 3.0) * (mesh.point(corners[1]) - origin + (mesh.point(corners[2]) - origin));
  const Vec3 centre = origin + toCentre;
  double radius = 0.0;
  for (const Id vertex : corners)
  {
    radius = std::max(radius, norm(mesh.point(vertex) - centre));
  }
  return norm(centre - first) + norm(centre - second) - 2.0 * radius <= bound;
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

/// A point of one mesh as a point of another that has the faces around it, its vertices renamed.
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

/// The vertex that an edge point cannot be told from by the rounding of tracing; else the point.
SurfacePoint atVertexWithin(const TriangleMesh& mesh, const SurfacePoint& point, double rounding)
{
  if (point.kind != SurfacePoint::Kind::Edge)
  {
    return point;
  }
  const double length = mesh.length(point.id);
  const double reach = std::min(rounding, tolerance::SnapFraction * length);
  if (point.u * length <= reach)
  {
    return SurfacePoint::atVertex(mesh.origin(point.id));
  }
  if ((1.0 - point.u) * length <= reach)
  {
    return SurfacePoint::atVertex(mesh.destination(point.id));
  }
  return point;
}

/// The part of the surface that a path can reach, as a mesh of its own.
struct Patch
{
  TriangleMesh mesh;
  /// The surface's vertex of each vertex of the patch.
  std::vector<Id> vertices;
};

/// Gathers the faces that a path from one point to another no longer than a bound can touch, going
/// from face to face across shared vertices.
class PatchSearch
{
public:
  PatchSearch(
    const TriangleMesh& mesh, std::vector<Id>& patchVertex, std::vector<std::uint8_t>& faceSeen)
    : mesh_(mesh)
    , patchVertex_(patchVertex)
    , faceSeen_(faceSeen)
  {
    this->patchVertex_.resize(mesh.numberOfVertices(), NoId);
    this->faceSeen_.resize(mesh.numberOfFaces(), 0);
  }
  ~PatchSearch()
  {
    for (const Id vertex : this->vertices_)
    {
      this->patchVertex_[vertex] = NoId;
    }
    for (const Id face : this->touchedFaces_)
    {
      this->faceSeen_[face] = 0;
    }
  }
  PatchSearch(const PatchSearch&) = delete;
  PatchSearch& operator=(const PatchSearch&) = delete;

  Patch run(const SurfacePoint& first, const SurfacePoint& second, double bound,
    const ProgressCallback& progress)
  {
    const Vec3 p = position(this->mesh_, first);
    const Vec3 q = position(this->mesh_, second);
    const auto visit = [&](Id face)
    {
      if (!this->faceSeen_[face])
      {
        this->faceSeen_[face] = 1;
        this->touchedFaces_.push_back(face);
        const bool holdsEnd =
          contains(this->mesh_, face, first) || contains(this->mesh_, face, second);
        if (holdsEnd || isWithin(this->mesh_, face, p, q, bound))
        {
          this->take(face);
        }
      }
    };
    forEachFace(this->mesh_, first, visit);
    for (std::size_t next = 0; next < this->vertices_.size(); ++next)
    {
      forEachFace(this->mesh_, SurfacePoint::atVertex(this->vertices_[next]), visit);
      if ((next + 1) % StepsPerReport == 0)
      {
        report(progress, 0.0);
      }
    }
    return { TriangleMesh(this->points_, this->triangles_), this->vertices_ };
  }

  Id patchVertex(Id vertex) const { return this->patchVertex_[vertex]; }

private:
  void take(Id face)
  {
    Triangle corners = this->mesh_.triangle(face);
    for (Id& vertex : corners)
    {
      Id& renamed = this->patchVertex_[vertex];
      if (renamed == NoId)
      {
        renamed = static_cast<Id>(this->vertices_.size());
        this->vertices_.push_back(vertex);
        this->points_.push_back(this->mesh_.point(vertex));
      }
      vertex = renamed;
    }
    this->triangles_.push_back(corners);
  }

  const TriangleMesh& mesh_;
  std::vector<Id>& patchVertex_;
  std::vector<std::uint8_t>& faceSeen_;
  std::vector<Id> vertices_;
  std::vector<Id> touchedFaces_;
  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
};

/// A shortest path in a patch, from the engine's field around the first point.
std::vector<SurfacePoint> pathInPatch(const TriangleMesh& patch, const SurfacePoint& first,
  const SurfacePoint& second, double bound, const ProgressCallback& progress)
{
  SourceCurve source;
  source.points = { first };
  source.isCut = { 0 };
  FrontOptions options;
  // Where the bound is zero, across faces without extent, the limit would be none either way.
  options.maximumDistance = bound > 0.0 ? bound : Infinity;
  options.progress = progress;
  std::vector<SurfacePoint> path = solve(patch, { source }, options, KeepWindows::All).path(second);
  std::reverse(path.begin(), path.end());
  return path;
}

/// Leaves out what tracing adds by rounding: crossings of edges at their ends, repeated points. The
/// ends are the given ones. What is left has the faces in common that it had.
std::vector<SurfacePoint> cleaned(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path,
  const SurfacePoint& first, const SurfacePoint& second, double length)
{
  std::vector<SurfacePoint> result = { first };
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    const SurfacePoint point = atVertexWithin(mesh, path[i], tolerance::PathAtVertex * length);
    if (!samePlace(mesh, point, result.back()))
    {
      result.push_back(point);
    }
  }
  if (result.size() > 1 && samePlace(mesh, result.back(), second))
  {
    result.pop_back();
  }
  result.push_back(second);
  return result;
}

/// A path that broke off, or an empty one, has ends without a common face.
void checkWhole(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path)
{
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    if (commonFace(mesh, path[i - 1], path[i]) == NoId)
    {
      throw Error("The shortest path between two points of the source could not be traced.");
    }
  }
}

} // anonymous namespace

std::vector<SurfacePoint> ShortestPathFinder::between(
  const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)
{
  if (commonFace(this->mesh_, first, second) != NoId)
  {
    return { first, second };
  }
  report(progress, 0.0);
  const double bound = (1.0 + tolerance::BoundMargin) *
    boundAlongEdges(this->mesh_, first, second, this->lengthTo_, progress);
  if (bound == Infinity)
  {
    return {};
  }

  PatchSearch search(this->mesh_, this->patchVertex_, this->faceSeen_);
  const Patch patch = search.run(first, second, bound, progress);
  const auto toPatch = [&](const SurfacePoint& point)
  {
    return transferred(
      this->mesh_, point, patch.mesh, [&](Id vertex) { return search.patchVertex(vertex); });
  };
  std::vector<SurfacePoint> path =
    pathInPatch(patch.mesh, toPatch(first), toPatch(second), bound, progress);
  for (SurfacePoint& point : path)
  {
    point = transferred(
      patch.mesh, point, this->mesh_, [&](Id vertex) { return patch.vertices[vertex]; });
  }
  path = cleaned(this->mesh_, path, first, second, bound);
  checkWhole(this->mesh_, path);
  return path;
}

}
