// SPDX-License-Identifier: BSD-3-Clause
#include "field/RetentionAround.h"

#include "Tolerance.h"
#include "mesh/HalfedgeFrame.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

RetentionAround::RetentionAround(
  const TriangleMesh& mesh, std::vector<SurfacePoint> targets, double limit, std::vector<Id> sets)
  : KeepFaces(mesh, std::vector<std::uint8_t>(mesh.numberOfFaces(), 0))
  , targets_(std::move(targets))
  , sets_(std::move(sets))
  , limit_((1.0 + tolerance::Tie) * limit)
  , neededDistance_(this->limit_)
{
  for (SurfacePoint& target : this->targets_)
  {
    target = normalized(mesh, target);
    if (target.kind != SurfacePoint::Kind::Vertex)
    {
      forEachFace(mesh, target, [this](Id face) { this->keep(face); });
    }
  }
}

void RetentionAround::keepForPaths(const MeshPartition& part)
{
  const bool hasSome = this->mesh().numberOfNonManifoldEdges() > 0;
  for (Id halfedge = 0; hasSome && halfedge < this->mesh().numberOfHalfedges(); ++halfedge)
  {
    if (!this->mesh().isBoundary(halfedge) && !this->mesh().isInner(halfedge))
    {
      this->keep(TriangleMesh::faceOf(halfedge));
    }
  }
  std::vector<Id> atEdges;
  for (const SurfacePoint& target : this->targets_)
  {
    if (target.kind == SurfacePoint::Kind::Edge)
    {
      forEachFace(this->mesh(), target, [&](Id face) { atEdges.push_back(face); });
    }
  }
  for (const Id face : part.sendToOwners(atEdges))
  {
    this->keep(face);
  }
}

double RetentionAround::upperBound(const SurfacePoint& target, const VertexNumbers& distances) const
{
  if (target.kind == SurfacePoint::Kind::Vertex)
  {
    return distances(target.id);
  }
  double least = Infinity;
  forEachFace(this->mesh(), target,
    [&](Id face)
    {
      const Barycentric weights = barycentric(this->mesh(), target, face);
      for (std::size_t k = 0; k < 3; ++k)
      {
        least = std::min(least,
          distances(this->mesh().triangle(face)[k]) +
            distanceInFace(this->mesh(), face, cornerWeights(k), weights));
      }
    });
  return least;
}

/// \param target the first one of the set; becomes that of the next set.
double RetentionAround::upperBoundOfSet(std::size_t& target, const VertexNumbers& distances) const
{
  const std::size_t first = target;
  double least = Infinity;
  do
  {
    least = std::min(least, this->upperBound(this->targets_[target++], distances));
  } while (target < this->sets_.size() && this->sets_[target] == this->sets_[first]);
  return least;
}

// Bounds fall as the front approaches; they are computed again halfway.
void RetentionAround::advance(const FrontState& front)
{
  for (std::size_t next = this->seen_;
       next < this->targets_.size() && this->upperBoundOfSet(next, front.distances) < Infinity;)
  {
    this->seen_ = next;
  }
  if (this->seen_ < this->targets_.size() || front.key < this->nextLook_)
  {
    return;
  }
  double farthest = 0.0;
  for (std::size_t target = 0; target < this->targets_.size();)
  {
    farthest = std::max(farthest, this->upperBoundOfSet(target, front.distances));
  }
  this->neededDistance_ = std::min((1.0 + tolerance::Tie) * farthest, this->limit_);
  this->nextLook_ = front.key + 0.5 * std::max(0.0, this->neededDistance_ - front.key);
}

}
