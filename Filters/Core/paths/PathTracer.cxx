// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathTracer.h"

#include "Tolerance.h"
#include "field/WaysIntoFace.h"
#include "window/UnfoldedFace.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// A way from a corner or through a window to a point, and its face.
struct WayInFace : WayIntoFace
{
  Id face = NoId;
};

/// The shortest way to the last point of a path, through this rank's faces except the one that the
/// search leaves out.
WayInFace shortestWayHere(const DistanceField& field, const TracedPath& path)
{
  WayInFace shortest;
  const SurfacePoint& last = path.points.back();
  forEachFace(field.mesh(), last,
    [&](Id face)
    {
      if (face != path.without && field.surface().isOwn(face))
      {
        forEachWay(field, face, last,
          [&](const WayIntoFace& way)
          {
            if (way.kind != WayIntoFace::Kind::Source && !way.isBehind &&
              way.distance < shortest.distance)
            {
              shortest = { way, face };
            }
          });
      }
    });
  return shortest;
}

/// Follows one path.
class PathTracer
{
public:
  PathTracer(const DistanceField& field, TracedPath& path)
    : field_(field)
    , mesh_(field.mesh())
    , surface_(field.surface())
    , path_(path)
  {
  }

  Id follow()
  {
    // As a piece may be shorter than rounding, the length left need not shrink at each step; but a
    // shortest path visits no vertex twice and crosses no face twice.
    const std::uint64_t mostSteps = std::uint64_t{ this->surface_.numberOfGlobalFaces() } +
      this->surface_.numberOfGlobalVertices();
    while (this->path_.isOnItsWay())
    {
      const Id elsewhere = this->placeToGoOn();
      if (elsewhere != NoId)
      {
        return elsewhere;
      }
      if (this->path_.steps > mostSteps)
      {
        this->path_.next = Next::Lost;
      }
      else if (this->path_.next == Next::BehindExit)
      {
        this->goBehindExit();
      }
      else if (this->path_.next == Next::Search)
      {
        bool isAllHere = true;
        forEachFace(this->mesh_, this->path_.points.back(),
          [&](Id face) { isAllHere = isAllHere && this->surface_.isOwn(face); });
        if (!isAllHere)
        {
          return NoId;
        }
        this->goOnThroughHere();
      }
      else if (this->path_.points.back().kind == SurfacePoint::Kind::Vertex)
      {
        this->goOnFromVertex(this->path_.points.back().id);
      }
      else
      {
        this->search(NoId);
      }
    }
    // If rounding leads a ray past a vertex on the wrong side, or to a place beside the end, the
    // ray is longer than the path.
    if (!(this->path_.length <= (1.0 + tolerance::TracedLength) * this->path_.whole))
    {
      this->path_.next = Next::Lost;
    }
    return NoId;
  }

  void goOnThroughHere()
  {
    const WayInFace way = shortestWayHere(this->field_, this->path_);
    if (way.kind == WayIntoFace::Kind::Corner)
    {
      this->goToVertex(way.vertex, way.face);
    }
    else if (way.kind == WayIntoFace::Kind::Window)
    {
      const Window& w = *way.window;
      this->startLeg(way.halfedge, way.x, w.direction(way.x), w.origin);
    }
    else
    {
      this->path_.next = Next::Lost; // the windows that it comes through were not kept
    }
  }

private:
  using Next = PathState::Next;

  // The face of another rank where the path continues; NoId if it continues here.
  Id placeToGoOn() const
  {
    if (this->path_.next == Next::BehindExit)
    {
      const Id face = TriangleMesh::faceOf(this->mesh_.nextSibling(this->path_.exit));
      return this->surface_.isOwn(face) ? NoId : face;
    }
    const SurfacePoint& last = this->path_.points.back();
    if (this->path_.next != Next::Point || last.kind != SurfacePoint::Kind::Vertex)
    {
      return NoId;
    }
    if (last.id >= this->surface_.numberOfOwnVertices())
    {
      return TriangleMesh::faceOf(*this->mesh_.cornersAt(last.id).begin());
    }
    const Id halfedge = this->field_.arrivals()[last.id].halfedge;
    return halfedge == NoId || this->surface_.isOwn(TriangleMesh::faceOf(halfedge))
      ? NoId
      : TriangleMesh::faceOf(halfedge);
  }

