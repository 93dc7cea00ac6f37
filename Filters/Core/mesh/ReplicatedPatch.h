// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReplicatedPatch_h
#define geodesic_ReplicatedPatch_h

#include "mesh/MeshPartition.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// Faces of several ranks as a mesh of their own. In one process it may be the whole surface: then
/// numbers are the surface's own, and there are no tables. Copies share the tables.
class GatheredFaces
{
public:
  /// The whole surface, in one process.
  ///
  /// \param mesh must outlive this and its copies.
  explicit GatheredFaces(const TriangleMesh& mesh)
    : mesh_(&mesh)
  {
  }
  /// \param faces in any order, maybe repeatedly; maybe none.
  explicit GatheredFaces(std::vector<SentFace> faces);

  /// Its faces are in global order, its vertices in the order of their global ids. Empty where
  /// there are no faces.
  const TriangleMesh& mesh() const { return *this->mesh_; }

  /// The owner of a face, and a vertex's global id.
  RankAddress ownerOf(Id face) const
  {
    return this->tables_ ? this->tables_->owners[face] : RankAddress{ 0, face };
  }
  GlobalId globalId(Id vertex) const
  {
    return this->tables_ ? this->tables_->globalIds[vertex] : GlobalId{ vertex };
  }
  /// A face by its address, and a vertex by its global id; NoId if the patch does not have it.
  Id faceAt(const RankAddress& face) const;
  Id vertexAt(GlobalId id) const;

private:
  struct Tables
  {
    std::vector<RankAddress> owners;
    std::vector<GlobalId> globalIds;
    TriangleMesh mesh;
  };

  std::shared_ptr<const Tables> tables_;
  const TriangleMesh* mesh_;
};

/// A small part of a distributed surface as a mesh that is the same on all ranks: some faces, all
/// others around their vertices, and all around the vertices of these. So angles and siblings are
/// those of the whole surface wherever paths leave points of the first faces.
///
/// In one process the mesh is its own patch.
class ReplicatedPatch : public GatheredFaces
{
public:
  /// The whole surface, in one process.
  explicit ReplicatedPatch(const TriangleMesh& mesh)
    : GatheredFaces(mesh)
  {
  }
  /// A collective call of all ranks that gathers the patch. In one process it is the whole surface.
  ///
  /// \param part this rank's partition; in one process its mesh must outlive this and its copies.
  /// \param faces faces of the patch that this rank owns, in any order.
  ReplicatedPatch(const MeshPartition& part, const std::vector<Id>& faces);

  /// The faces of the mesh that were gathered: all of them, but in one process those that were
  /// asked for.
  const std::vector<Id>& faces() const { return this->faces_; }

  /// Whether an edge of one of the first faces is on the boundary of the whole surface. The patch
  /// has a boundary of its own where it ends.
  bool isGlobalBoundary(Id halfedge) const
  {
    const Id k = TriangleMesh::indexInFace(halfedge);
    return this->onThisRank_
      ? (this->onThisRank_->boundary[TriangleMesh::faceOf(halfedge)] >> k & 1U) != 0
      : this->mesh().isBoundary(halfedge);
  }

  /// The number of the patch's face or vertex in this rank's partition; NoId if the partition does
  /// not have it. Vertices are found only if they are this rank's own points.
  Id faceOfPart(Id face) const
  {
    return this->onThisRank_ ? this->onThisRank_->faceOfPart[face] : face;
  }
  Id vertexOfPart(Id vertex) const
  {
    return this->onThisRank_ ? this->onThisRank_->vertexOfPart[vertex] : vertex;
  }

private:
  /// What this rank knows of the patch.
  struct OnThisRank
  {
    /// A bit for each halfedge of a face.
    std::vector<std::uint8_t> boundary;
    std::vector<Id> faceOfPart;
    std::vector<Id> vertexOfPart;
  };

  /// Null in one process.
  std::shared_ptr<const OnThisRank> onThisRank_;
  std::vector<Id> faces_;
};

}

#endif
