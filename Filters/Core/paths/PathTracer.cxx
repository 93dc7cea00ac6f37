// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathTracer.h"

#include "Tolerance.h"
#include "window/UnfoldedFace.h"

#include <algorithm>
#include <optional>

namespace geodesic
{

namespace
{

/// Follows one path.
class PathTracer
{
public:
  const DistanceField& field;
  TracedPath& path;
  const TriangleMesh& mesh = field.mesh();
  const MeshPartition& surface = field.surface();

  void follow()
  {
    // As a piece may be shorter than rounding, the length left need not shrink at each step; but a
    // shortest path visits no vertex twice and crosses no face twice.
    const std::uint64_t mostSteps =
      std::uint64_t{ this->surface.numberOfGlobalFaces() } + this->surface.numberOfGlobalVertices();
    for (;;)
    {
      // If rounding leads a ray past a vertex on the wrong side, or to a place beside the end, the
      // ray is longer than the path.
      if (this->path.steps > mostSteps ||
        !(this->path.length <= (1.0 + tolerance::TracedLength) * this->path.whole))
      {
        this->path.next = Next::Lost;
      }
      if (!this->path.isOnItsWay())
      {
        return;
      }
      const Id face = this->nextFace();
      if (face != NoId && !this->surface.isOwn(face))
      {
        this->path.elsewhere = face;
        return;
      }
      if (this->path.next == Next::BehindExit)
      {
        this->goBehindExit();
      }
      else if (this->path.next == Next::Search)
      {
        bool isAllOwn = true;
        forEachFace(this->mesh, this->path.points.back(),
          [&](Id around) { isAllOwn = isAllOwn && this->surface.isOwn(around); });
        if (!isAllOwn)
        {
          return;
        }
        this->continueOnThisRank();
      }
      else
      {
        this->goOn();
      }
    }
  }

  /// Returns the length of the path from the last point.
  double continueOnThisRank()
  {
    const IncomingSegment piece = incomingSegmentThrough(this->field, this->path.points.back());
    this->path.piece = piece;
    if (piece.kind == IncomingSegment::Kind::Corner)
    {
      this->goToVertex(piece.corner, TriangleMesh::faceOf(piece.ray.halfedge));
    }
    else if (piece.kind == IncomingSegment::Kind::Window)
    {
      this->startLeg(piece.ray.halfedge, piece.x, piece.atX);
    }
    else
    {
      this->path.next = Next::Lost; // the windows that it comes through were not kept
    }
    return piece.distance;
  }

private:
  using Next = PathState::Next;

  // The face of any rank where the path continues; NoId if that is not known yet.
  Id nextFace() const
  {
    if (this->path.next == Next::BehindExit)
    {
      return TriangleMesh::faceOf(this->mesh.nextSibling(this->path.exit));
    }
    const SurfacePoint& last = this->path.points.back();
    if (this->path.next != Next::Point || last.kind != SurfacePoint::Kind::Vertex)
    {
      return NoId;
    }
    // Only ranks that own a face at the vertex know how its path arrives.
    const Id halfedge = last.id < this->surface.numberOfOwnVertices()
      ? this->field.arrivals()[last.id].halfedge
      : *this->mesh.cornersAt(last.id).begin();
    return halfedge == NoId ? NoId : TriangleMesh::faceOf(halfedge);
  }

  void add(Id face, const SurfacePoint& point)
  {
    ++this->path.steps;
    this->path.length += distanceInSpace(this->mesh, this->path.points.back(), point);
    this->path.points.push_back(point);
    this->path.faces.push_back(face);
  }

  // From a vertex or the first point.
  void goOn()
  {
    const SurfacePoint point = this->path.points.back();
    const bool isVertex = point.kind == SurfacePoint::Kind::Vertex;
    if (isVertex && !(this->field.vertexDistances()[point.id] > 0.0))
    {
      this->end();
      return;
    }
    this->search();
    if (isVertex && this->path.next == Next::Search)
    {
      this->continueOnThisRank(); // all ranks with the vertex know how the path arrives
    }
  }

  // First looks for an end in the faces around the last point.
  void search()
  {
    this->path.next = Next::Search;
    const SurfacePoint point = this->path.points.back();
    forEachFace(this->mesh, point,
      [&](Id face)
      {
        if (this->path.next == Next::Search)
        {
          this->endInFace(face);
        }
      });
  }

  // From the last point back to the place where the path came through a halfedge of a face with
  // that point.
  void startLeg(Id halfedge, double x, Vec2 direction)
  {
    const double length = norm(direction);
    Window& ray = this->path.ray;
    ray = {};
    ray.kind = Window::Kind::Linear;
    ray.begin = this->mesh.length(halfedge) - x;
    ray.end = ray.begin;
    // The leg runs against the direction of arrival, in a frame that is rotated by pi.
    ray.sourceX = direction.x / length;
    ray.sourceDepth = direction.y / length;
    this->path.exit = halfedge;
    const Barycentric from =
      barycentric(this->mesh, this->path.points.back(), TriangleMesh::faceOf(halfedge));
    this->followLeg(halfedge, inHalfedgeFrame(this->mesh, halfedge, from), { x, 0.0 });
  }

