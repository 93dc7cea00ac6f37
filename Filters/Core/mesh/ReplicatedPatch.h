// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReplicatedPatch_h
#define geodesic_ReplicatedPatch_h

#include "mesh/MeshPartition.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// A small part of a surface that ranks have together, as a mesh that is the same on all of them:
/// some faces, all others around their vertices, and all around the vertices of these, so that
/// angles and siblings are those of the whole wherever paths leave points of the former.
///
/// In one process the mesh is its own patch, and no table is kept. Copies share the tables.
class ReplicatedPatch
{
public:
  /// In one process: the whole surface.
  ///
  /// \param mesh must outlive this and its copies.
  explicit ReplicatedPatch(const TriangleMesh& mesh)
    : mesh_(&mesh)
  {
  }
  /// All ranks together gather it.
  ///
  /// \param part of this rank.
  /// \param faces of the part that belong to the patch, owned here; in any order.
  ReplicatedPatch(const MeshPartition& part, const std::vector<Id>& faces);

  /// Its faces stand in the order of the whole, its vertices in that of their global numbers.
  const TriangleMesh& mesh() const { return *this->mesh_; }

  /// Where a face is owned, and a vertex's global number.
  RankAddress ownerOf(Id face) const
  {
    return this->tables_ ? this->tables_->owners[face] : RankAddress{ 0, face };
  }
  Id globalId(Id vertex) const { return this->tables_ ? this->tables_->globalIds[vertex] : vertex; }
  /// The face of the patch that a face of the whole has become; NoId where it has not.
  Id faceAt(const RankAddress& face) const;
  /// The same of a vertex, by its global number.
  Id vertexAt(Id globalId) const;

  /// Whether an edge of one of the faces asked for is boundary of the whole. The patch has boundary
  /// of its own where it ends.
  bool isGlobalBoundary(Id halfedge) const
  {
    return this->tables_
      ? (this->tables_->boundary[TriangleMesh::faceOf(halfedge)] >> (halfedge % 3) & 1U) != 0
      : this->mesh_->isBoundary(halfedge);
  }

  /// A face and a vertex of the patch as this rank's part has them; NoId where it has not. Of
  /// vertices only those of faces that this rank owns are looked for.
  Id faceOfPart(Id face) const { return this->tables_ ? this->tables_->faceOfPart[face] : face; }
  Id vertexOfPart(Id vertex) const
  {
    return this->tables_ ? this->tables_->vertexOfPart[vertex] : vertex;
  }

private:
  struct Face;

  struct Tables
  {
    Tables(const MeshPartition& part, const std::vector<Id>& faces);

    TriangleMesh mesh;
    std::vector<RankAddress> owners;
    std::vector<Id> globalIds;
    /// A bit for each halfedge of a face.
    std::vector<std::uint8_t> boundary;
    std::vector<Id> faceOfPart;
    std::vector<Id> vertexOfPart;
  };

  static std::vector<Face> gather(const MeshPartition& part, const std::vector<Id>& faces);

  /// Null in one process.
  std::shared_ptr<const Tables> tables_;
  const TriangleMesh* mesh_;
};

}

#endif
