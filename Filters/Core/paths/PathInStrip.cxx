// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathInStrip.h"

#include "Tolerance.h"
#include "field/Solve.h"
#include "paths/CleanPath.h"
#include "paths/PathInWindows.h"
#include "source/SourceWindowsOfPartition.h"

#include <algorithm>

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
  void setNumberOfDistricts(std::size_t count) override { this->passed_.resize(count); }
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

class StripSearch
{
public:
  StripSearch(const MeshPartition& part, const ReplicatedPatch& patch,
    const std::vector<SourceCurve>& curves, const PathEnds& ends, const TargetOnRank& target)
    : part_(part)
    , patch_(patch)
    , curves_(curves)
    , ends_(ends)
    , target_(target)
    , length_((1.0 + tolerance::BoundMargin) * target.distance)
  {
  }

  bool isTargetHere() const { return this->target_.face.rank == this->part_.exchange().rank(); }
  /// Finds this rank's faces of the strip.
  std::vector<Id> findFaces(const KnownDistances& known, const FrontOptions& options) const;
  /// Finds the path in the strip.
  PathToSource find(
    const ReplicatedPatch& strip, const std::vector<Id>& faces, FrontOptions options) const;

private:
  SurfacePoint targetOn(const ReplicatedPatch& patch) const
  {
    return fromFacePoint(patch.mesh(), patch.faceAt(this->target_.face), this->target_.point);
  }
  std::vector<double> distancesToTarget(
    const KnownDistances& known, FrontOptions options, Retention& passed) const;
  void addFacesOfCurves(std::vector<Id>& faces) const;
  Corridor corridorIn(const ReplicatedPatch& strip, const std::vector<Id>& faces) const;
  SurfacePoint pointOn(const ReplicatedPatch& strip, const SurfacePoint& point) const;
  std::vector<SourceCurve> curvesOn(const ReplicatedPatch& strip) const;

  const MeshPartition& part_;
  const ReplicatedPatch& patch_;
  const std::vector<SourceCurve>& curves_;
  const PathEnds& ends_;
  const TargetOnRank& target_;
  double length_;
};

// A front from the target, which goes nowhere from where the source is too far.
std::vector<double> StripSearch::distancesToTarget(
  const KnownDistances& known, FrontOptions options, Retention& passed) const
{
  const ReplicatedPatch around(this->part_,
    this->isTargetHere() ? std::vector<Id>{ this->target_.face.id } : std::vector<Id>());
  Corridor corridor{ known.atVertices, this->length_ };
  for (double& bound : corridor.lowerBounds)
  {
    bound = (1.0 - tolerance::BoundMargin) * std::min(bound, known.reach);
  }
  options.corridor = &corridor;
  return propagate(this->part_,
    sourceWindowsOfPartition(this->part_, around,
      makeSourceWindows(around.mesh(), { pointCurve(this->targetOn(around)) })),
    options, passed)
    .vertexDistances;
}

std::vector<Id> StripSearch::findFaces(
  const KnownDistances& known, const FrontOptions& options) const
{
  NotePassedFaces passed;
  const std::vector<double> toTarget = this->distancesToTarget(known, options, passed);
  std::vector<Id> faces;
  for (const std::vector<Id>& ofDistrict : passed.passed())
  {
    faces.insert(faces.end(), ofDistrict.begin(), ofDistrict.end());
  }
  if (this->isTargetHere())
  {
    const TriangleMesh& mesh = this->part_.mesh();
    forEachFace(mesh, fromFacePoint(mesh, this->target_.face.id, this->target_.point),
      [&](Id face) { faces.push_back(face); });
  }
  // A path may also run along edges, from vertex to vertex, where no window goes.
  for (Id vertex = 0; vertex < this->part_.numberOfOwnVertices(); ++vertex)
  {
    const double toSource = (1.0 - tolerance::BoundMargin) * known.atVertices[vertex];
    if (toSource + toTarget[vertex] <= this->length_)
    {
      for (const Id corner : this->part_.mesh().cornersAt(vertex))
      {
        faces.push_back(TriangleMesh::faceOf(corner));
      }
    }
  }
  this->addFacesOfCurves(faces);
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                [this](Id face) { return face == NoId || !this->part_.isOwn(face); }),
    faces.end());
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void StripSearch::addFacesOfCurves(std::vector<Id>& faces) const
{
  for (const SourceCurve& curve : this->curves_)
  {
    for (const Id face : curve.faces)
    {
      faces.push_back(this->patch_.faceOfPart(face));
    }
    for (const SurfacePoint& point : curve.points)
    {
      forEachFace(this->patch_.mesh(), point,
        [&](Id face) { faces.push_back(this->patch_.faceOfPart(face)); });
    }
  }
}