  // The unfolding of windows (paper, section 3.2), for one ray.
  void goBehindExit()
  {
    const Id sibling = this->mesh.nextSibling(this->path.exit);
    const bool isOpposed = this->mesh.origin(sibling) == this->mesh.destination(this->path.exit);
    const Window ray =
      isOpposed ? this->path.ray : reversed(this->path.ray, this->mesh.length(this->path.exit));
    const UnfoldedFace face = unfold(this->mesh, sibling);
    Vec2 to;
    if (ray.passesRightOf(ray.begin, face.apex))
    {
      const double x = face.meetRight(ray, ray.begin);
      to = face.apex + x * face.rightAxis;
      this->path.exit = TriangleMesh::nextInFace(sibling);
      this->path.ray = face.throughRight(ray, x, x);
    }
    else
    {
      const double x = face.meetLeft(ray, ray.begin);
      to = x * face.leftAxis;
      this->path.exit = TriangleMesh::previousInFace(sibling);
      this->path.ray = face.throughLeft(ray, x, x);
    }
    this->followLeg(sibling, { ray.begin, 0.0 }, to);
  }

  // Follows a straight piece of the path, across the face up to the exit: to a vertex, to an edge
  // of three and more faces, to the end or into the next face.
  void followLeg(Id frame, Vec2 from, Vec2 to)
  {
    const Id exit = this->path.exit;
    const Id face = TriangleMesh::faceOf(exit);
    const Id corner = this->cornerOn(frame, from, to);
    if (corner != NoId)
    {
      this->goToVertex(corner, face);
      return;
    }
    const double fraction = 1.0 - this->path.ray.begin / this->mesh.length(exit);
    this->add(face, placeOnHalfedge(this->mesh, exit, fraction));
    this->path.left = std::max(0.0, this->path.left - norm(to - from));
    if (this->endInFace(face))
    {
      return;
    }
    const Id sibling = this->mesh.nextSibling(exit);
    if (sibling == exit)
    {
      this->path.next = Next::Lost; // it leaves the surface
    }
    else if (!this->mesh.isInner(exit))
    {
      this->search();
    }
    else if (!this->endInFace(TriangleMesh::faceOf(sibling)))
    {
      this->path.next = Next::BehindExit;
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
    const SurfacePoint& last = this->path.points.back();
    const std::array<double, 3>& lengths = this->mesh.shape(face).length;
    const double snapDistance = std::min(tolerance::PathAtVertex * this->path.whole,
      tolerance::SnapFraction * *std::min_element(lengths.begin(), lengths.end()));
    double nearest = Infinity;
    Id found = NoId;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id vertex = this->mesh.triangle(face)[k];
      if (last.kind == SurfacePoint::Kind::Vertex && last.id == vertex)
      {
        continue;
      }
      const Vec2 toCorner = inHalfedgeFrame(this->mesh, frame, cornerWeights(k)) - from;
      const double length = norm(toCorner);
      const double distance = this->field.vertexDistances()[vertex];
      const bool isOnLeg =
        dot(toCorner, along) >= 0.0 && std::abs(cross(toCorner, along)) <= snapDistance * way;
      const bool isOnPath =
        (distance == 0.0 || isOnLeg) && distance + length <= this->longestLeft(face);
      const RayOrigin atCorner = RayOrigin::vertex(this->surface.globalId(vertex));
      if ((atCorner == this->path.piece.origin || isOnPath) && length < nearest)
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
    const double ofPath = this->path.left > 0.0 ? tolerance::Tie : tolerance::BesideEnd;
    return this->path.left +
      (ofPath * this->path.whole + tolerance::PlaceRounding * this->mesh.shape(face).longest());
  }

  // Ends the path on a source in the face that is no farther than the length left. Returns whether
  // the path has ended.
  bool endInFace(Id face)
  {
    const std::vector<SourceInFace> sources = this->field.sourcesIn(face);
    if (sources.empty())
    {
      return false;
    }
    const Barycentric from = barycentric(this->mesh, this->path.points.back(), face);
    double nearest = this->longestLeft(face);
    std::optional<Barycentric> end;
    for (const SourceInFace& source : sources)
    {
      const Barycentric point = nearestOnSource(this->mesh, source, from);
      const double length = distanceInFace(this->mesh, face, point, from);
      if (length <= nearest)
      {
        nearest = length;
        end = point;
      }
    }
    if (end)
    {
      this->add(face, fromBarycentric(this->mesh, face, *end));
      this->end();
    }
    return end.has_value();
  }

  void goToVertex(Id vertex, Id face)
  {
    this->add(face, SurfacePoint::atVertex(vertex));
    this->path.next = Next::Point;
    this->path.left = this->field.vertexDistances()[vertex];
    if (!(this->path.left > 0.0))
    {
      this->end();
    }
  }

  void end()
  {
    this->path.next = Next::End;
    this->path.left = 0.0;
  }
};

} // anonymous namespace

TracedPath beginPath(const DistanceField& field, const SurfacePoint& from)
{
  TracedPath path;
  const SurfacePoint point = normalized(field.mesh(), from);
  path.left = path.whole = field.distance(point);
  if (!(path.whole < Infinity))
  {
    path.next = PathState::Next::End;
    return path;
  }
  path.points = { point };
  path.faces = { someFace(field.mesh(), point) };
  return path;
}

void followPath(const DistanceField& field, TracedPath& path)
{
  PathTracer{ field, path }.follow();
}

double continueOnThisRank(const DistanceField& field, TracedPath& path)
{
  return PathTracer{ field, path }.continueOnThisRank();
}

}
