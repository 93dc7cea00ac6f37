// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceField.h"

#include "Errors.h"
#include "Tolerance.h"

#include <algorithm>
#include <set>
#include <utility>

namespace geodesic
{

namespace
{

SurfacePoint onHalfedge(const TriangleMesh& mesh, Id halfedge, double fraction)
{
  if (fraction <= 0.0)
  {
    return SurfacePoint::atVertex(mesh.origin(halfedge));
  }
  if (fraction >= 1.0)
  {
    return SurfacePoint::atVertex(mesh.destination(halfedge));
  }
  return SurfacePoint::onEdge(halfedge, fraction);
}

} // anonymous namespace

DistanceField::DistanceField(const MeshPartition& surface, FrontResult front, KeptWindows kept)
  : surface_(surface)
  , front_(std::move(front))
  , kept_(std::move(kept))
{
}

void DistanceField::requireWindows() const
{
  if (!this->hasWindows() || !this->kept_.faces.empty())
  {
    throw Error("A path through faces was asked for, but the solve did not keep all windows.");
  }
}

WindowRuns DistanceField::windowsOn(Id halfedge) const
{
  return this->hasWindows() ? this->kept_.windows.at(halfedge) : WindowRuns();
}

std::vector<SourceInFace> DistanceField::sourcesIn(Id face) const
{
  const auto [first, last] = std::equal_range(this->front_.sourcesInFaces.begin(),
    this->front_.sourcesInFaces.end(), SourceInFace{ face },
    [](const SourceInFace& a, const SourceInFace& b) { return a.face < b.face; });
  return { first, last };
}

double DistanceField::distance(const SurfacePoint& point) const
{
  const SurfacePoint p = normalized(this->mesh(), point);
  if (p.kind == SurfacePoint::Kind::Vertex)
  {
    return this->front_.vertexDistances[p.id];
  }
  // One complete face tells all: on its edge, windows that come in through the edge are there.
  LastPieces pieces;
  bool isKnown = false;
  bool isDropped = false;
  forEachFace(this->mesh(), p,
    [&](Id face)
    {
      const bool isInsideKnown = this->hasWindows() && this->knowsInside(face);
      isDropped = isDropped || (!isInsideKnown && this->isComplete(face));
      if (isInsideKnown)
      {
        isKnown = true;
        this->arriveThrough(face, p, true, pieces);
      }
    });
  if (isDropped && !isKnown)
  {
    throw Error("The distance inside a face was asked for, but the solve did not keep the windows "
                "there.");
  }
  return pieces.best.distance;
}

bool DistanceField::LastPieces::isBest(double distance, double length) const
{
  const bool isTie = std::abs(distance - this->best.distance) <= this->tie;
  return isTie ? length > this->best.length : distance < this->best.distance;
}

void DistanceField::LastPieces::add(const IncomingSegment& piece)
{
  const bool isBestSoFar = this->isBest(piece.distance, piece.length);
  if (isBestSoFar)
  {
    this->best = piece;
  }
  if (piece.distance <= this->most)
  {
    this->bestKept = isBestSoFar ? this->kept.size() : this->bestKept;
    this->kept.push_back(piece);
  }
}

// The last pieces of paths to a point, through faces that the path has not crossed: the best first.
std::vector<DistanceField::IncomingSegment> DistanceField::waysTo(const SurfacePoint& point,
  double distance, double most, const std::vector<std::uint8_t>& isCrossed) const
{
  LastPieces pieces;
  forEachFace(this->mesh(), point,
    [&](Id face)
    {
      if (!isCrossed[face])
      {
        const double ofPlace = tolerance::PlaceRounding * this->mesh().shape(face).longest();
        pieces.tie = tolerance::Tie * distance + ofPlace;
        pieces.most = most + ofPlace;
        pieces.face = face;
        this->arriveThrough(face, point, false, pieces);
      }
    });
  std::vector<IncomingSegment>& ways = pieces.kept;
  if (!ways.empty())
  {
    std::swap(ways.front(), ways[pieces.bestKept]);
    std::stable_sort(ways.begin() + 1, ways.end(),
      [](const IncomingSegment& a, const IncomingSegment& b) { return a.distance < b.distance; });
  }
  return std::move(ways);
}

// A shortest path comes to a point of a face from a source in the face, a corner, or through a
// halfedge. Sides that hold the point give its distance, but no piece of the path.
void DistanceField::arriveThrough(
  Id face, const SurfacePoint& point, bool ownHalfedges, LastPieces& pieces) const
{
  const Barycentric b = barycentric(this->mesh(), point, face);
  this->arriveFromSources(face, b, pieces);
  this->arriveFromCorners(face, point, b, pieces);
  for (Id k = 0; k < 3; ++k)
  {
    if (ownHalfedges || b[(k + 2) % 3] != 0.0)
    {
      this->arriveThroughHalfedge(3 * face + k, b, pieces);
    }
  }
}

void DistanceField::arriveFromSources(Id face, const Barycentric& b, LastPieces& pieces) const
{
  for (const SourceInFace& source : this->sourcesIn(face))
  {
    const Barycentric nearest = nearestOnSource(this->mesh(), source, b);
    const double length = distanceInFace(this->mesh(), face, nearest, b);
    if (pieces.isWanted(length, length))
    {
      pieces.add(
        { length, length, fromBarycentric(this->mesh(), face, nearest), true, pieces.face });
    }
  }
}

void DistanceField::arriveFromCorners(
  Id face, const SurfacePoint& point, const Barycentric& b, LastPieces& pieces) const
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id vertex = this->mesh().triangle(face)[k];
    if (point.kind == SurfacePoint::Kind::Vertex && point.id == vertex)
    {
      continue;
    }
    const double length = distanceInFace(this->mesh(), face, cornerWeights(k), b);
    const double distance = this->front_.vertexDistances[vertex] + length;
    if (pieces.isWanted(distance, length))
    {
      pieces.add({ distance, length, SurfacePoint::atVertex(vertex), false, pieces.face });
    }
  }
}

