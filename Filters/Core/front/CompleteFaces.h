// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CompleteFaces_h
#define geodesic_CompleteFaces_h

#include "front/VertexStates.h"
#include "mesh/MeshPartition.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// With a distance limit: the faces that contain a point within the limit and therefore must be
/// complete.
class CompleteFaces
{
public:
  /// Without a limit every face counts, and nothing is stored.
  CompleteFaces(const MeshPartition& surface, double limit)
    : surface_(surface)
    , mesh_(surface.mesh())
    , limit_(limit)
    , needed_(limit < Infinity ? surface.mesh().numberOfFaces() : 0, 0)
  {
  }

  bool isLimited() const { return this->limit_ < Infinity; }
  double limit() const { return this->limit_; }

  void add(Id face) { this->needed_[face] = 1; }
  bool isNeeded(Id face) const { return this->needed_[face] != 0; }
  /// Adds the faces around an edge that a window within the limit has reached.
  void addAround(Id halfedge)
  {
    Id around = halfedge;
    do
    {
      this->add(TriangleMesh::faceOf(around));
      around = this->mesh_.nextSibling(around);
    } while (around != halfedge);
  }

  bool isNeededAround(Id halfedge) const
  {
    bool isNeeded = true;
    Id around = halfedge;
    do
    {
      isNeeded = isNeeded && this->isNeeded(TriangleMesh::faceOf(around));
      around = this->mesh_.nextSibling(around);
    } while (around != halfedge);
    return isNeeded;
  }

  void addAroundReachedVertices(const VertexStates& vertices)
  {
    for (Id face = this->surface_.firstOwnFace(); face < this->surface_.endOfOwnFaces(); ++face)
    {
      for (const Id vertex : this->mesh_.triangle(face))
      {
        if (vertices.distance(vertex) <= this->limit_)
        {
          this->add(face);
        }
      }
    }
  }

  /// How far the front must come to complete the needed faces: to their farthest corner, or, if
  /// their inside counts too, to the largest distance that a point of them can have.
  double neededDistance(const VertexStates& vertices, bool inside) const
  {
    double bound = 0.0;
    for (Id face = this->surface_.firstOwnFace(); face < this->surface_.endOfOwnFaces(); ++face)
    {
      if (this->needed_[face])
      {
        const Triangle& t = this->mesh_.triangle(face);
        const auto [least, most] = std::minmax(
          { vertices.distance(t[0]), vertices.distance(t[1]), vertices.distance(t[2]) });
        const double mostInside = least + this->mesh_.shape(face).longest();
        bound = std::max(bound, inside ? mostInside : most);
      }
    }
    return bound;
  }

  /// For each vertex, whether one of its faces is complete.
  std::vector<std::uint8_t> completeVertices() const
  {
    std::vector<std::uint8_t> complete(this->mesh_.numberOfVertices(), 0);
    for (Id face = this->surface_.firstOwnFace(); face < this->surface_.endOfOwnFaces(); ++face)
    {
      for (const Id vertex : this->mesh_.triangle(face))
      {
        complete[vertex] |= this->needed_[face];
      }
    }
    return complete;
  }

  std::vector<std::uint8_t> release() { return std::move(this->needed_); }

private:
  const MeshPartition& surface_;
  const TriangleMesh& mesh_;
  double limit_;
  std::vector<std::uint8_t> needed_;
};

}

#endif
