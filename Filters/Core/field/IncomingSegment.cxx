// SPDX-License-Identifier: BSD-3-Clause
#include "field/IncomingSegment.h"

#include "Errors.h"
#include "Tolerance.h"
#include "field/IncomingRay.h"
#include "field/WaysIntoFace.h"

#include <algorithm>

namespace geodesic
{

namespace
{

bool isZero(Vec2 v)
{
  return v.x == 0.0 && v.y == 0.0; // squares of tiny numbers are zero, too
}

/// A path to a point p of a face from x on a halfedge of it, where the ray through x has a
/// direction.
struct WayFrom
{
  /// Whether the path bends at x, as it does at a corner that a window ends at, or begins there.
  bool isBent;
  /// The direction in which it comes to the point: that of the ray, unless it bends or the ray is
  /// far shorter than the way from x to p.
  Vec2 direction;
};

/// \param longest edge of the face.
/// \param leastBend no path bends nearer to p than this.
WayFrom wayFrom(double x, Vec2 p, Vec2 ray, double longest, double leastBend)
{
  const Vec2 d = p - Vec2{ x, 0.0 };
  const double length = norm(ray);
  // Of the places on both: a ray from beside a corner is hardly longer than these.
  const double rounding = tolerance::PlaceRounding * longest;
  const double ofBoth = rounding * (length + norm(d));
  const bool isBent = norm(d) > leastBend &&
    (length <= rounding || std::abs(cross(ray, d)) > ofBoth || dot(ray, d) < -ofBoth);
  return { isBent, isBent || length < tolerance::NearEdge * norm(d) ? d : ray };
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

  /// Goes to a face around the point.
  void enter(Id face)
  {
    this->faceSize_ = this->mesh_.shape(face).longest();
    // The way across a face without area is rounding. A bend is at a corner there.
    this->leastBend_ = hasPlane(this->mesh_, face) ? 0.0 : tolerance::NearEdge * this->faceSize_;
  }

  void comeFromSources(Id face)
  {
    const Barycentric point = barycentric(this->mesh_, this->point_, face);
    forEachWayFromSource(this->field_, face, point,
      [&](const SourceInFace& source, const Barycentric& begin, double length)
      {
        if (this->improve(IncomingSegment::Kind::Source, length, length))
        {
          this->setDirection(face, begin, point);
          this->best_.source = source;
          this->best_.along = nearestAlongSource(this->mesh_, source, point);
        }
      });
  }

  void comeFromCorners(Id face)
  {
    const Barycentric point = barycentric(this->mesh_, this->point_, face);
    forEachWayFromCorner(this->field_, face, this->point_, point,
      [&](std::size_t k, double distance, double length)
      {
        if (this->improve(IncomingSegment::Kind::Corner, distance, length))
        {
          this->setDirection(face, cornerWeights(k), point);
          this->corner_ = this->mesh_.triangle(face)[k];
          this->best_.origin = this->field_.surface().globalId(this->corner_);
        }
      });
  }

  /// Windows of a halfedge that holds the point have come through the face behind it.
  void comeThroughWindows(Id face)
  {
    const Barycentric point = barycentric(this->mesh_, this->point_, face);
    for (Id k = 0; k < 3; ++k)
    {
      const Id halfedge = 3 * face + k;
      const bool isOnIt = isOnHalfedge(point, k);
      // Behind an edge of three and more faces the path may come through any of the others.
      const bool isUnsure = isOnIt && !this->mesh_.isInner(halfedge);
      const Vec2 p = inHalfedgeFrame(this->mesh_, halfedge, point);
      forEachWayThrough(this->field_, halfedge, p,
        [&](const Window& w, double x, double distance, double)
        {
          const WayFrom way = wayFrom(x, p, w.direction(x), this->faceSize_, this->leastBend_);
          const double straight = w.isLinear() ? distance : distance - w.sigma;
          if (this->improve(
                IncomingSegment::Kind::Window, distance, isUnsure || way.isBent ? 0.0 : straight))
          {
            const IncomingRay ray = { halfedge, false, x, way.direction };
            this->setRay(isOnIt ? acrossEdge(this->mesh_, ray) : ray);
            this->best_.origin = w.origin;
            this->best_.place = w.placeOf({ x, 0.0 });
            this->best_.rayOfWindow = way.isBent ? w.direction(x) : way.direction;
          }
        });
    }
  }

  /// As the vertex remembers it.
  void fromArrival()
  {
    const Arrival& arrival = this->field_.arrivals()[this->point_.id];
    const Id face = TriangleMesh::faceOf(arrival.halfedge);
    this->best_.distance = this->field_.vertexDistances()[this->point_.id];
    this->best_.origin = arrival.origin;
    this->best_.place = arrival.place;
    this->enter(face);
    if (arrival.isThroughWindow())
    {
      this->best_.kind = IncomingSegment::Kind::Window;
      const WayFrom way = wayFrom(arrival.x, apexOf(this->mesh_, arrival.halfedge),
        arrival.direction, this->faceSize_, this->leastBend_);
      this->setRay({ arrival.halfedge, false, arrival.x, way.direction });
      this->best_.rayOfWindow = way.isBent ? arrival.direction : way.direction;
      const Id corner = cornerCrossed(this->mesh_, arrival);
      if (way.isBent && corner != NoId)
      {
        // As long as along the edge, but what the window comes from lies on one side only.
        this->best_.kind = IncomingSegment::Kind::Corner;
        this->best_.origin = this->field_.surface().globalId(corner);
        this->corner_ = corner;
      }
      return;
    }
    const std::size_t k = this->cornerWithNumber(face, arrival.origin);
    this->best_.kind = IncomingSegment::Kind::Corner;
    this->corner_ = this->mesh_.triangle(face)[k];
    this->setDirection(face, cornerWeights(k), barycentric(this->mesh_, this->point_, face));
  }

  /// Only in the plane of a face that has an area a direction can be told.
  void leaveFacesWithoutArea()
  {
    if (this->best_.kind == IncomingSegment::Kind::Window)
    {
      this->setRay(backToDirectionInSpace(this->mesh_, this->best_.ray()));
    }
  }

  const IncomingSegment& best() const { return this->best_; }
  /// Of the best: whether it is a way without length from a corner, and that corner.
  bool isAtCorner() const
  {
    return this->best_.kind == IncomingSegment::Kind::Corner && isZero(this->best_.direction);
  }
  /// Whether it is one without length but for rounding, from a corner that has a direction itself.
  bool isBesideCorner() const
  {
    const double rounding = tolerance::PlaceRounding * (this->faceSize_ + this->best_.distance);
    return this->best_.kind == IncomingSegment::Kind::Corner &&
      norm(this->best_.direction) <= rounding &&
      this->field_.vertexDistances()[this->corner_] > 0.0 &&
      this->field_.arrivals()[this->corner_].isKnown();
  }
  Id corner() const { return this->corner_; }

private:
  // Of ways as long but for rounding the one that is straight the longest tells the direction best:
  // from a corner a rounding beside the point there is none.
  bool improve(IncomingSegment::Kind kind, double distance, double straight)
  {
    const double shortest = this->best_.distance;
    const bool isTie =
      std::abs(distance - shortest) <= tolerance::Tie * (distance + this->faceSize_);
    if (!(isTie ? straight > this->straight_ : distance < shortest))
    {
      return false;
    }
    this->best_ = IncomingSegment();
    this->best_.kind = kind;
    this->best_.distance = std::min(distance, shortest);
    this->straight_ = straight;
    return true;
  }

  std::size_t cornerWithNumber(Id face, Id globalId) const
  {
    const Triangle& t = this->mesh_.triangle(face);
    return this->field_.surface().globalId(t[0]) == globalId ? 0
      : this->field_.surface().globalId(t[1]) == globalId    ? 1
                                                             : 2;
  }

  void setDirection(Id face, const Barycentric& from, const Barycentric& to)
  {
    this->best_.frame = longestHalfedge(this->mesh_, face);
    this->best_.direction = inHalfedgeFrame(this->mesh_, this->best_.frame, to) -
      inHalfedgeFrame(this->mesh_, this->best_.frame, from);
  }

  void setRay(const IncomingRay& ray)
  {
    this->best_.frame = ray.halfedge;
    this->best_.direction = ray.direction;
    this->best_.x = ray.x;
    this->best_.leaves = ray.leaves;
  }

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  const SurfacePoint& point_;
  IncomingSegment best_;
  /// That the last piece comes from, where it does.
  Id corner_ = NoId;
  /// Length of the straight way that ends with it.
  double straight_ = 0.0;
  /// The longest edge of the face at hand, and how near to a point of it paths may bend.
  double faceSize_ = 0.0;
  double leastBend_ = 0.0;
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
    search.leaveFacesWithoutArea();
    return;
  }
  // Straight from a source in a face, or so near to a corner that rounding has hidden the arrival.
  // Where the source is known, a corner no farther off than rounding is no way: its own path may
  // come from here.
  forEachFace(field.mesh(), point,
    [&](Id face)
    {
      search.enter(face);
      search.comeFromSources(face);
    });
  if (field.arrivals()[point.id].isKnown() && search.best().kind == IncomingSegment::Kind::Source)
  {
    return;
  }
  forEachFace(field.mesh(), point,
    [&](Id face)
    {
      search.enter(face);
      search.comeFromCorners(face);
    });
}

// Of vertices at one place, but for rounding, that which the others come from has the direction.
// They may name each other.
IncomingSegment lastPieceToVertex(const DistanceField& field, Id vertex)
{
  if (field.arrivals().empty())
  {
    throw Error("The path to a vertex was asked for, but the solve did not keep arrivals.");
  }
  std::vector<Id> passed;
  for (;;)
  {
    const SurfacePoint point = SurfacePoint::atVertex(vertex);
    LastPieceSearch search(field, point);
    findAtVertex(field, point, search);
    passed.push_back(vertex);
    vertex = search.corner();
    if (!search.isBesideCorner() || std::find(passed.begin(), passed.end(), vertex) != passed.end())
    {
      return search.best();
    }
  }
}

} // anonymous namespace

