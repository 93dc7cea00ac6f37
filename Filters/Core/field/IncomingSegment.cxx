// SPDX-License-Identifier: BSD-3-Clause
#include "field/IncomingSegment.h"

#include "Errors.h"
#include "Tolerance.h"
#include "front/Arrival.h"

#include <algorithm>

namespace geodesic
{

namespace
{

using Kind = WayIntoFace::Kind;

bool isZero(Vec2 v)
{
  return v.x == 0.0 && v.y == 0.0; // squares of tiny numbers are zero, too
}

/// The way from x on a halfedge to a point p of its face, of a path that crosses the halfedge along
/// a ray.
struct WayFrom
{
  /// Whether the path bends at x, as at a corner where a window ends, or begins there.
  bool isBent = false;
  /// The direction in which the path comes to p: that of the ray, unless the path bends or the ray
  /// is far shorter than the way from x to p.
  Vec2 direction = {};
  /// The ray's own direction, better known if the ray is as short.
  Vec2 ray = {};
};

/// \param longest edge of the face.
WayFrom wayFrom(double x, Vec2 p, Vec2 ray, double longest)
{
  const Vec2 d = p - Vec2{ x, 0.0 };
  const bool isBent = bends(ray, d, longest);
  const bool isShort = norm(ray) < tolerance::NearEdge * norm(d);
  return { isBent, isBent || isShort ? d : ray, !isBent && isShort ? d : ray };
}

/// The end of the arrival's halfedge at which the path crosses it, but for rounding; NoId if it
/// crosses between the ends. The smaller the angle between rays and halfedge, the larger is the
/// rounding of the place where a window ends.
Id cornerCrossed(const TriangleMesh& mesh, const Arrival& arrival)
{
  const double angle = arrival.direction.y / norm(arrival.direction);
  const double rounding = tolerance::PlaceRounding / std::max(angle, tolerance::NearEdge) *
    mesh.shape(TriangleMesh::faceOf(arrival.halfedge)).longest();
  return arrival.x <= rounding                              ? mesh.origin(arrival.halfedge)
    : arrival.x >= mesh.length(arrival.halfedge) - rounding ? mesh.destination(arrival.halfedge)
                                                            : NoId;
}

/// Looks for the shortest way to one point.
class LastPieceSearch
{
public:
  LastPieceSearch(const DistanceField& field, const SurfacePoint& point)
    : field_(field)
    , mesh_(field.mesh())
    , point_(point)
  {
  }

  /// Looks at the ways to the point through a face.
  ///
  /// \param only one kind of ways; None: all.
  /// \param withBehind also through windows of an edge with the point: their paths come through the
  ///        face behind the edge.
  void look(Id face, Kind only = Kind::None, bool withBehind = true)
  {
    this->enter(face);
    forEachWay(this->field_, face, this->point_,
      [&](const WayIntoFace& way)
      {
        if ((only == Kind::None || way.kind == only) && (withBehind || !way.isBehind))
        {
          way.kind == Kind::Window ? this->takeWindow(way) : this->takeStart(way);
        }
      });
  }

  /// Takes the piece that the vertex remembers.
  void fromArrival()
  {
    const Arrival& arrival = this->field_.arrivals()[this->point_.id];
    this->enter(TriangleMesh::faceOf(arrival.halfedge));
    this->best_.distance = this->field_.vertexDistances()[this->point_.id];
    if (!arrival.isThroughWindow())
    {
      const Triangle& corners = this->mesh_.triangle(this->face_);
      const auto corner = std::find_if(corners.begin(), corners.end() - 1,
        [&](Id c) { return this->originAt(c) == arrival.origin; });
      this->best_.kind = Kind::Corner;
      this->best_.ray =
        this->rayFrom(cornerWeights(static_cast<std::size_t>(corner - corners.begin())));
      this->best_.start = arrival.start;
      this->setCorner(*corner);
      return;
    }
    const WayFrom way =
      wayFrom(arrival.x, apexOf(this->mesh_, arrival.halfedge), arrival.direction, this->faceSize_);
    this->best_.kind = Kind::Window;
    this->best_.ray = { arrival.halfedge, way.direction };
    this->best_.origin = arrival.origin;
    this->best_.start = arrival.start;
    this->best_.rayOfWindow = way.ray;
    this->best_.x = arrival.x;
    this->best_.atX = arrival.direction;
    const Id corner = cornerCrossed(this->mesh_, arrival);
    if (way.isBent && corner != NoId)
    {
      // The way along the edge is as long, but the window's origin lies on one side of the edge.
      this->best_.kind = Kind::Corner;
      this->setCorner(corner);
    }
  }

  const IncomingSegment& best() const { return this->best_; }

private:
  /// Goes to a face around the point.
  void enter(Id face)
  {
    this->face_ = face;
    this->inFace_ = barycentric(this->mesh_, this->point_, face);
    this->faceSize_ = this->mesh_.shape(face).longest();
  }

  /// A piece from a source or from a corner.
  void takeStart(const WayIntoFace& way)
  {
    if (!this->improve(way, way.length))
    {
      return;
    }
    this->best_.ray = this->rayFrom(way.begin);
    if (way.kind == Kind::Corner)
    {
      this->setCorner(way.vertex);
      return;
    }
    this->best_.source = *way.source;
    this->best_.along = nearestAlongSource(this->mesh_, *way.source, this->inFace_);
  }

