// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathTracer.h"

#include "Errors.h"
#include "Tolerance.h"
#include "field/WaysIntoFace.h"
#include "window/UnfoldedFace.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The shortest way from a corner or through a window to the last point of a path, through this
/// rank's faces except the one that the search leaves out.
struct WayToPoint
{
  double distance = Infinity;
  Id face = NoId;
  Id corner = NoId;
  Arrival window;

  void takeIfShorter(const WayIntoFace& way, Id inFace)
  {
    if (way.kind == WayIntoFace::Kind::Source || way.isBehind || !(way.distance < this->distance))
    {
      return;
    }
    *this = { way.distance, inFace, way.vertex, {} };
    if (way.kind == WayIntoFace::Kind::Window)
    {
      const Window& w = *way.window;
      this->window = { way.halfedge, w.origin, way.x, w.direction(way.x),
        w.placeOf({ way.x, 0.0 }) };
    }
  }
};

WayToPoint shortestWayHere(const DistanceField& field, const TracedPath& path)
{
  WayToPoint shortest;
  const SurfacePoint& last = path.points.back();
  forEachFace(field.mesh(), last,
    [&](Id face)
    {
      if (face != path.without && field.surface().isOwn(face))
      {
        forEachWay(
          field, face, last, [&](const WayIntoFace& way) { shortest.takeIfShorter(way, face); });
      }
    });
  return shortest;
}

} // anonymous namespace

std::vector<SurfacePoint> PathTracer::trace(const SurfacePoint& from) const
{
  TracedPath path = this->begin(from);
  if (!path.points.empty())
  {
    this->follow(path);
  }
  return std::move(path.points);
}

TracedPath PathTracer::begin(const SurfacePoint& from) const
{
  TracedPath path;
  const SurfacePoint point = normalized(this->mesh_, from);
  path.whole = this->field_.distance(point);
  path.left = path.whole;
  if (path.whole < Infinity)
  {
    path.points = { point };
    path.faces = { someFace(this->mesh_, point) };
  }
  return path;
}

Id PathTracer::follow(TracedPath& path) const
{
  while (!path.isWhole())
  {
    const Id elsewhere = this->placeToGoOn(path);
    if (elsewhere != NoId)
    {
      return elsewhere;
    }
    switch (path.next)
    {
      case TracedPath::Next::Point:
        if (path.points.back().kind == SurfacePoint::Kind::Vertex)
        {
          this->goOnFromVertex(path.points.back().id, path);
        }
        else
        {
          path.without = NoId;
          this->search(path);
        }
        break;
      case TracedPath::Next::BehindExit:
        path.leg = this->legBeyond(path.leg, this->mesh_.nextSibling(path.leg.exit));
        this->followLeg(path);
        break;
      case TracedPath::Next::Search:
      {
        bool isAllHere = true;
        forEachFace(this->mesh_, path.points.back(),
          [&](Id face) { isAllHere = isAllHere && this->field_.surface().isOwn(face); });
        if (!isAllHere)
        {
          return NoId;
        }
        this->goOnHere(path);
        break;
      }
      case TracedPath::Next::End:
        break;
    }
  }
  this->requireLength(path);
  return NoId;
}

// The face of another rank where the path continues; NoId if it continues here.
Id PathTracer::placeToGoOn(const TracedPath& path) const
{
  const MeshPartition& surface = this->field_.surface();
  if (path.next == TracedPath::Next::BehindExit)
  {
    const Id face = TriangleMesh::faceOf(this->mesh_.nextSibling(path.leg.exit));
    return surface.isOwn(face) ? NoId : face;
  }
  const SurfacePoint& last = path.points.back();
  if (path.next != TracedPath::Next::Point || last.kind != SurfacePoint::Kind::Vertex)
  {
    return NoId;
  }
  if (last.id >= surface.numberOfOwnVertices())
  {
    return TriangleMesh::faceOf(*this->mesh_.cornersAt(last.id).begin());
  }
  const Id halfedge = this->field_.arrivals()[last.id].halfedge;
  return halfedge == NoId || surface.isOwn(TriangleMesh::faceOf(halfedge))
    ? NoId
    : TriangleMesh::faceOf(halfedge);
}

// If rounding leads a ray past a vertex on the wrong side, or to a place beside the end, the ray is
// longer than the path.
void PathTracer::requireLength(const TracedPath& path) const
{
  if (!(path.length <= (1.0 + tolerance::TracedLength) * path.whole))
  {
    throw PathLost("A shortest path could not be followed: it has become too long.");
  }
}

// Each step adds a point. As a piece may be shorter than rounding, the length left need not shrink
// at each step; but a shortest path visits no vertex twice and crosses no face twice.
void PathTracer::add(TracedPath& path, Id face, const SurfacePoint& point) const
{
  const MeshPartition& surface = this->field_.surface();
  const std::uint64_t faces = surface.numberOfGlobalFaces();
  if (path.steps++ > faces + surface.numberOfGlobalVertices())
  {
    throw PathLost("A shortest path could not be followed to the source.");
  }
  path.length += distanceInSpace(this->mesh_, path.points.back(), point);
  path.points.push_back(point);
  path.faces.push_back(face);
}

