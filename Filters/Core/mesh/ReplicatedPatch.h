// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReplicatedPatch_h
#define geodesic_ReplicatedPatch_h

#include "mesh/GatheredFaces.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// A small part of a distributed surface as a mesh that is the same on all ranks: some faces, all
/// others around their vertices, and all around the vertices of these. So angles and siblings are
/// those of the whole surface wherever paths leave points of the first faces.
///
/// In one process the mesh is its own patch, and there are no tables. Copies share the tables.
class ReplicatedPatch
{
public:
  /// The whole surface, in one process.
  ///
  /// \param mesh must outlive this and its copies.
  explicit ReplicatedPatch(const TriangleMesh& mesh)
    : mesh_(&mesh)
  {
  }
  /// A collective call of all ranks that gathers the patch. In one process it is the whole surface.
  ///
  /// \param part this rank's partition; in one process its mesh must outlive this and its copies.
  /// \param faces faces of the patch that this rank owns, in any order.
  ReplicatedPatch(const MeshPartition& part, const std::vector<Id>& faces);

  /// Faces are in global order, vertices in the order of their global ids.
  const TriangleMesh& mesh() const { return *this->mesh_; }

  /// The owner of a face, and a vertex's global id.
  RankAddress ownerOf(Id face) const
  {
    return this->tables_ ? this->tables_->faces.ownerOf(face) : RankAddress{ 0, face };
  }
  Id globalId(Id vertex) const
  {
    return this->tables_ ? this->tables_->faces.globalId(vertex) : vertex;
  }
  /// The face of the patch that a face of the whole has become; NoId where it has not.
  Id faceAt(const RankAddress& face) const
  {
    return this->tables_ ? this->tables_->faces.faceAt(face) : face.id;
  }
  /// The same of a vertex, by its global number.
  Id vertexAt(Id globalId) const
  {
    return this->tables_ ? this->tables_->faces.vertexAt(globalId) : globalId;
  }

  /// Whether an edge of one of the first faces is on the boundary of the whole surface. The patch
  /// has a boundary of its own where it ends.
  bool isGlobalBoundary(Id halfedge) const
  {
    return this->tables_
      ? (this->tables_->boundary[TriangleMesh::faceOf(halfedge)] >> (halfedge % 3) & 1U) != 0
      : this->mesh_->isBoundary(halfedge);
  }

  /// The number of the patch's face or vertex in this rank's partition; NoId if the partition does
  /// not have it. Vertices are found only on faces that this rank owns.
  Id faceOfPart(Id face) const { return this->tables_ ? this->tables_->faceOfPart[face] : face; }
  Id vertexOfPart(Id vertex) const
  {
    return this->tables_ ? this->tables_->vertexOfPart[vertex] : vertex;
  }

private:
  struct Tables
  {
    Tables(const MeshPartition& part, const std::vector<Id>& asked);

    /// A bit for each halfedge of a face.
    std::vector<std::uint8_t> boundary;
    GatheredFaces faces;
    std::vector<Id> faceOfPart;
    std::vector<Id> vertexOfPart;
  };

  /// Null in one process.
  std::shared_ptr<const Tables> tables_;
  const TriangleMesh* mesh_;
};

}

#endif