  void takeWindow(const WayIntoFace& way)
  {
    const Window& w = *way.window;
    const Vec2 p = inHalfedgeFrame(this->mesh_, way.halfedge, this->inFace_);
    const WayFrom from = wayFrom(way.x, p, w.directionTo(p, way.x), this->faceSize_);
    // At an edge of three and more faces the path may have come through any of the others.
    const bool isUnsure = way.isBehind && !this->mesh_.isInner(way.halfedge);
    const double straight = w.isLinear() ? way.distance : way.distance - w.sigma;
    if (this->improve(way, isUnsure || from.isBent ? 0.0 : straight))
    {
      const FaceDirection ray = { way.halfedge, from.direction };
      this->best_.ray =
        way.isBehind ? acrossEdge(this->mesh_, ray, this->mesh_.nextSibling(way.halfedge)) : ray;
      this->best_.origin = w.origin;
      this->best_.start = w.startOf({ way.x, 0.0 });
      this->best_.rayOfWindow = from.ray;
      this->best_.x = way.x;
      this->best_.atX = w.direction(way.x);
    }
  }

  /// Makes a way the best one if it is better.
  ///
  /// \param straight the length of its straight end.
  bool improve(const WayIntoFace& way, double straight)
  {
    const bool isKnown = way.distance < Infinity; // not a corner that a corridor has left out
    if (!isKnown || !this->isBetter(way, straight))
    {
      return false;
    }
    const double distance = std::min(way.distance, this->best_.distance);
    this->best_ = IncomingSegment();
    this->best_.kind = way.kind;
    this->best_.distance = distance;
    this->straight_ = straight;
    return true;
  }

  /// Whether a way is better than the best one: shorter or, where rounding hides which one is
  /// shorter, the one that gives the better direction.
  bool isBetter(const WayIntoFace& way, double straight) const
  {
    const double best = this->best_.distance;
    const double size = way.distance + this->faceSize_;
    const double difference = std::abs(way.distance - best);
    const bool isFromCorner = way.kind == Kind::Corner;

    // A long straight end gives the best direction.
    const bool isOneStraighter = std::abs(straight - this->straight_) > tolerance::Tie * size;
    if (isOneStraighter && difference <= tolerance::Tie * size)
    {
      return straight > this->straight_;
    }
    // A corner as near as rounding gives no direction. Nor does a corner that is so near to the
    // source: the way past the corner is shorter, unless rounding hides that.
    if (isFromCorner != (this->best_.kind == Kind::Corner))
    {
      const double rounding = tolerance::PlaceRounding * size;
      return way.distance < best + (isFromCorner ? -rounding : rounding);
    }
    // Rounding alone tells which of the two is shorter.
    if (difference <= tolerance::SameLength * size)
    {
      return straight > this->straight_;
    }
    return way.distance < best;
  }

  void setCorner(Id corner)
  {
    this->best_.corner = corner;
    this->best_.origin = this->originAt(corner);
  }
  RayOrigin originAt(Id vertex) const
  {
    return RayOrigin::vertex(this->field_.surface().globalId(vertex));
  }

  FaceDirection rayFrom(const Barycentric& begin) const
  {
    const Id frame = longestHalfedge(this->mesh_, this->face_);
    return { frame, wayInFrame(this->mesh_, frame, begin, this->inFace_) };
  }

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  const SurfacePoint& point_;
  IncomingSegment best_;
  /// The length of its straight end.
  double straight_ = 0.0;
  /// The current face, and in it the point and the longest edge.
  Id face_ = NoId;
  Barycentric inFace_ = {};
  double faceSize_ = 0.0;
};

void findAtVertex(const DistanceField& field, const SurfacePoint& point, LastPieceSearch& search)
{
  if (!(field.vertexDistances()[point.id] < Infinity))
  {
    return;
  }
  if (field.arrivals()[point.id].halfedge != NoId)
  {
    search.fromArrival();
    return;
  }
  // The path comes straight from a source in a face, or from a corner so near that rounding has
  // hidden the arrival. Once a source is found, corners as near as rounding must not be taken:
  // their own paths may come from this vertex.
  forEachFace(field.mesh(), point, [&](Id face) { search.look(face, Kind::Source); });
  if (field.arrivals()[point.id].isKnown() && search.best().kind == Kind::Source)
  {
    return;
  }
  forEachFace(field.mesh(), point, [&](Id face) { search.look(face, Kind::Corner); });
}

} // anonymous namespace

IncomingSegment incomingSegmentTo(const DistanceField& field, const SurfacePoint& point)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return incomingSegmentThrough(field, point);
  }
  LastPieceSearch search(field, point);
  bool isKnown = false;
  forEachFace(field.mesh(), point,
    [&](Id face)
    {
      if (field.knowsInside(face))
      {
        isKnown = true;
        search.look(face);
      }
    });
  if (!isKnown && !field.hasWindows())
  {
    throw Error("The path to a point was asked for, but the solve kept no windows there.");
  }
  const IncomingSegment& piece = search.best();
  const bool isAtCorner = piece.kind == Kind::Corner && isZero(piece.ray.vector);
  return isAtCorner ? incomingSegmentThrough(field, SurfacePoint::atVertex(piece.corner)) : piece;
}

IncomingSegment incomingSegmentThrough(const DistanceField& field, const SurfacePoint& point)
{
  LastPieceSearch search(field, point);
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    if (field.arrivals().empty())
    {
      throw Error("The path to a vertex was asked for, but the solve did not keep arrivals.");
    }
    findAtVertex(field, point, search);
    return search.best();
  }
  forEachFace(field.mesh(), point,
    [&](Id face)
    {
      if (field.surface().isOwn(face) && field.knowsInside(face))
      {
        search.look(face, Kind::None, false);
      }
    });
  return search.best();
}

Vec3 gradientOf(const TriangleMesh& mesh, const IncomingSegment& piece)
{
  return piece.kind != Kind::None && piece.distance > 0.0
    ? inSpace(mesh, piece.ray.halfedge, piece.ray.vector)
    : Vec3{};
}

}