SurfacePoint StripSearch::pointOn(const ReplicatedPatch& strip, const SurfacePoint& point) const
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return SurfacePoint::atVertex(strip.vertexAt(this->patch_.globalId(point.id)));
  }
  const Id face = someFace(this->patch_.mesh(), point);
  return fromFacePoint(strip.mesh(), strip.faceAt(this->patch_.ownerOf(face)),
    toFacePoint(this->patch_.mesh(), face, point));
}

std::vector<SourceCurve> StripSearch::curvesOn(const ReplicatedPatch& strip) const
{
  const auto faceOn = [&](Id face) { return strip.faceAt(this->patch_.ownerOf(face)); };
  std::vector<SourceCurve> curves = this->curves_;
  for (SourceCurve& curve : curves)
  {
    for (SurfacePoint& point : curve.points)
    {
      point = this->pointOn(strip, point);
    }
    std::transform(curve.faces.begin(), curve.faces.end(), curve.faces.begin(), faceOn);
  }
  return curves;
}

// Lower bounds of the way to the target. Faces that were gathered beside the strip only make it
// larger: a path through them is one on the surface. One process gathers nothing: there the mesh is
// closed beside the strip.
Corridor StripSearch::corridorIn(const ReplicatedPatch& strip, const std::vector<Id>& faces) const
{
  const TriangleMesh& mesh = strip.mesh();
  const SurfacePoint target = this->targetOn(strip);
  Corridor corridor{ std::vector<double>(mesh.numberOfVertices(), Infinity), this->length_ };
  const auto open = [&](Id face)
  {
    for (const Id vertex : mesh.triangle(face))
    {
      corridor.lowerBounds[vertex] =
        (1.0 - tolerance::BoundMargin) * distanceInSpace(mesh, mesh.point(vertex), target);
    }
  };
  if (this->part_.isDistributed())
  {
    for (Id face = 0; face < mesh.numberOfFaces(); ++face)
    {
      open(face);
    }
  }
  else
  {
    std::for_each(faces.begin(), faces.end(), open);
  }
  return corridor;
}

PathToSource StripSearch::find(
  const ReplicatedPatch& strip, const std::vector<Id>& faces, FrontOptions options) const
{
  const TriangleMesh& mesh = strip.mesh();
  const Corridor corridor = this->corridorIn(strip, faces);
  const std::vector<SourceCurve> curves = this->curvesOn(strip);
  options.corridor = &corridor;
  const std::vector<SurfacePoint> path = cleanedPath(mesh,
    pathInWindows(solve(mesh, curves, options, KeepWindows::All), this->targetOn(strip)),
    this->target_.distance);
  const auto addressOf = [&strip](Id face) { return strip.ownerOf(face); };
  return { mesh, path, path.empty() ? PathEnd() : this->ends_.of(mesh, path, addressOf), true };
}

} // anonymous namespace

void pathInStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const PathEnds& ends, const TargetOnRank& target,
  const KnownDistances& known, const FrontOptions& options,
  const std::function<void(const PathToSource&)>& take)
{
  const StripSearch search(part, patch, curves, ends, target);
  const std::vector<Id> faces = search.findFaces(known, options);
  const ReplicatedPatch strip(part, faces);
  if (search.isTargetHere())
  {
    take(search.find(strip, faces, options));
  }
}

}
