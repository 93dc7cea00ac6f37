// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceField.h"

#include "Errors.h"
#include "Tolerance.h"

#include <algorithm>

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

DistanceField::DistanceField(const TriangleMesh& mesh, FrontResult front, KeptWindows kept)
  : mesh_(&mesh)
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
  const SurfacePoint p = normalized(*this->mesh_, point);
  if (p.kind == SurfacePoint::Kind::Vertex)
  {
    return this->front_.vertexDistances[p.id];
  }
  // One complete face tells all: on its edge, windows that come in through the edge are there.
  LastPiece best;
  bool isKnown = false;
  bool isDropped = false;
  forEachFace(*this->mesh_, p,
    [&](Id face)
    {
      const bool isInsideKnown = this->hasWindows() && this->knowsInside(face);
      isDropped = isDropped || (!isInsideKnown && this->isComplete(face));
      if (isInsideKnown)
      {
        isKnown = true;
        this->arriveThrough(face, p, true, best);
      }
    });
  if (isDropped && !isKnown)
  {
    throw Error("The distance inside a face was asked for, but the solve did not keep the windows "
                "there.");
  }
  return best.distance;
}

bool DistanceField::LastPiece::isBeatenBy(double otherDistance, double otherLength) const
{
  const bool isTie = std::abs(otherDistance - this->distance) <= this->tie;
  return isTie ? otherLength > this->length : otherDistance < this->distance;
}

void DistanceField::LastPiece::replace(
  double newDistance, double newLength, const SurfacePoint& newFrom, bool isFromSource)
{
  this->distance = newDistance;
  this->length = newLength;
  this->from = newFrom;
  this->fromSource = isFromSource;
}

// The last piece of a shortest path to a point, through a face that the path has not crossed.
DistanceField::LastPiece DistanceField::arrive(
  const SurfacePoint& point, double distance, const std::vector<std::uint8_t>& isCrossed) const
{
  LastPiece best;
  forEachFace(*this->mesh_, point,
    [&](Id face)
    {
      if (!isCrossed[face])
      {
        const LastPiece before = best;
        best.tie =
          tolerance::Tie * distance + tolerance::PlaceRounding * this->mesh_->shape(face).longest();
        this->arriveThrough(face, point, false, best);
        const bool isBetter = best.distance != before.distance || best.length != before.length;
        best.face = isBetter ? face : best.face;
      }
    });
  return best;
}

// A shortest path comes to a point of a face from a source in the face, a corner, or through a
// halfedge. Sides that hold the point give its distance, but no piece of the path.
void DistanceField::arriveThrough(
  Id face, const SurfacePoint& point, bool ownHalfedges, LastPiece& best) const
{
  const Barycentric b = barycentric(*this->mesh_, point, face);
  this->arriveFromSources(face, b, best);
  this->arriveFromCorners(face, point, b, best);
  for (Id k = 0; k < 3; ++k)
  {
    if (ownHalfedges || b[(k + 2) % 3] != 0.0)
    {
      this->arriveThroughHalfedge(3 * face + k, b, best);
    }
  }
}

void DistanceField::arriveFromSources(Id face, const Barycentric& b, LastPiece& best) const
{
  for (const SourceInFace& source : this->sourcesIn(face))
  {
    const Barycentric nearest = nearestOnSource(*this->mesh_, source, b);
    const double length = distanceInFace(*this->mesh_, face, nearest, b);
    if (best.isBeatenBy(length, length))
    {
      best.replace(length, length, fromBarycentric(*this->mesh_, face, nearest), true);
    }
  }
}

void DistanceField::arriveFromCorners(
  Id face, const SurfacePoint& point, const Barycentric& b, LastPiece& best) const
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id vertex = this->mesh_->triangle(face)[k];
    if (point.kind == SurfacePoint::Kind::Vertex && point.id == vertex)
    {
      continue;
    }
    const double length = distanceInFace(*this->mesh_, face, cornerWeights(k), b);
    const double distance = this->front_.vertexDistances[vertex] + length;
    if (best.isBeatenBy(distance, length))
    {
      best.replace(distance, length, SurfacePoint::atVertex(vertex), false);
    }
  }
}

void DistanceField::arriveThroughHalfedge(Id halfedge, const Barycentric& b, LastPiece& best) const
{
  const Vec2 p = inHalfedgeFrame(*this->mesh_, halfedge, b);
  for (const Window& window : this->windowsOn(halfedge))
  {
    const double x = window.crossing(p);
    const double length = norm(p - Vec2{ x, 0.0 });
    const double distance = std::max(window.distance(x), 0.0) + length;
    if (best.isBeatenBy(distance, length))
    {
      best.replace(distance, length,
        onHalfedge(*this->mesh_, halfedge, x / this->mesh_->length(halfedge)), false);
    }
  }
}

// A shortest path crosses no face twice, so that pieces without length lead around in no circle.
std::vector<SurfacePoint> DistanceField::path(const SurfacePoint& from) const
{
  this->requireWindows();
  std::vector<SurfacePoint> points;
  double remaining = this->distance(from);
  if (!(remaining < Infinity))
  {
    return points;
  }
  points.push_back(normalized(*this->mesh_, from));
  bool atSource = remaining <= 0.0;
  std::vector<std::uint8_t> isCrossed(this->mesh_->numberOfFaces(), 0);
  while (!atSource)
  {
    const LastPiece arrival = this->arrive(points.back(), remaining, isCrossed);
    const double next = arrival.distance - arrival.length;
    if (!(next <= remaining * (1.0 + tolerance::Tie)) && !arrival.fromSource)
    {
      break; // at the source but for rounding
    }
    // A piece without length may lead onto a vertex beside, and the path from there back.
    const bool ontoVertex = points.back().kind != SurfacePoint::Kind::Vertex &&
      arrival.from.kind == SurfacePoint::Kind::Vertex;
    isCrossed[arrival.face] |= ontoVertex ? 0 : 1;
    points.push_back(arrival.from);
    remaining = next;
    const SurfacePoint& p = points.back();
    const bool vertexOnSource =
      p.kind == SurfacePoint::Kind::Vertex && this->front_.vertexDistances[p.id] == 0.0;
    atSource = arrival.fromSource || vertexOnSource;
  }
  return points;
}

}
