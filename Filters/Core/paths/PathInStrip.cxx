// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathInStrip.h"

#include "Tolerance.h"
#include "paths/PathCorridor.h"
#include "paths/PathInWindows.h"

#include <algorithm>
#include <numeric>

namespace geodesic
{

namespace
{

SurfacePoint onPatch(const ReplicatedPatch& patch, const TargetOnRank& target)
{
  return fromFacePoint(patch.mesh(), patch.faceAt(target.face), target.point);
}

/// The longest path to a target that is looked for.
double longestTo(const TargetOnRank& target)
{
  return (1.0 + tolerance::BoundMargin) * target.distance;
}

bool isHere(const MeshPartition& part, const TargetOnRank& target)
{
  return target.face.rank == part.exchange().rank();
}

/// Finds this rank's faces of the strip.
std::vector<Id> facesOfStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const TargetOnRank& target,
  const std::vector<double>& toSource, const Job& job)
{
  const TriangleMesh& mesh = part.mesh();
  const ReplicatedPatch around(
    part, isHere(part, target) ? std::vector<Id>{ target.face.id } : std::vector<Id>());
  std::vector<Id> faces =
    facesInCorridor(part, around, onPatch(around, target), { toSource, longestTo(target) }, job);
  const auto addOwn = [&](Id face)
  {
    if (face != NoId && part.isOwn(face))
    {
      faces.push_back(face);
    }
  };
  if (isHere(part, target))
  {
    forEachFace(mesh, fromFacePoint(mesh, target.face.id, target.point), addOwn);
  }
  const auto addOfPatch = [&](Id face) { addOwn(part.faceAt(patch.ownerOf(face))); };
  for (const SourceCurve& curve : curves)
  {
    std::for_each(curve.faces.begin(), curve.faces.end(), addOfPatch);
    for (const SurfacePoint& point : curve.points)
    {
      forEachFace(patch.mesh(), point, addOfPatch);
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::vector<SourceCurve> curvesOnStrip(
  const ReplicatedPatch& strip, const ReplicatedPatch& patch, std::vector<SourceCurve> curves)
{
  const auto faceOn = [&](Id face) { return strip.faceAt(patch.ownerOf(face)); };
  const auto pointOn = [&](const SurfacePoint& point)
  {
    const Id face = someFace(patch.mesh(), point);
    return point.kind == SurfacePoint::Kind::Vertex
      ? SurfacePoint::atVertex(strip.vertexAt(patch.globalId(point.id)))
      : fromFacePoint(strip.mesh(), faceOn(face), toFacePoint(patch.mesh(), face, point));
  };
  for (SourceCurve& curve : curves)
  {
    std::transform(curve.points.begin(), curve.points.end(), curve.points.begin(), pointOn);
    std::transform(curve.faces.begin(), curve.faces.end(), curve.faces.begin(), faceOn);
  }
  return curves;
}

// Lower bounds of the way to the target. Faces that were gathered beside the strip only make it
// larger: a path through them is one on the surface. In one process the mesh goes on beside the
// strip, and is closed there.
//
// \param faces of the strip's mesh.
Corridor corridorIn(
  const ReplicatedPatch& strip, const std::vector<Id>& faces, const TargetOnRank& target)
{
  const TriangleMesh& mesh = strip.mesh();
  const SurfacePoint end = onPatch(strip, target);
  Corridor corridor{ std::vector<double>(mesh.numberOfVertices(), Infinity), longestTo(target) };
  for (const Id face : faces)
  {
    for (const Id vertex : mesh.triangle(face))
    {
      corridor.lowerBounds[vertex] =
        (1.0 - tolerance::BoundMargin) * distanceInSpace(mesh, mesh.point(vertex), end);
    }
  }
  return corridor;
}

} // anonymous namespace

std::optional<PathToSource> pathInStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const TargetOnRank& target,
  const std::vector<double>& toSource, const Job& job)
{
  std::vector<Id> faces = facesOfStrip(part, patch, curves, target, toSource, job);
  const ReplicatedPatch strip(part, faces);
  if (!isHere(part, target))
  {
    return std::nullopt;
  }
  if (part.isDistributed())
  {
    faces.resize(strip.mesh().numberOfFaces());
    std::iota(faces.begin(), faces.end(), Id(0));
  }
  const Corridor corridor = corridorIn(strip, faces, target);
  FrontOptions options;
  options.corridor = &corridor;
  options.job = job;
  options.keepArrivals = true;
  options.keepAngles = true;
  const std::vector<SourceCurve> onStrip = curvesOnStrip(strip, patch, curves);
  const DistanceField field = solve(strip.mesh(), onStrip, options, KeepWindows::All);
  TracedPath found;
  found.whole = target.distance;
  found.points = pathInWindows(field, onPatch(strip, target));
  PathToSource path;
  path.target = target.number;
  path.wasLost = true;
  path.gathered = strip;
  path.points = found.points;
  if (!found.points.empty())
  {
    auto before = found.points.end() - 2;
    found.faces = { commonFace(strip.mesh(), *before, found.points.back()) };
    // The ray to the end begins at the last vertex, but not at one beside the end, near the source.
    while (before != found.points.begin() &&
      (before->kind != SurfacePoint::Kind::Vertex ||
        field.distance(*before) <= tolerance::BesideEnd * found.whole))
    {
      --before;
    }
    found.piece = incomingSegmentTo(field, *before);
    FootFinder feet(field, ReplicatedPatch(strip.mesh()), onStrip);
    path.end = endOf(found, feet, onStrip);
  }
  return path;
}

}
