// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathInWindows.h"

#include "Errors.h"
#include "Tolerance.h"
#include "field/WaysIntoFace.h"

#include <algorithm>
#include <set>
#include <utility>

namespace geodesic
{

namespace
{

/// A straight piece of a path through a face, which ends at the point that is looked at.
struct Piece
{
  /// The lengths of the path and of the piece.
  double distance;
  double length;
  SurfacePoint begin;
  bool beginsAtSource;
  Id face;

  bool goesFartherThan(const Piece& other) const
  {
    return this->beginsAtSource != other.beginsAtSource ? this->beginsAtSource
                                                        : this->length > other.length;
  }
};

/// A place that a search has come to, and the ways on that are left to try.
struct PathStep
{
  SurfacePoint point;
  /// The length of the path up to here, and the length that is left.
  double length = 0.0;
  double left = 0.0;
  bool isAtSource = false;
  std::vector<Piece> ways = {};
  std::size_t next = 0;
};

/// Searches depth first: pieces without length may lead to where no way on is left but back. A
/// shortest path crosses no face twice, and a place that has been left once is not tried again, so
/// that the search ends. A face before a dead end stays crossed: the step before knows all ways
/// through it.
class PathSearch
{
public:
  PathSearch(const DistanceField& field, double longest)
    : field_(field)
    , mesh_(field.mesh())
    , longest_(longest)
    , isCrossed_(mesh_.numberOfFaces(), 0)
  {
  }

  std::vector<SurfacePoint> run(const SurfacePoint& from, double whole)
  {
    this->goTo({ from, 0.0, whole, whole <= 0.0 });
    while (!this->steps_.empty() && !this->steps_.back().isAtSource)
    {
      PathStep& last = this->steps_.back();
      if (last.next == last.ways.size())
      {
        this->deadEnds_.insert(this->keyOf(last.point));
        this->steps_.pop_back();
        continue;
      }
      const Piece& way = last.ways[last.next++];
      if (this->deadEnds_.count(this->keyOf(way.begin)) == 0)
      {
        // A piece without length may lead onto a vertex beside, and the path from there back.
        const bool ontoVertex = last.point.kind != SurfacePoint::Kind::Vertex &&
          way.begin.kind == SurfacePoint::Kind::Vertex;
        if (!ontoVertex)
        {
          this->isCrossed_[way.face] = 1;
        }
        this->goTo(
          { way.begin, last.length + way.length, way.distance - way.length, way.beginsAtSource });
      }
    }
    std::vector<SurfacePoint> points;
    for (const PathStep& step : this->steps_)
    {
      points.push_back(step.point);
    }
    return points;
  }

private:
  using Key = std::pair<SurfacePoint::Kind, Id>;

  Key keyOf(const SurfacePoint& p) const
  {
    return { p.kind, p.kind == SurfacePoint::Kind::Edge ? this->mesh_.edgeOf(p.id) : p.id };
  }

  void goTo(PathStep step)
  {
    if (!step.isAtSource)
    {
      step.ways = this->waysTo(step.point, step.left, this->longest_ - step.length);
    }
    this->steps_.push_back(std::move(step));
  }

