// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MeshPartition_h
#define geodesic_MeshPartition_h

#include "Exchange.h"
#include "mesh/TriangleMesh.h"

#include <cstdint>
#include <memory>
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

/// What one rank has of a surface: the faces that it owns and, where several ranks have the surface
/// together, copies of all others around their vertices (the halo), so that angles, siblings and
/// boundary are those of the whole there. Every face of the whole is owned by exactly one rank.
///
/// In one process a mesh is its own partition: all faces are owned, there is no halo, local numbers
/// are the global ones, and no table is kept.
///
/// Faces stand in the order of the whole, which is by rank. Vertices of faces that are owned come
/// first, with their numbers, then those of the halo only. Copies share the tables.
class MeshPartition
{
public:
  /// The whole surface, in one process.
  ///
  /// \param mesh must outlive this and its copies.
  explicit MeshPartition(const TriangleMesh& mesh)
    : mesh_(&mesh)
    , exchange_(&OneRank::instance())
    , endOfOwnFaces_(mesh.numberOfFaces())
  {
  }

  /// All ranks together make their partitions.
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

  /// Whether several ranks have the surface together. Where not, the exchange has nothing to do.
  bool isDistributed() const { return this->tables_ != nullptr; }
  Exchange& exchange() const { return *this->exchange_; }
  const TriangleMesh& mesh() const { return *this->mesh_; }

  /// The faces that this rank owns are those from the first to before the end.
  Id firstOwnFace() const { return this->firstOwnFace_; }
  Id endOfOwnFaces() const { return this->endOfOwnFaces_; }
  bool isOwn(Id face) const
  {
    return face - this->firstOwnFace_ < this->endOfOwnFaces_ - this->firstOwnFace_;
  }
  /// The face that one of the constructor's triangles has become, or the copy of the face that
  /// stands for it; NoId where it names a vertex twice. Distributed only.
  Id faceOfTriangle(Id triangle) const { return this->tables_->faceOfTriangle[triangle]; }
  /// Vertices below this one are the constructor's points.
  Id numberOfOwnVertices() const
  {
    return this->tables_ ? this->tables_->numberOfOwnVertices : this->mesh_->numberOfVertices();
  }

  /// Where a face of the halo is owned.
  RankAddress ownerOf(Id face) const
  {
    return this->tables_
      ->halo[face < this->firstOwnFace_ ? face
                                        : face - (this->endOfOwnFaces_ - this->firstOwnFace_)];
  }
  /// The same of any face.
  RankAddress addressOf(Id face) const
  {
    return this->isOwn(face) ? RankAddress{ this->exchange_->rank(), face } : this->ownerOf(face);
  }
  /// The copy in this rank's halo of a face that another rank owns; NoId where there is none.
  Id copyOf(const RankAddress& face) const;
  /// A face of this rank by its address, whoever owns it; NoId where it is not here.
  Id faceAt(const RankAddress& face) const
  {
    return face.rank == this->exchange_->rank() ? face.id : this->copyOf(face);
  }

  /// The other ranks that have a vertex of this rank in their faces, and its number there, by rank.
  struct Holders
  {
    const RankAddress* first = nullptr;
    const RankAddress* last = nullptr;
    const RankAddress* begin() const { return this->first; }
    const RankAddress* end() const { return this->last; }
  };
  Holders othersWith(Id vertex) const
  {
    return this->tables_ ? this->tables_->othersWith(vertex) : Holders();
  }
  bool isShared(Id vertex) const { return this->tables_ && this->tables_->isShared(vertex); }
  /// Whether no lower rank has the vertex: it is counted here.
  bool isCountedHere(Id vertex) const
  {
    return !this->tables_ || this->tables_->isCountedHere(vertex);
  }

  /// The number of a vertex in the whole, the same on all ranks. Those that a rank counts follow
  /// one another, behind those that lower ranks count.
  Id globalId(Id vertex) const { return this->tables_ ? this->tables_->globalIds[vertex] : vertex; }
  Id numberOfGlobalVertices() const
  {
    return this->tables_ ? this->tables_->numberOfGlobalVertices : this->mesh_->numberOfVertices();
  }
  Id numberOfGlobalFaces() const
  {
    return this->tables_ ? this->tables_->numberOfGlobalFaces : this->mesh_->numberOfFaces();
  }

private:
  struct HaloFace;

  /// What a rank knows of the others.
  struct Tables
  {
    Tables(std::vector<Vec3> points, const std::vector<Triangle>& triangles,
      const std::vector<std::uint64_t>& keys, Exchange& exchange, const ProgressCallback& progress);

    Holders othersWith(Id vertex) const
    {
      const RankAddress* data = this->holders.data();
      return { data + this->firstHolder[vertex], data + this->firstHolder[vertex + 1] };
    }
    bool isShared(Id vertex) const
    {
      return this->firstHolder[vertex] != this->firstHolder[vertex + 1];
    }
    bool isCountedHere(Id vertex) const
    {
      return !this->isShared(vertex) ||
        this->othersWith(vertex).first->rank > this->exchange.rank();
    }

    void findHolders(const std::vector<std::uint64_t>& keys);
    void numberVertices(std::vector<Vec3>& points);
    std::vector<HaloFace> exchangeHalo(
      const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
    void makeMesh(std::vector<Vec3> points, const std::vector<Triangle>& triangles,
      const std::vector<HaloFace>& received, const ProgressCallback& progress);
    void findFacesOfTriangles(const std::vector<Triangle>& triangles, Id first);
    void exchangeAddresses(const std::vector<HaloFace>& received);

    Exchange& exchange;
    TriangleMesh mesh;
    Id firstOwnFace = 0;
    Id endOfOwnFaces = 0;
    Id numberOfOwnVertices = 0;
    Id numberOfGlobalVertices = 0;
    Id numberOfGlobalFaces = 0;
    /// Ascending within a rank.
    std::vector<RankAddress> halo;
    std::vector<Id> faceOfTriangle;
    std::vector<Id> firstHolder;
    std::vector<RankAddress> holders;
    std::vector<Id> globalIds;
    /// While they are made: the triangles that each rank has a copy of, in the order of sending.
    std::vector<std::vector<Id>> given;
  };

  /// Null in one process.
  std::shared_ptr<const Tables> tables_;
  const TriangleMesh* mesh_;
  Exchange* exchange_;
  Id firstOwnFace_ = 0;
  Id endOfOwnFaces_ = 0;
};

}

#endif
