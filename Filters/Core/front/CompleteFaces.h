// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CompleteFaces_h
#define geodesic_CompleteFaces_h

#include "front/VertexStates.h"
#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// With a distance limit: which faces have a point within it and have to be complete.
class CompleteFaces
{
public:
  /// Without a limit nothing is kept and every face counts.
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
  /// The faces around an edge that a window within the limit has come to.
  void addAround(Id halfedge);
  bool isNeededAround(Id halfedge) const;
  void addAroundReachedVertices(const VertexStates& vertices);

  /// How far the front must come for the needed faces to be complete: to their farthest corner, or
  /// where the inside counts too, as far as any point of them can be.
  double neededDistance(const VertexStates& vertices, bool inside) const;

  /// Whether some face at each vertex is complete.
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
