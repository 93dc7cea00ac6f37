// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReplicatedPatch_h
#define geodesic_ReplicatedPatch_h

#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// A small part of a surface that ranks have together, as a mesh that is the same on all of them:
/// some faces, all others around their vertices, and all around the vertices of these, so that
/// angles and siblings are those of the whole wherever paths leave points of the former.
class ReplicatedPatch
{
public:
  /// All ranks together gather it.
  ///
  /// \param part of this rank; must outlive this.
  /// \param faces of the part that belong to the patch, owned here; in any order.
  ReplicatedPatch(const MeshPartition& part, const std::vector<Id>& faces);

  /// Its faces stand in the order of the whole, its vertices in that of their numbers in the whole.
  const TriangleMesh& mesh() const { return this->mesh_; }

  /// Where a face is owned, and a vertex's number in the whole.
  const RankAddress& ownerOf(Id face) const { return this->owners_[face]; }
  Id globalId(Id vertex) const { return this->numberInWhole_[vertex]; }
  /// The face of the patch that a face of the whole has become; NoId where it has not.
  Id faceAt(const RankAddress& face) const;
  /// The same of a vertex, by its number in the whole.
  Id vertexAt(Id globalId) const;

  /// Whether an edge of one of the faces asked for is boundary of the whole. The patch has boundary
  /// of its own where it ends.
  bool isGlobalBoundary(Id halfedge) const
  {
    return (this->boundary_[TriangleMesh::faceOf(halfedge)] >> (halfedge % 3) & 1U) != 0;
  }

  /// A face and a vertex of the patch as this rank's part has them; NoId where it has not. Of
  /// vertices only those of faces that this rank owns are looked for.
  Id faceOfPart(Id face) const { return this->faceOfPart_[face]; }
  Id vertexOfPart(Id vertex) const { return this->vertexOfPart_[vertex]; }

private:
  struct Face;

  std::vector<Face> gather(const std::vector<Id>& faces) const;

  const MeshPartition& part_;
  TriangleMesh mesh_;
  std::vector<RankAddress> owners_;
  std::vector<Id> numberInWhole_;
  /// A bit for each halfedge of a face.
  std::vector<std::uint8_t> boundary_;
  std::vector<Id> faceOfPart_;
  std::vector<Id> vertexOfPart_;
};

}

#endif
