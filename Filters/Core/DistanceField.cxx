// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceField.h"

#include "Errors.h"
#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

using Barycentric = std::array<double, 3>;

// The frame of side 0 serves for distances inside a face; another side's where that has no length.
Id frameSide(const TriangleMesh& mesh, Id face)
{
  return 3 * face + static_cast<Id>(mesh.shape(face).longestSide());
}

double distanceInFace(const TriangleMesh& mesh, Id face, const Barycentric& a, const Barycentric& b)
{
  const Id side = frameSide(mesh, face);
  return norm(inSideFrame(mesh, side, a) - inSideFrame(mesh, side, b));
}

// The point of the segment from a to b nearest to p.
Barycentric nearestOnSegment(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& p)
{
  const Id side = frameSide(mesh, source.face);
  const Vec2 a = inSideFrame(mesh, side, source.a);
  const Vec2 ab = inSideFrame(mesh, side, source.b) - a;
  const double squared = dot(ab, ab);
  const double along = dot(inSideFrame(mesh, side, p) - a, ab);
  const double t = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  Barycentric nearest;
  for (std::size_t k = 0; k < 3; ++k)
  {
    nearest[k] = (1.0 - t) * source.a[k] + t * source.b[k];
  }
  return nearest;
}

} // anonymous namespace

double distanceToSource(
  const TriangleMesh& mesh, const SourceInFace& source, const std::array<double, 3>& p)
{
  return distanceInFace(mesh, source.face, nearestOnSegment(mesh, source, p), p);
}

namespace
{

SurfacePoint onSide(const TriangleMesh& mesh, Id side, double fraction)
{
  if (fraction <= 0.0)
  {
    return SurfacePoint::atVertex(mesh.origin(side));
  }
  if (fraction >= 1.0)
  {
    return SurfacePoint::atVertex(mesh.destination(side));
  }
  return SurfacePoint::onEdge(side, fraction);
}

} // anonymous namespace

void DistanceField::requireWindows() const
{
  if (!this->hasWindows() || !this->faceKept_.empty())
  {
    throw Error("The distance inside faces was asked for, but the solve did not keep all windows.");
  }
}

WindowRuns DistanceField::windowsOn(Id side) const
{
  return this->hasWindows() ? this->windows_.at(side) : WindowRuns();
}

std::vector<SourceInFace> DistanceField::sourcesIn(Id face) const
{
  const auto [first, last] = std::equal_range(this->sourcesInFaces_.begin(),
    this->sourcesInFaces_.end(), SourceInFace{ face, {}, {} },
    [](const SourceInFace& a, const SourceInFace& b) { return a.face < b.face; });
  return { first, last };
}

double DistanceField::distance(const SurfacePoint& point) const
{
  this->requireWindows();
  const SurfacePoint p = normalized(*this->mesh_, point);
  if (p.kind == SurfacePoint::Kind::Vertex)
  {
    return this->vertexDistances_[p.id];
  }
  // One complete face tells all: on its edge, windows that come in through the edge are there.
  Arrival best;
  forEachFace(*this->mesh_, p,
    [&](Id face)
    {
      if (this->faceComplete_.empty() || this->faceComplete_[face])
      {
        this->arriveThrough(face, p, true, best);
      }
    });
  return best.distance;
}

// The last piece of a shortest path to a point, through a face that the path has not just crossed.
DistanceField::Arrival DistanceField::arrive(
  const SurfacePoint& point, const std::vector<Id>& crossed) const
{
  Arrival best;
  forEachFace(*this->mesh_, point,
    [&](Id face)
    {
      if (std::find(crossed.begin(), crossed.end(), face) == crossed.end())
      {
        const double before = best.distance;
        this->arriveThrough(face, point, false, best);
        best.face = best.distance < before ? face : best.face;
      }
    });
  return best;
}

// A shortest path comes to a point of a face from a source in the face, a corner, or through a
// side. Sides that hold the point give its distance, but no piece of the path.
void DistanceField::arriveThrough(
  Id face, const SurfacePoint& point, bool ownSides, Arrival& best) const
{
  const Barycentric b = barycentric(*this->mesh_, point, face);
  this->arriveFromSources(face, b, best);
  this->arriveFromCorners(face, point, b, best);
  for (Id k = 0; k < 3; ++k)
  {
    if (ownSides || b[(k + 2) % 3] != 0.0)
    {
      this->arriveThroughSide(3 * face + k, b, best);
    }
  }
}

void DistanceField::arriveFromSources(Id face, const Barycentric& b, Arrival& best) const
{
  for (const SourceInFace& source : this->sourcesIn(face))
  {
    const Barycentric nearest = nearestOnSegment(*this->mesh_, source, b);
    const double length = distanceInFace(*this->mesh_, face, nearest, b);
    if (length < best.distance)
    {
      best = { length, length, fromBarycentric(*this->mesh_, face, nearest), true };
    }
  }
}

void DistanceField::arriveFromCorners(
  Id face, const SurfacePoint& point, const Barycentric& b, Arrival& best) const
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id vertex = this->mesh_->triangle(face)[k];
    if (point.kind == SurfacePoint::Kind::Vertex && point.id == vertex)
    {
      continue;
    }
    Barycentric corner{};
    corner[k] = 1.0;
    const double length = distanceInFace(*this->mesh_, face, corner, b);
    const double distance = this->vertexDistances_[vertex] + length;
    if (distance < best.distance)
    {
      best = { distance, length, SurfacePoint::atVertex(vertex), false };
    }
  }
}

void DistanceField::arriveThroughSide(Id side, const Barycentric& b, Arrival& best) const
{
  const Vec2 p = inSideFrame(*this->mesh_, side, b);
  for (const Window& window : this->windowsOn(side))
  {
    const double x = window.crossing(p);
    const double length = norm(p - Vec2{ x, 0.0 });
    const double distance = std::max(window.distance(x), 0.0) + length;
    if (distance < best.distance)
    {
      best = { distance, length, onSide(*this->mesh_, side, x / this->mesh_->length(side)), false };
    }
  }
}

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
  // A shortest path crosses no face twice; pieces without length must not lead around in a circle.
  std::vector<Id> crossed;
  while (!atSource)
  {
    const Arrival arrival = this->arrive(points.back(), crossed);
    const double next = arrival.distance - arrival.length;
    if (!(next <= remaining * (1.0 + tolerance::Tie)) && !arrival.fromSource)
    {
      break; // at the source but for rounding
    }
    if (next < remaining)
    {
      crossed.clear();
    }
    // A piece without length may lead onto a vertex beside, and the path from there back.
    const bool ontoVertex = points.back().kind != SurfacePoint::Kind::Vertex &&
      arrival.from.kind == SurfacePoint::Kind::Vertex;
    if (!ontoVertex)
    {
      crossed.push_back(arrival.face);
    }
    points.push_back(arrival.from);
    remaining = next;
    const SurfacePoint& p = points.back();
    const bool vertexOnSource =
      p.kind == SurfacePoint::Kind::Vertex && this->vertexDistances_[p.id] == 0.0;
    atSource = arrival.fromSource || vertexOnSource;
  }
  return points;
}

}