void DistanceField::arriveThroughHalfedge(
  Id halfedge, const Barycentric& b, LastPieces& pieces) const
{
  const Vec2 p = inHalfedgeFrame(this->mesh(), halfedge, b);
  for (const Window& window : this->windowsOn(halfedge))
  {
    const double x = window.crossing(p);
    const double length = norm(p - Vec2{ x, 0.0 });
    const double distance = std::max(window.distance(x), 0.0) + length;
    if (pieces.isWanted(distance, length))
    {
      const double fraction = x / this->mesh().length(halfedge);
      pieces.add(
        { distance, length, onHalfedge(this->mesh(), halfedge, fraction), false, pieces.face });
    }
  }
}

std::vector<SurfacePoint> DistanceField::path(const SurfacePoint& from) const
{
  this->requireWindows();
  const double whole = this->distance(from);
  std::vector<SurfacePoint> points;
  for (const double slack : { tolerance::Tie, tolerance::BoundMargin })
  {
    if (whole < Infinity && points.empty())
    {
      points = this->path(normalized(this->mesh(), from), whole, slack);
    }
  }
  return points;
}

struct DistanceField::PathStep
{
  SurfacePoint point;
  /// Of the path up to here, and what is left.
  double length = 0.0;
  double left = 0.0;
  bool isAtSource = false;
  /// The face crossed to come here.
  Id face = NoId;
  std::vector<IncomingSegment> ways = {};
  std::size_t next = 0;
};

// Depth first: pieces without length may lead around faces without area to where no way on is left
// but back. A shortest path crosses no face twice, and what has been left once is not tried again,
// so that it ends.
std::vector<SurfacePoint> DistanceField::path(
  const SurfacePoint& from, double whole, double slack) const
{
  const double longest = (1.0 + slack) * whole;
  std::vector<std::uint8_t> isCrossed(this->mesh().numberOfFaces(), 0);
  std::set<std::pair<SurfacePoint::Kind, Id>> deadEnds;
  const auto keyOf = [this](const SurfacePoint& p)
  {
    return std::pair(p.kind, p.kind == SurfacePoint::Kind::Edge ? this->mesh().edgeOf(p.id) : p.id);
  };
  std::vector<PathStep> steps;
  const auto goTo = [&](PathStep step)
  {
    const SurfacePoint& p = step.point;
    step.isAtSource = step.isAtSource ||
      (p.kind == SurfacePoint::Kind::Vertex && this->front_.vertexDistances[p.id] == 0.0);
    if (step.face != NoId)
    {
      isCrossed[step.face] = 1;
    }
    if (!step.isAtSource)
    {
      step.ways = this->waysTo(p, step.left, longest - step.length, isCrossed);
    }
    steps.push_back(std::move(step));
  };
  goTo({ from, 0.0, whole, whole <= 0.0 });
  while (!steps.empty() && !steps.back().isAtSource)
  {
    PathStep& last = steps.back();
    if (last.next == last.ways.size())
    {
      deadEnds.insert(keyOf(last.point));
      if (last.face != NoId)
      {
        isCrossed[last.face] = 0;
      }
      steps.pop_back();
      continue;
    }
    const IncomingSegment& way = last.ways[last.next++];
    if (deadEnds.count(keyOf(way.from)) == 0)
    {
      // A piece without length may lead onto a vertex beside, and the path from there back.
      const bool ontoVertex = last.point.kind != SurfacePoint::Kind::Vertex &&
        way.from.kind == SurfacePoint::Kind::Vertex;
      goTo({ way.from, last.length + way.length, way.distance - way.length, way.fromSource,
        ontoVertex ? NoId : way.face });
    }
  }
  std::vector<SurfacePoint> points;
  for (const PathStep& step : steps)
  {
    points.push_back(step.point);
  }
  return points;
}

}
