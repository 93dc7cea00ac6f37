// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceField.h"

#include "Errors.h"
#include "field/WaysIntoFace.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

double leastDistance(const DistanceField& field, Id face, const SurfacePoint& place)
{
  const Barycentric point = barycentric(field.mesh(), place, face);
  double least = Infinity;
  const auto take = [&](double distance) { least = std::min(least, distance); };
  forEachWayFromSource(field, face, point,
    [&](const SourceInFace&, const Barycentric&, double length) { take(length); });
  forEachWayFromCorner(
    field, face, place, point, [&](std::size_t, double distance, double) { take(distance); });
  for (Id halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
  {
    forEachWayThrough(field, halfedge, inHalfedgeFrame(field.mesh(), halfedge, point),
      [&](const Window&, double, double distance, double) { take(distance); });
  }
  return least;
}

} // anonymous namespace

DistanceField::DistanceField(const MeshPartition& surface, FrontResult front, KeptWindows kept)
  : surface_(surface)
  , front_(std::move(front))
  , kept_(std::move(kept))
{
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
  // One complete face suffices, also on its edges: it has the windows that enter through them.
  double least = Infinity;
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
        least = std::min(least, leastDistance(*this, face, p));
      }
    });
  if (isDropped && !isKnown)
  {
    throw Error(
      "The distance inside a face was asked for, but the solve did not keep the windows there.");
  }
  return least;
}

}
