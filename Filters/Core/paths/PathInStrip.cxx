// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathInStrip.h"

#include "Tolerance.h"
#include "field/Solve.h"
#include "paths/CleanPath.h"
#include "paths/NotePassedFaces.h"
#include "source/CurvesInFaces.h"
#include "source/SourceWindowsOfPartition.h"

#include <algorithm>

namespace geodesic
{

namespace
{

class StripSearch
{
public:
  StripSearch(const MeshPartition& part, const ReplicatedPatch& patch,
    const std::vector<SourceCurve>& curves, const TargetOnRank& target)
    : part_(part)
    , patch_(patch)
    , curves_(curves)
    , target_(target)
    , length_((1.0 + tolerance::BoundMargin) * target.distance)
  {
  }

  /// Selects what the way back from the target goes through.
  void findWayBack(const KnownDistances& known, FrontOptions options);
  /// On the target's rank; all ranks take part in gathering the strip.
  PathInSpace find(const FrontOptions& options) const;

private:
  bool isTargetHere() const { return this->target_.face.rank == this->part_.exchange().rank(); }
  void addOwn(Id face)
  {
    if (face != NoId && this->part_.isOwn(face))
    {
      this->faces_.push_back(face);
    }
  }
  void addFacesOfCurves();
  SurfacePoint pointOf(const ReplicatedPatch& strip, SurfacePoint point) const;
  std::vector<SourceCurve> curvesOn(const ReplicatedPatch& strip) const;

  const MeshPartition& part_;
  const ReplicatedPatch& patch_;
  const std::vector<SourceCurve>& curves_;
  const TargetOnRank& target_;
  double length_;
  /// Of this rank in the strip.
  std::vector<Id> faces_;
};

void StripSearch::findWayBack(const KnownDistances& known, FrontOptions options)
{
  const ReplicatedPatch around(this->part_,
    this->isTargetHere() ? std::vector<Id>{ this->target_.face.id } : std::vector<Id>());
  const SurfacePoint target =
    fromBarycentric(around.mesh(), around.faceAt(this->target_.face), this->target_.weights);
  const Corridor corridor = corridorTo(this->length_, known);
  options.corridor = &corridor;
  NotePassedFaces strip;
  const std::vector<double> back = propagate(this->part_,
    sourceWindowsOfPartition(
      this->part_, around, makeSourceWindows(around.mesh(), { pointCurve(target) })),
    options, strip)
                                     .vertexDistances;
  strip.forEachFace([this](Id face) { this->addOwn(face); });
  if (this->isTargetHere())
  {
    this->addOwn(this->target_.face.id);
  }
  // A path may also run along edges, from vertex to vertex, where no window goes.
  for (Id vertex = 0; vertex < this->part_.numberOfOwnVertices(); ++vertex)
  {
    if ((1.0 - tolerance::BoundMargin) * known.atVertices[vertex] + back[vertex] <= this->length_)
    {
      for (const Id corner : this->part_.mesh().cornersAt(vertex))
      {
        this->addOwn(TriangleMesh::faceOf(corner));
      }
    }
  }
  this->addFacesOfCurves();
  std::sort(this->faces_.begin(), this->faces_.end());
  this->faces_.erase(std::unique(this->faces_.begin(), this->faces_.end()), this->faces_.end());
}

void StripSearch::addFacesOfCurves()
{
  for (const SourceCurve& curve : this->curves_)
  {
    for (const Id face : curve.faces)
    {
      this->addOwn(this->patch_.faceOfPart(face));
    }
    for (const SurfacePoint& point : curve.points)
    {
      forEachFace(this->patch_.mesh(), point,
        [this](Id face) { this->addOwn(this->patch_.faceOfPart(face)); });
    }
  }
}

// A point of the patch on a strip that has the faces around it.
SurfacePoint StripSearch::pointOf(const ReplicatedPatch& strip, SurfacePoint point) const
{
  switch (point.kind)
  {
    case SurfacePoint::Kind::Vertex:
      point.id = strip.vertexAt(this->patch_.globalId(point.id));
      break;
    case SurfacePoint::Kind::Edge:
      point.id =
        3 * strip.faceAt(this->patch_.ownerOf(TriangleMesh::faceOf(point.id))) + point.id % 3;
      break;
    case SurfacePoint::Kind::Face:
      point.id = strip.faceAt(this->patch_.ownerOf(point.id));
      break;
  }
  return point;
}

std::vector<SourceCurve> StripSearch::curvesOn(const ReplicatedPatch& strip) const
{
  std::vector<SourceCurve> curves = this->curves_;
  for (SourceCurve& curve : curves)
  {
    for (SurfacePoint& point : curve.points)
    {
      point = this->pointOf(strip, point);
    }
    for (Id& face : curve.faces)
    {
      face = strip.faceAt(this->patch_.ownerOf(face));
    }
  }
  return curves;
}

// What lies beside the strip only makes it larger: a path through it is one on the surface.
PathInSpace StripSearch::find(const FrontOptions& options) const
{
  const ReplicatedPatch strip(this->part_, this->faces_);
  if (!this->isTargetHere())
  {
    return {};
  }
  const TriangleMesh& mesh = strip.mesh();
  const SurfacePoint target =
    fromBarycentric(mesh, strip.faceAt(this->target_.face), this->target_.weights);
  Corridor corridor;
  corridor.length = this->length_;
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    corridor.lowerBounds.push_back(
      (1.0 - tolerance::BoundMargin) * distanceInSpace(mesh, mesh.point(vertex), target));
  }
  FrontOptions inStrip = options;
  inStrip.corridor = &corridor;
  const std::vector<SourceCurve> curves = this->curvesOn(strip);
  const std::vector<SurfacePoint> points =
    solve(mesh, curves, inStrip, KeepWindows::All).path(target);
  PathInSpace path;
  if (!points.empty())
  {
    const std::vector<SurfacePoint> cleaned = points.size() == 1
      ? std::vector<SurfacePoint>(2, points.front())
      : cleanedPath(mesh, points, points.front(), points.back(), this->target_.distance);
    for (const SurfacePoint& point : cleaned)
    {
      path.points.push_back(position(mesh, point));
    }
    path.source = CurvesInFaces(mesh, curves).sourceAt(cleaned.back());
  }
  return path;
}

} // anonymous namespace

PathInSpace pathInStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const TargetOnRank& target, const KnownDistances& known,
  const ParallelFor& parallelFor, const ProgressCallback& progress)
{
  FrontOptions options;
  options.parallelFor = parallelFor;
  options.progress = progress;
  StripSearch search(part, patch, curves, target);
  search.findWayBack(known, options);
  return search.find(options);
}

}