  void add(Id face, const SurfacePoint& point)
  {
    ++this->path_.steps;
    this->path_.length += distanceInSpace(this->mesh_, this->path_.points.back(), point);
    this->path_.points.push_back(point);
    this->path_.faces.push_back(face);
  }

  void goOnFromVertex(Id vertex)
  {
    if (!(this->field_.vertexDistances()[vertex] > 0.0))
    {
      this->path_.next = Next::End;
      return;
    }
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      if (this->endInFace(TriangleMesh::faceOf(corner)))
      {
        return;
      }
    }
    const Arrival& arrival = this->field_.arrivals()[vertex];
    if (arrival.halfedge == NoId)
    {
      this->goToNeighbour(vertex);
      return;
    }
    this->startLeg(arrival.halfedge, arrival.x, arrival.direction, arrival.origin);
  }

  // First looks for an end in the faces around the last point; only then are windows asked.
  void search(Id without)
  {
    this->path_.without = without;
    this->path_.next = Next::Search;
    const SurfacePoint point = this->path_.points.back();
    forEachFace(this->mesh_, point,
      [&](Id face)
      {
        if (face != without && this->path_.next == Next::Search)
        {
          this->endInFace(face);
        }
      });
  }

  // From the last point back to the place where the path came through a halfedge of a face with
  // that point.
  void startLeg(Id halfedge, double x, Vec2 direction, Id origin)
  {
    const double length = norm(direction);
    Window& ray = this->path_.ray;
    ray = {};
    ray.kind = Window::Kind::Linear;
    ray.begin = this->mesh_.length(halfedge) - x;
    ray.end = ray.begin;
    // The leg runs against the direction of arrival, in a frame that is rotated by pi.
    ray.sourceX = direction.x / length;
    ray.sourceDepth = direction.y / length;
    this->path_.exit = halfedge;
    this->path_.origin = origin;
    this->path_.stepsBesideEnd = 0;
    const Barycentric from =
      barycentric(this->mesh_, this->path_.points.back(), TriangleMesh::faceOf(halfedge));
    this->followLeg(halfedge, inHalfedgeFrame(this->mesh_, halfedge, from), { x, 0.0 });
  }

  // The unfolding of windows (paper, section 3.2), for one ray.
  void goBehindExit()
  {
    const Id sibling = this->mesh_.nextSibling(this->path_.exit);
    const bool isOpposed = this->mesh_.origin(sibling) == this->mesh_.destination(this->path_.exit);
    const Window ray =
      isOpposed ? this->path_.ray : reversed(this->path_.ray, this->mesh_.length(this->path_.exit));
    const UnfoldedFace face = unfold(this->mesh_, sibling);
    Vec2 to;
    if (ray.passesRightOf(ray.begin, face.apex))
    {
      const double x = face.meetRight(ray, ray.begin);
      to = face.apex + x * face.rightAxis;
      this->path_.exit = TriangleMesh::nextInFace(sibling);
      this->path_.ray = face.throughRight(ray, x, x);
    }
    else
    {
      const double x = face.meetLeft(ray, ray.begin);
      to = x * face.leftAxis;
      this->path_.exit = TriangleMesh::previousInFace(sibling);
      this->path_.ray = face.throughLeft(ray, x, x);
    }
    this->followLeg(sibling, { ray.begin, 0.0 }, to);
  }

  // Follows a straight piece of the path, across the face up to the exit: to a vertex, to an edge
  // of three and more faces, to the end or into the next face.
  void followLeg(Id frame, Vec2 from, Vec2 to)
  {
    constexpr int LegsBesideEnd = 3; // as many faces as may lie between the path and its end
    const Id exit = this->path_.exit;
    const Id face = TriangleMesh::faceOf(exit);
    const Id corner = this->cornerOn(frame, from, to);
    if (corner != NoId)
    {
      this->goToVertex(corner, face);
      return;
    }
    const double fraction = 1.0 - this->path_.ray.begin / this->mesh_.length(exit);
    this->add(face, placeOnHalfedge(this->mesh_, exit, fraction));
    this->path_.left = std::max(0.0, this->path_.left - norm(to - from));
    if (this->endInFace(face))
    {
      return;
    }
    const Id sibling = this->mesh_.nextSibling(exit);
    const bool leavesSurface = sibling == exit;
    if (leavesSurface ||
      (!(this->path_.left > 0.0) && ++this->path_.stepsBesideEnd > LegsBesideEnd))
    {
      this->path_.next = Next::Lost;
    }
    else if (!this->mesh_.isInner(exit))
    {
      this->search(face);
    }
    else if (!this->endInFace(TriangleMesh::faceOf(sibling)))
    {
      this->path_.next = Next::BehindExit;
    }
  }

  // The nearest corner that the path goes through: the one that it comes straight from, or a corner
  // that is on the leg but for the rounding of an unfolding through many faces, and no farther from
  // the source than the length left. NoId if there is none.
  Id cornerOn(Id frame, Vec2 from, Vec2 to) const
  {
    const Id face = TriangleMesh::faceOf(frame);
    const Vec2 along = to - from;
    const double way = norm(along);
    const SurfacePoint& last = this->path_.points.back();
    const std::array<double, 3>& lengths = this->mesh_.shape(face).length;
    const double reach = std::min(tolerance::PathAtVertex * this->path_.whole,
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
      const Vec2 toCorner = inHalfedgeFrame(this->mesh_, frame, cornerWeights(k)) - from;
      const double length = norm(toCorner);
      const double distance = this->field_.vertexDistances()[vertex];
      const bool isOnLeg =
        dot(toCorner, along) >= 0.0 && std::abs(cross(toCorner, along)) <= reach * way;
      const bool isOnPath =
        (distance == 0.0 || isOnLeg) && distance + length <= this->longestLeft(face);
      if ((this->surface_.globalId(vertex) == this->path_.origin || isOnPath) && length < nearest)
      {
        nearest = length;
        found = vertex;
      }
    }
    return found;
  }

  // The length left with the possible error of lengths in a face: the path carries the rounding of
  // its unfolding, places in the face carry that of their coordinates. If no length is left, the
  // path may be at a place beside its end, as the length depends on that distance only by its
  // square.
  double longestLeft(Id face) const
  {
    const double ofPath = this->path_.left > 0.0 ? tolerance::Tie : tolerance::BesideEnd;
    return this->path_.left +
      (ofPath * this->path_.whole + tolerance::PlaceRounding * this->mesh_.shape(face).longest());
  }

  // Ends the path on a source in the face that is no farther than the length left. Returns whether
  // the path has ended.
  bool endInFace(Id face)
  {
    const std::vector<SourceInFace> sources = this->field_.sourcesIn(face);
    if (sources.empty())
    {
      return false;
    }
    const Barycentric from = barycentric(this->mesh_, this->path_.points.back(), face);
    double nearest = this->longestLeft(face);
    Barycentric end{};
    for (const SourceInFace& source : sources)
    {
      const Barycentric point = nearestOnSource(this->mesh_, source, from);
      const double length = distanceInFace(this->mesh_, face, point, from);
      if (length <= nearest)
      {
        nearest = length;
        end = point;
        this->path_.next = Next::End;
      }
    }
    if (this->path_.next == Next::End)
    {
      this->add(face, fromBarycentric(this->mesh_, face, end));
      this->path_.left = 0.0;
    }
    return this->path_.next == Next::End;
  }

  void goToVertex(Id vertex, Id face)
  {
    this->add(face, SurfacePoint::atVertex(vertex));
    this->path_.next = Next::Point;
    this->path_.left = this->field_.vertexDistances()[vertex];
  }

  // Goes along an edge, to the vertex that gives the shortest way to the source.
  void goToNeighbour(Id vertex)
  {
    double nearest =
      this->longestLeft(TriangleMesh::faceOf(*this->mesh_.cornersAt(vertex).begin()));
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
      this->path_.next = Next::Lost;
      return;
    }
    this->goToVertex(found, faceOfFound);
  }

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  const MeshPartition& surface_;
  TracedPath& path_;
};

} // anonymous namespace

TracedPath beginPath(const DistanceField& field, const SurfacePoint& from)
{
  TracedPath path;
  const SurfacePoint point = normalized(field.mesh(), from);
  path.whole = field.distance(point);
  path.left = path.whole;
  if (!(path.whole < Infinity))
  {
    path.next = PathState::Next::End;
    return path;
  }
  path.points = { point };
  path.faces = { someFace(field.mesh(), point) };
  return path;
}

Id followPath(const DistanceField& field, TracedPath& path)
{
  return PathTracer(field, path).follow();
}

double lengthThroughHere(const DistanceField& field, const TracedPath& path)
{
  return shortestWayHere(field, path).distance;
}

void goOnThroughHere(const DistanceField& field, TracedPath& path)
{
  PathTracer(field, path).goOnThroughHere();
}

}
