// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GlobalFaces_h
#define geodesic_GlobalFaces_h

#include "PolyData/reading/PolyDataSurface.h"

#include <vector>

namespace geodesic
{

/// A face of the mesh of the whole surface, and the global numbers of the vertices at its corners.
struct GlobalFace
{
  RankAddress address{ -1, NoId };
  Triangle vertices{ NoId, NoId, NoId };

  bool isThere() const { return this->address.id != NoId; }
  /// Which of its corners is at a vertex; 3 if none is.
  Id cornerAt(Id vertex) const;
  /// Which of its edges has these vertices.
  Id edgeBetween(Id a, Id b) const;
};

/// Finds the faces, of any rank, at vertices of this rank's points.
class GlobalFaces
{
public:
  /// All ranks call together, as for find().
  explicit GlobalFaces(const PolyDataSurface& surface);

  /// Calls visit(k, edge as find() takes it) for each edge k of a triangle whose ends have faces.
  template <typename Visit>
  void forEachEdgeWithFaces(const Triangle& t, Visit&& visit) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id next = t[(k + 1) % 3];
      if (this->hasFace(t[k]) && this->hasFace(next))
      {
        visit(k, Triangle{ t[k], next, next });
      }
    }
  }

  /// For each three vertices a face that has all of them. Of several faces at an edge one that this
  /// rank owns, if there is one.
  std::vector<GlobalFace> find(const std::vector<Triangle>& vertices) const;

  /// Of a vertex that PolyDataSurface::vertexOf() names: RemoteVertex::globalId, or that of the
  /// mesh, where it lies, and whether it has a face.
  Id globalId(Id vertex) const
  {
    return this->isRemote(vertex) ? this->remote(vertex).globalId : this->surface_.globalId(vertex);
  }
  Triangle globalIds(const Triangle& vertices) const
  {
    return { this->globalId(vertices[0]), this->globalId(vertices[1]),
      this->globalId(vertices[2]) };
  }
  const Vec3& position(Id vertex) const
  {
    return this->isRemote(vertex) ? this->remote(vertex).position
                                  : this->surface_.mesh().point(vertex);
  }
  bool hasFace(Id vertex) const
  {
    return this->isRemote(vertex) ? this->remote(vertex).holder.id != NoId
                                  : this->surface_.mesh().cornersAt(vertex).size() > 0;
  }

private:
  bool isRemote(Id vertex) const { return vertex >= this->surface_.mesh().numberOfVertices(); }
  const RemoteVertex& remote(Id vertex) const
  {
    return this->remote_[vertex - this->surface_.mesh().numberOfVertices()];
  }
  GlobalFace findAround(Id vertex, const Triangle& wanted) const;

  const MeshPartition& surface_;
  std::vector<RemoteVertex> remote_;
};

}

#endif
