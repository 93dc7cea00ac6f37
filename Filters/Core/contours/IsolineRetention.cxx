// SPDX-License-Identifier: BSD-3-Clause
#include "contours/IsolineRetention.h"

#include "Tolerance.h"
#include "field/DistanceRange.h"

#include <algorithm>

namespace geodesic
{

IsolineRetention::IsolineRetention(const MeshPartition& surface, const std::vector<double>& values,
  const std::vector<std::uint8_t>& pinned)
  : mesh_(surface.mesh())
  , firstFace_(surface.firstOwnFace())
  , endOfFaces_(surface.endOfOwnFaces())
  , values_(values)
  , pinned_(pinned)
  , reach_(values.back() * (1.0 + tolerance::BoundMargin))
  , marks_(mesh_.numberOfFaces(), 0)
{
}

void IsolineRetention::start(const std::vector<SourceInFace>& sources)
{
  for (const SourceInFace& source : sources)
  {
    this->marks_[source.face] |= HasSource;
  }
}

void IsolineRetention::pass(std::size_t district, const PassedList& list, Id, WindowPool&)
{
  this->passed_[district].push_back(list);
}

bool IsolineRetention::mayHoldValue(Id face, const VertexNumbers& distances, double certain) const
{
  const Triangle& t = this->mesh_.triangle(face);
  const DistanceRange range =
    rangeInFace(this->mesh_.shape(face), { distances(t[0]), distances(t[1]), distances(t[2]) },
      certain, (this->marks_[face] & HasSource) != 0);
  return range.least < Infinity && range.holdsOneOf(this->values_);
}

void IsolineRetention::advance(const FrontState& front)
{
  this->takePassed(front);
  ++this->batch_;
}

// Distances beyond the front may still fall, down to its key. Beyond the reach they are never
// final.
void IsolineRetention::takePassed(const FrontState& front)
{
  const double certain = std::min(front.key, this->reach_);
  for (std::size_t district = 0; district < this->passed_.size(); ++district)
  {
    for (const PassedList& list : this->passed_[district])
    {
      const Id face = TriangleMesh::faceOf(list.halfedge);
      if (this->pinned_[face] || this->mayHoldValue(face, front.distances, certain))
      {
        this->kept_.windows.add(list.halfedge, list.windows.range(), this->batch_);
      }
      else
      {
        this->marks_[face] |= Dropped;
      }
      front.free(list.windows);
    }
    this->passed_[district].clear();
  }
}

void IsolineRetention::finish(const FrontState& front)
{
  this->takePassed(front);
  this->kept_.faces.assign(this->mesh_.numberOfFaces(), 0);
  for (Id face = this->firstFace_; face < this->endOfFaces_; ++face)
  {
    const bool isWhole = (this->marks_[face] & Dropped) == 0;
    this->kept_.faces[face] = isWhole ? 1 : 0;
    if (!isWhole && this->mayHoldValue(face, front.distances, this->reach_))
    {
      this->droppedTooEarly_.push_back(face);
    }
  }
  this->kept_.windows.index(this->mesh_.numberOfHalfedges());
}

}
