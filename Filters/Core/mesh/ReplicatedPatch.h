// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReplicatedPatch_h
#define geodesic_ReplicatedPatch_h

#include "mesh/MeshPartition.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// Faces of several ranks as a mesh of their own; or, in one process, the surface's own mesh with
/// its own numbers, without tables. Copies share the tables.
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

/// A small part of a distributed surface as a mesh that is the same on all ranks: the faces asked
/// for, all others around their vertices, and all around the vertices of these. So angles and
/// siblings are those of the whole surface wherever paths leave points of the faces asked for.
/// MeshPartition::faceAt(ownerOf()) is the number of its faces on this rank.
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
};

}

#endif
