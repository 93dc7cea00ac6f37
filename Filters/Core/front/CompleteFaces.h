// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CompleteFaces_h
#define geodesic_CompleteFaces_h

#include "front/VertexStates.h"
#include "mesh/MeshPartition.h"

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
    : mesh_(surface.mesh())
    , firstFace_(surface.firstOwnFace())
    , endOfFaces_(surface.endOfOwnFaces())
    , limit_(limit)
    , needed_(limit < Infinity ? surface.mesh().numberOfFaces() : 0, 0)
  {
  }

  bool isLimited() const { return this->limit_ < Infinity; }
  double limit() const { return this->limit_; }
  bool isWithin(const Window& window) const { return window.minimum() <= this->limit_; }

  void add(Id face) { this->needed_[face] = 1; }
  bool isNeeded(Id face) const { return this->needed_[face] != 0; }
  /// Adds the faces around an edge that a window within the limit has reached.
  void addAround(Id halfedge);
  bool isNeededAround(Id halfedge) const;
  void addAroundReachedVertices(const VertexStates& vertices);

  /// How far the front must come to complete the needed faces: to their farthest corner, or, if
  /// their inside counts too, to the largest distance that a point of them can have.
  double neededDistance(const VertexStates& vertices, bool inside) const;

  /// For each vertex, whether one of its faces is complete.
  std::vector<std::uint8_t> completeVertices() const;

  std::vector<std::uint8_t> release() { return std::move(this->needed_); }

private:
  const TriangleMesh& mesh_;
  Id firstFace_;
  Id endOfFaces_;
  double limit_;
  std::vector<std::uint8_t> needed_;
};

}

#endif