void PathTracer::goOnFromVertex(Id vertex, TracedPath& path) const
{
  if (!(this->field_.vertexDistances()[vertex] > 0.0))
  {
    path.next = TracedPath::Next::End;
    return;
  }
  for (const Id corner : this->mesh_.cornersAt(vertex))
  {
    if (this->endInFace(TriangleMesh::faceOf(corner), path))
    {
      return;
    }
  }
  const Arrival& arrival = this->field_.arrivals()[vertex];
  if (arrival.halfedge == NoId)
  {
    this->goToNeighbour(vertex, path);
    return;
  }
  const Id corner = TriangleMesh::previousInFace(arrival.halfedge);
  this->startLeg(
    inHalfedgeFrame(this->mesh_, arrival.halfedge, cornerWeights(corner % 3)), arrival, path);
}

// First looks for an end in the faces around the last point; only then are windows asked.
void PathTracer::search(TracedPath& path) const
{
  path.next = TracedPath::Next::Search;
  const SurfacePoint point = path.points.back();
  forEachFace(this->mesh_, point,
    [&](Id face)
    {
      if (face != path.without && !path.isWhole())
      {
        this->endInFace(face, path);
      }
    });
}

double PathTracer::searchHere(const TracedPath& path) const
{
  return shortestWayHere(this->field_, path).distance;
}

void PathTracer::goOnHere(TracedPath& path) const
{
  const WayToPoint way = shortestWayHere(this->field_, path);
  if (way.face == NoId)
  {
    throw PathLost(
      "A shortest path was to be followed through a face whose windows are not known.");
  }
  if (way.corner != NoId)
  {
    this->goToVertex(way.corner, way.face, path);
    return;
  }
  const Barycentric weights = barycentric(this->mesh_, path.points.back(), way.face);
  this->startLeg(inHalfedgeFrame(this->mesh_, way.window.halfedge, weights), way.window, path);
}

// From a point of a face, in the frame of the halfedge that the path came through, back to that
// halfedge.
void PathTracer::startLeg(Vec2 from, const Arrival& arrival, TracedPath& path) const
{
  PathLeg& leg = path.leg;
  leg = {};
  leg.frame = arrival.halfedge;
  leg.from = from;
  leg.to = { arrival.x, 0.0 };
  leg.exit = arrival.halfedge;
  leg.origin = arrival.origin;
  const double length = norm(arrival.direction);
  leg.ray.kind = Window::Kind::Linear;
  leg.ray.begin = this->mesh_.length(arrival.halfedge) - arrival.x;
  leg.ray.end = leg.ray.begin;
  // The leg runs against the direction of arrival, in a frame that is rotated by pi.
  leg.ray.sourceX = arrival.direction.x / length;
  leg.ray.sourceDepth = arrival.direction.y / length;
  path.stepsBesideEnd = 0;
  this->followLeg(path);
}

// Follows the leg to a vertex, to an edge of three and more faces, to the end or into the next
// face.
void PathTracer::followLeg(TracedPath& path) const
{
  constexpr int LegsBesideEnd = 3; // as many faces as may lie between the path and its end
  const PathLeg& leg = path.leg;
  const Id face = TriangleMesh::faceOf(leg.exit);
  const Id corner = this->cornerOn(leg, path);
  if (corner != NoId)
  {
    this->goToVertex(corner, face, path);
    return;
  }
  const double fraction = 1.0 - leg.ray.begin / this->mesh_.length(leg.exit);
  this->add(path, face, placeOnHalfedge(this->mesh_, leg.exit, fraction));
  path.left = std::max(0.0, path.left - norm(leg.to - leg.from));
  if (this->endInFace(face, path))
  {
    return;
  }
  const Id sibling = this->mesh_.nextSibling(leg.exit);
  if (sibling == leg.exit)
  {
    throw PathLost("A shortest path could not be followed: it leaves the surface.");
  }
  if (!(path.left > 0.0) && ++path.stepsBesideEnd > LegsBesideEnd)
  {
    throw PathLost("A shortest path could not be followed: it passes its end.");
  }
  if (!this->mesh_.isInner(leg.exit))
  {
    path.without = face;
    this->search(path);
    return;
  }
  if (!this->endInFace(TriangleMesh::faceOf(sibling), path))
  {
    path.next = TracedPath::Next::BehindExit;
  }
}

