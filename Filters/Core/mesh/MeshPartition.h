// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MeshPartition_h
#define geodesic_MeshPartition_h

#include "Exchange.h"
#include "mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// A face or a vertex, as it is numbered on one rank.
struct RankAddress
{
  int rank;
  Id id;

  bool operator<(const RankAddress& other) const
  {
    return this->rank != other.rank ? this->rank < other.rank : this->id < other.id;
  }
};

/// One rank's part of a surface that several ranks have together: the faces that it owns, and
/// copies of all others around their vertices (the halo), so that angles, siblings and boundary are
/// those of the whole there. Every face of the whole is owned by exactly one rank.
///
/// Faces stand in the order of the whole, which is by rank. Vertices of faces that are owned come
/// first, with their numbers, then those of the halo only.
class MeshPartition
{
public:
  /// All ranks together make their parts.
  ///
  /// \param points those of this rank, each used by one of its triangles.
  /// \param triangles its faces; none of two ranks' faces on the same vertices are both kept, but
  ///        the lower rank's.
  /// \param keys one a point: points of different ranks are one vertex where their keys are equal,
  ///        and lie where the lowest of these ranks has it. A rank has each key once.
  /// \param exchange must outlive this.
  /// \throws MeshError where the whole has no face, MeshTooLarge; what TriangleMesh throws;
  /// Aborted.
  MeshPartition(std::vector<Vec3> points, std::vector<Triangle> triangles,
    const std::vector<std::uint64_t>& keys, Exchange& exchange,
    const ProgressCallback& progress = {});

  Exchange& exchange() const { return this->exchange_; }
  const TriangleMesh& mesh() const { return this->mesh_; }

  /// The faces that this rank owns are those from the first to before the end.
  Id firstOwnFace() const { return this->firstOwnFace_; }
  Id endOfOwnFaces() const { return this->endOfOwnFaces_; }
  bool isOwn(Id face) const
  {
    return face - this->firstOwnFace_ < this->endOfOwnFaces_ - this->firstOwnFace_;
  }
  /// The face that one of the constructor's triangles has become, or the copy of the face that
  /// stands for it; NoId where it names a vertex twice.
  Id faceOfTriangle(Id triangle) const { return this->faceOfTriangle_[triangle]; }
  /// Vertices below this one are the constructor's points.
  Id numberOfOwnVertices() const { return this->numberOfOwnVertices_; }

  /// Where a face of the halo is owned.
  RankAddress ownerOf(Id face) const
  {
    return this
      ->halo_[face < this->firstOwnFace_ ? face
                                         : face - (this->endOfOwnFaces_ - this->firstOwnFace_)];
  }
  /// The same of any face.
  RankAddress addressOf(Id face) const
  {
    return this->isOwn(face) ? RankAddress{ this->exchange_.rank(), face } : this->ownerOf(face);
  }
  /// The copy in this part's halo of a face that another rank owns; NoId where there is none.
  Id copyOf(const RankAddress& face) const;

  /// The other ranks that have a vertex of this rank in their faces, and its number there, by rank.
  struct Holders
  {
    const RankAddress* first;
    const RankAddress* last;
    const RankAddress* begin() const { return this->first; }
    const RankAddress* end() const { return this->last; }
  };
  Holders othersWith(Id vertex) const
  {
    const RankAddress* data = this->holders_.data();
    return { data + this->firstHolder_[vertex], data + this->firstHolder_[vertex + 1] };
  }
  bool isShared(Id vertex) const
  {
    return this->firstHolder_[vertex] != this->firstHolder_[vertex + 1];
  }
  /// Whether no lower rank has the vertex: it is counted here.
  bool isCountedHere(Id vertex) const
  {
    return !this->isShared(vertex) || this->othersWith(vertex).first->rank > this->exchange_.rank();
  }

  /// The number of a vertex in the whole, the same on all ranks. Those that a rank counts follow
  /// one another, behind those that lower ranks count.
  Id globalId(Id vertex) const { return this->numberInWhole_[vertex]; }
  Id numberOfGlobalVertices() const { return this->verticesOfWhole_; }
  Id numberOfGlobalFaces() const { return this->facesOfWhole_; }

private:
  struct HaloFace;

  void findHolders(const std::vector<std::uint64_t>& keys);
  void numberVertices(std::vector<Vec3>& points);
  std::vector<HaloFace> exchangeHalo(
    const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  void makeMesh(std::vector<Vec3> points, const std::vector<Triangle>& triangles,
    const std::vector<HaloFace>& halo, const ProgressCallback& progress);
  void findFacesOfTriangles(const std::vector<Triangle>& triangles, Id first);
  void exchangeAddresses(const std::vector<HaloFace>& halo);

  Exchange& exchange_;
  TriangleMesh mesh_;
  Id firstOwnFace_ = 0;
  Id endOfOwnFaces_ = 0;
  Id numberOfOwnVertices_ = 0;
  Id verticesOfWhole_ = 0;
  Id facesOfWhole_ = 0;
  /// Ascending within a rank.
  std::vector<RankAddress> halo_;
  std::vector<Id> faceOfTriangle_;
  std::vector<Id> firstHolder_;
  std::vector<RankAddress> holders_;
  std::vector<Id> numberInWhole_;
  /// While it is made: the triangles that each rank has a copy of, in the order of sending.
  std::vector<std::vector<Id>> given_;
};

}

#endif
