// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceField.h"

#include "Errors.h"
#include "field/WaysIntoFace.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

std::vector<SourceInFace> DistanceField::sourcesIn(Id face) const
{
  const auto [first, last] = std::equal_range(
    this->front_.sourcesInFaces.begin(), this->front_.sourcesInFaces.end(), SourceInFace{ face });
  return { first, last };
}

bool DistanceField::isCovered(Id face) const
{
  return isWholeFaceAmong(this->sourcesIn(face));
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
        forEachWay(
          *this, face, p, [&](const WayIntoFace& way) { least = std::min(least, way.distance); });
      }
    });
  if (isDropped && !isKnown)
  {
    throw Error(
      "The distance inside a face was asked for, but the solve did not keep the windows there.");
  }
  return least;
}

DistanceField solve(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options, KeepWindows keep)
{
  if (keep == KeepWindows::All)
  {
    return solveKeeping(surface, std::move(sources), options, {});
  }
  KeepNone none;
  return { surface, propagate(surface, std::move(sources), options, none), KeptWindows() };
}

DistanceField solveKeeping(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options, std::vector<std::uint8_t> faces)
{
  KeepFaces retention(surface.mesh(), std::move(faces));
  FrontResult front = propagate(surface, std::move(sources), options, retention);
  return { surface, std::move(front), retention.release() };
}

DistanceField solve(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, KeepWindows keep)
{
  return solve(MeshPartition(mesh), makeSourceWindows(mesh, sources, options.job), options, keep);
}

}
