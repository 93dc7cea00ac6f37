// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathInStrip.h"

#include "Tolerance.h"
#include "field/DistanceField.h"
#include "paths/CleanPath.h"
#include "paths/PathInWindows.h"
#include "source/SourceWindows.h"

#include <algorithm>
#include <numeric>

namespace geodesic
{

namespace
{

/// Notes which faces windows have gone through. Two tasks may note one face, so each district has a
/// list of its own.
class NotePassedFaces : public Retention
{
public:
  bool needsInside() const override { return false; }
  void start(std::size_t districts, const std::vector<SourceInFace>&) override
  {
    this->passed_.resize(districts);
  }
  void pass(std::size_t district, const PassedList& list, Id, WindowPool& pool) override
  {
    this->passed_[district].push_back(TriangleMesh::faceOf(list.halfedge));
    pool.free(list.windows);
  }

  /// For each district its faces, several times maybe.
  const std::vector<std::vector<Id>>& passed() const { return this->passed_; }

private:
  std::vector<std::vector<Id>> passed_;
};

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

// A front from the target, which goes nowhere from where the source is too far.
std::vector<double> distancesTo(const TargetOnRank& target, const MeshPartition& part,
  const KnownDistances& known, FrontOptions options, Retention& passed)
{
  const ReplicatedPatch around(
    part, isHere(part, target) ? std::vector<Id>{ target.face.id } : std::vector<Id>());
  Corridor corridor{ known.atVertices, longestTo(target) };
  for (double& bound : corridor.lowerBounds)
  {
    bound = (1.0 - tolerance::BoundMargin) * std::min(bound, known.reach);
  }
  options.corridor = &corridor;
  return propagate(part,
    sourceWindowsOfPartition(
      part, around, makeSourceWindows(around.mesh(), { pointCurve(onPatch(around, target)) })),
    options, passed)
    .vertexDistances;
}

/// Adds the part's faces that the curves lie in or touch; NoId for others.
void addFacesOfCurves(
  const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves, std::vector<Id>& faces)
{
  const auto add = [&](Id face) { faces.push_back(patch.faceOfPart(face)); };
  for (const SourceCurve& curve : curves)
  {
    std::for_each(curve.faces.begin(), curve.faces.end(), add);
    for (const SurfacePoint& point : curve.points)
    {
      forEachFace(patch.mesh(), point, add);
    }
  }
}

/// Finds this rank's faces of the strip.
std::vector<Id> facesOfStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const TargetOnRank& target, const KnownDistances& known,
  const FrontOptions& options)
{
  const TriangleMesh& mesh = part.mesh();
  NotePassedFaces passed;
  const std::vector<double> toTarget = distancesTo(target, part, known, options, passed);
  std::vector<Id> faces;
  for (const std::vector<Id>& ofDistrict : passed.passed())
  {
    faces.insert(faces.end(), ofDistrict.begin(), ofDistrict.end());
  }
  if (isHere(part, target))
  {
    forEachFace(mesh, fromFacePoint(mesh, target.face.id, target.point),
      [&](Id face) { faces.push_back(face); });
  }
  // A path may also run along edges, from vertex to vertex, where no window goes.
  for (Id vertex = 0; vertex < part.numberOfOwnVertices(); ++vertex)
  {
    const double toSource = (1.0 - tolerance::BoundMargin) * known.atVertices[vertex];
    if (toSource + toTarget[vertex] <= longestTo(target))
    {
      for (const Id corner : mesh.cornersAt(vertex))
      {
        faces.push_back(TriangleMesh::faceOf(corner));
      }
    }
  }
  addFacesOfCurves(patch, curves, faces);
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                [&part](Id face) { return face == NoId || !part.isOwn(face); }),
    faces.end());
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
// larger: a path through them is one on the surface. One process gathers nothing: there the mesh is
// closed beside the strip.
Corridor corridorIn(
  const ReplicatedPatch& strip, const TargetOnRank& target, bool isGathered, std::vector<Id> faces)
{
  const TriangleMesh& mesh = strip.mesh();
  if (isGathered)
  {
    faces.resize(mesh.numberOfFaces());
    std::iota(faces.begin(), faces.end(), Id(0));
  }
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

void pathInStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const PathEnds& ends, const TargetOnRank& target,
  const KnownDistances& known, FrontOptions options,
  const std::function<void(const PathToSource&)>& take)
{
  const std::vector<Id> faces = facesOfStrip(part, patch, curves, target, known, options);
  const ReplicatedPatch strip(part, faces);
  if (!isHere(part, target))
  {
    return;
  }
  const Corridor corridor = corridorIn(strip, target, part.isDistributed(), faces);
  options.corridor = &corridor;
  const DistanceField field =
    solve(strip.mesh(), curvesOnStrip(strip, patch, curves), options, KeepWindows::All);
  const std::vector<SurfacePoint> path =
    cleanedPath(strip.mesh(), pathInWindows(field, onPatch(strip, target)), target.distance);
  const auto addressOf = [&strip](Id face) { return strip.ownerOf(face); };
  take({ strip.mesh(), path, path.empty() ? PathEnd() : ends.of(strip.mesh(), path, addressOf),
    true });
}

}