// Where rays meet the halfedge at a small angle, the place where a window ends is rounded as much
// more.
Id cornerCrossed(const TriangleMesh& mesh, const Arrival& arrival)
{
  const double angle = arrival.direction.y / norm(arrival.direction);
  const double rounding = tolerance::PlaceRounding / std::max(angle, tolerance::NearEdge) *
    mesh.shape(TriangleMesh::faceOf(arrival.halfedge)).longest();
  return arrival.x <= rounding                              ? mesh.origin(arrival.halfedge)
    : arrival.x >= mesh.length(arrival.halfedge) - rounding ? mesh.destination(arrival.halfedge)
                                                            : NoId;
}

IncomingSegment incomingSegmentTo(const DistanceField& field, const SurfacePoint& point)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return lastPieceToVertex(field, point.id);
  }
  LastPieceSearch search(field, point);
  bool isKnown = false;
  forEachFace(field.mesh(), point,
    [&](Id face)
    {
      if (field.knowsInside(face))
      {
        isKnown = true;
        search.enter(face);
        search.comeFromSources(face);
        search.comeFromCorners(face);
        search.comeThroughWindows(face);
      }
    });
  if (!isKnown && !field.hasWindows())
  {
    throw Error("The path to a point was asked for, but the solve kept no windows there.");
  }
  search.leaveFacesWithoutArea();
  return search.isAtCorner() ? lastPieceToVertex(field, search.corner()) : search.best();
}

Vec3 gradientOf(const TriangleMesh& mesh, const IncomingSegment& piece)
{
  return piece.kind != IncomingSegment::Kind::None && piece.distance > 0.0
    ? inSpace(mesh, piece.frame, piece.direction)
    : Vec3{};
}

}