// The unfolding of windows (paper, section 3.2), for one ray.
PathLeg PathTracer::legBeyond(const PathLeg& leg, Id sibling) const
{
  const bool isOpposed = this->mesh_.origin(sibling) == this->mesh_.destination(leg.exit);
  const Window ray = isOpposed ? leg.ray : reversed(leg.ray, this->mesh_.length(leg.exit));
  const UnfoldedFace face = unfold(this->mesh_, sibling);
  PathLeg next;
  next.frame = sibling;
  next.from = { ray.begin, 0.0 };
  next.origin = leg.origin;
  if (ray.passesRightOf(ray.begin, face.apex))
  {
    const double x = face.meetRight(ray, ray.begin);
    next.exit = TriangleMesh::nextInFace(sibling);
    next.to = face.apex + x * face.rightAxis;
    next.ray = face.throughRight(ray, x, x);
  }
  else
  {
    const double x = face.meetLeft(ray, ray.begin);
    next.exit = TriangleMesh::previousInFace(sibling);
    next.to = x * face.leftAxis;
    next.ray = face.throughLeft(ray, x, x);
  }
  return next;
}

// The nearest corner that the path goes through: the one that it comes straight from, or a corner
// that is on the leg but for the rounding of an unfolding through many faces, and no farther from
// the source than the length left. NoId if there is none.
Id PathTracer::cornerOn(const PathLeg& leg, const TracedPath& path) const
{
  const Id face = TriangleMesh::faceOf(leg.frame);
  const Vec2 along = leg.to - leg.from;
  const double way = norm(along);
  const SurfacePoint& last = path.points.back();
  const std::array<double, 3>& lengths = this->mesh_.shape(face).length;
  const double reach = std::min(tolerance::PathAtVertex * path.whole,
    tolerance::SnapFraction * *std::min_element(lengths.begin(), lengths.end()));
  double nearest = Infinity;
  Id found = NoId;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id vertex = this->mesh_.triangle(face)[k];
    if (last.kind == SurfacePoint::Kind::Vertex && last.id == vertex)
    {
      continue;
    }
    const Vec2 toCorner = inHalfedgeFrame(this->mesh_, leg.frame, cornerWeights(k)) - leg.from;
    const double length = norm(toCorner);
    const double distance = this->field_.vertexDistances()[vertex];
    const bool isOnLeg =
      dot(toCorner, along) >= 0.0 && std::abs(cross(toCorner, along)) <= reach * way;
    const bool isOnPath =
      (distance == 0.0 || isOnLeg) && distance + length <= path.left + this->slack(face, path);
    if ((this->field_.surface().globalId(vertex) == leg.origin || isOnPath) && length < nearest)
    {
      nearest = length;
      found = vertex;
    }
  }
  return found;
}

// The possible error of lengths in a face: the path carries the rounding of its unfolding, places
// in the face carry that of their coordinates. If no length is left, the path may be at a place
// beside its end, as the length depends on that distance only by its square.
double PathTracer::slack(Id face, const TracedPath& path) const
{
  const double ofPath = path.left > 0.0 ? tolerance::Tie : tolerance::BesideEnd;
  return ofPath * path.whole + tolerance::PlaceRounding * this->mesh_.shape(face).longest();
}

// Ends the path on a source in the face that is no farther than the length left. Returns whether
// the path has ended.
bool PathTracer::endInFace(Id face, TracedPath& path) const
{
  double nearest = path.left + this->slack(face, path);
  Barycentric end{};
  for (const SourceInFace& source : this->field_.sourcesIn(face))
  {
    const Barycentric from = barycentric(this->mesh_, path.points.back(), face);
    const Barycentric point = nearestOnSource(this->mesh_, source, from);
    const double length = distanceInFace(this->mesh_, face, point, from);
    if (length <= nearest)
    {
      nearest = length;
      end = point;
      path.next = TracedPath::Next::End;
    }
  }
  if (path.isWhole())
  {
    this->add(path, face, fromBarycentric(this->mesh_, face, end));
    path.left = 0.0;
  }
  return path.isWhole();
}

void PathTracer::goToVertex(Id vertex, Id face, TracedPath& path) const
{
  this->add(path, face, SurfacePoint::atVertex(vertex));
  path.next = TracedPath::Next::Point;
  path.left = this->field_.vertexDistances()[vertex];
}

// Goes along an edge, to the vertex that gives the shortest way to the source.
void PathTracer::goToNeighbour(Id vertex, TracedPath& path) const
{
  const Id face = TriangleMesh::faceOf(*this->mesh_.cornersAt(vertex).begin());
  double nearest = path.left + this->slack(face, path);
  Id found = NoId;
  Id faceOfFound = NoId;
  const auto look = [&](Id halfedge, Id other)
  {
    const double distance = this->field_.vertexDistances()[other] + this->mesh_.length(halfedge);
    if (distance <= nearest)
    {
      nearest = distance;
      found = other;
      faceOfFound = TriangleMesh::faceOf(halfedge);
    }
  };
  for (const Id corner : this->mesh_.cornersAt(vertex))
  {
    const Id before = TriangleMesh::previousInFace(corner);
    look(corner, this->mesh_.destination(corner));
    look(before, this->mesh_.origin(before));
  }
  if (found == NoId)
  {
    throw PathLost("A shortest path could not be followed beyond a vertex.");
  }
  this->goToVertex(found, faceOfFound, path);
}

}