  /// The last pieces of paths to a point, through faces that the path has not crossed. Of those as
  /// short as the best but for rounding one from a source comes first, else the longest: no path is
  /// led over places a rounding beside it. The others follow by distance.
  ///
  /// \param most the longest distance. A distance at a vertex carries the rounding of windows
  ///        through any of the faces around.
  std::vector<Piece> waysTo(const SurfacePoint& point, double distance, double most) const
  {
    double longest = 0.0;
    forEachFace(this->mesh_, point,
      [&](Id face) { longest = std::max(longest, this->mesh_.shape(face).longest()); });
    most += tolerance::PlaceRounding * longest;
    std::vector<Piece> pieces;
    std::size_t best = 0;
    forEachFace(this->mesh_, point,
      [&](Id face)
      {
        const double tie =
          tolerance::Tie * distance + tolerance::PlaceRounding * this->mesh_.shape(face).longest();
        const auto add = [&](const WayIntoFace& way)
        {
          if (!way.isBehind && way.distance <= most)
          {
            const SurfacePoint begin = this->beginOf(way, face);
            const bool isFromSource = way.kind == WayIntoFace::Kind::Source ||
              (begin.kind == SurfacePoint::Kind::Vertex &&
                this->field_.vertexDistances()[begin.id] == 0.0);
            const Piece& piece =
              pieces.emplace_back(Piece{ way.distance, way.length, begin, isFromSource, face });
            const double longer = piece.distance - pieces[best].distance;
            const bool isTie = std::abs(longer) <= tie;
            const bool isBetter = isTie ? piece.goesFartherThan(pieces[best]) : longer < 0.0;
            best = isBetter ? pieces.size() - 1 : best;
          }
        };
        if (!this->isCrossed_[face])
        {
          forEachWay(this->field_, face, point, add);
        }
      });
    if (!pieces.empty())
    {
      std::swap(pieces.front(), pieces[best]);
      std::stable_sort(pieces.begin() + 1, pieces.end(),
        [](const Piece& a, const Piece& b) { return a.distance < b.distance; });
    }
    return pieces;
  }

  SurfacePoint beginOf(const WayIntoFace& way, Id face) const
  {
    switch (way.kind)
    {
      case WayIntoFace::Kind::Corner:
        return SurfacePoint::atVertex(way.vertex);
      case WayIntoFace::Kind::Window:
        return placeOnHalfedge(this->mesh_, way.halfedge, way.x / this->mesh_.length(way.halfedge));
      default:
        return fromBarycentric(this->mesh_, face, way.begin);
    }
  }

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  double longest_;
  std::vector<std::uint8_t> isCrossed_;
  std::set<Key> deadEnds_;
  std::vector<PathStep> steps_;
};

/// The vertex that a point on an edge is at but for the rounding of tracing; else the point.
SurfacePoint atVertexWithin(const TriangleMesh& mesh, const SurfacePoint& point, double rounding)
{
  if (point.kind != SurfacePoint::Kind::Edge)
  {
    return point;
  }
  return placeOnHalfedge(
    mesh, point.id, point.u, std::min(rounding, tolerance::SnapFraction * mesh.length(point.id)));
}

} // anonymous namespace

std::vector<SurfacePoint> pathInWindows(const DistanceField& field, const SurfacePoint& from)
{
  if (!field.hasAllWindows())
  {
    throw Error("A path through faces was asked for, but the solve did not keep all windows.");
  }
  const double whole = field.distance(from);
  std::vector<SurfacePoint> points;
  for (const double slack : { tolerance::Tie, tolerance::BoundMargin })
  {
    if (whole < Infinity && points.empty())
    {
      points = PathSearch(field, (1.0 + slack) * whole).run(normalized(field.mesh(), from), whole);
    }
  }
  return cleanedPath(field.mesh(), points, whole);
}

std::vector<SurfacePoint> cleanedPath(
  const TriangleMesh& mesh, const std::vector<SurfacePoint>& path, double length)
{
  if (path.empty())
  {
    return path;
  }
  std::vector<SurfacePoint> result = { path.front() };
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    const SurfacePoint atVertex = atVertexWithin(mesh, path[i], tolerance::PathAtVertex * length);
    const bool isKept = commonFace(mesh, result.back(), atVertex) != NoId &&
      commonFace(mesh, atVertex, path[i + 1]) != NoId;
    const SurfacePoint& point = isKept ? atVertex : path[i];
    if (!samePlace(mesh, point, result.back()))
    {
      result.push_back(point);
    }
  }
  if (result.size() > 1 && samePlace(mesh, result.back(), path.back()))
  {
    result.pop_back();
  }
  result.push_back(path.back());
  return result;
}

}
