// SPDX-License-Identifier: BSD-3-Clause
#include "field/NearestSource.h"

#include "field/NearestSourceOnRanks.h"

#include <algorithm>

namespace geodesic
{

NearestSource::NearestSource(const DistanceField& field, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const Job& job)
  : FootFinder(field, patch, curves)
  , origins_(field.mesh().numberOfVertices())
{
  const MeshPartition& part = field.surface();
  for (const VertexOnCurve& on : this->curvesOnPatch().vertices())
  {
    const Id vertex = part.countedVertex(patch.globalId(on.vertex));
    if (vertex != NoId)
    {
      this->origins_[vertex] = { RayOrigin::pointSide(on.point, false) };
    }
  }
  for (Id vertex = 0; vertex < part.numberOfOwnVertices(); ++vertex)
  {
    job.reachItem(vertex, part.numberOfOwnVertices());
    if (part.isCountedHere(vertex) && field.vertexDistances()[vertex] < Infinity)
    {
      this->follow(vertex);
    }
  }
  this->elsewhere_ = originsElsewhere(this->field(), this->origins_);
}

// Follows the path back from pseudo-source to pseudo-source; all vertices on the way get the origin
// that is found. The way ends at a vertex that another rank counts, and where vertices at one place
// name each other.
void NearestSource::follow(Id vertex)
{
  std::vector<Id> way;
  PathOrigin found = this->origins_[vertex];
  while (!found.origin.isKnown())
  {
    const IncomingSegment piece = incomingSegmentTo(this->field(), SurfacePoint::atVertex(vertex));
    way.push_back(vertex);
    if (this->isFromCurve(piece))
    {
      found = this->originOf(piece);
      break;
    }
    vertex = this->field().surface().countedVertex(piece.origin.vertex());
    if (vertex == NoId)
    {
      found = { piece.origin };
      break;
    }
    found = this->origins_[vertex];
    if (std::find(way.begin(), way.end(), vertex) != way.end())
    {
      break;
    }
  }
  for (const Id passed : way)
  {
    this->origins_[passed] = found;
  }
}

// Whether the piece begins on a curve, not at a pseudo-source.
bool NearestSource::isFromCurve(const IncomingSegment& piece) const
{
  return piece.kind == IncomingSegment::Kind::Corner
    ? this->onCurveAt(piece.origin.vertex()) != nullptr
    : piece.kind != IncomingSegment::Kind::Window || piece.origin.isOnCurve();
}

Foot NearestSource::of(const IncomingSegment& piece)
{
  const PathOrigin path = this->originOf(piece);
  return this->footOf(path.origin.isVertex() ? this->ofVertex(path.origin.vertex()) : path);
}

PathOrigin NearestSource::ofVertex(GlobalId id) const
{
  const Id vertex = this->field().surface().countedVertex(id);
  if (vertex != NoId)
  {
    return this->origins_[vertex];
  }
  const auto found = this->elsewhere_.find(id);
  return found != this->elsewhere_.end() ? found->second : PathOrigin();
}

}
