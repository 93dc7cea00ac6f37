// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MeshPartition_h
#define geodesic_MeshPartition_h

#include "Exchange.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace geodesic
{

/// A face or a vertex with its number on one rank.
struct RankAddress
{
  int rank;
  Id id;

  bool operator<(const RankAddress& other) const
  {
    return this->rank != other.rank ? this->rank < other.rank : this->id < other.id;
  }
};

/// The index of a value in an ascending list; NoId where it is not there.
template <typename Value>
Id indexIn(const std::vector<Value>& values, const Value& value)
{
  const auto found = std::lower_bound(values.begin(), values.end(), value);
  return found == values.end() || value < *found ? NoId : static_cast<Id>(found - values.begin());
}

/// A face as one rank sends it to another.
struct SentFace
{
  RankAddress owner;
  GlobalTriangle vertices;
  /// Where the vertices lie.
  std::array<Vec3, 3> points;

  bool operator<(const SentFace& other) const { return this->owner < other.owner; }
};

/// One rank's part of a surface: the faces that it owns and, if several ranks share the surface,
/// copies of all other faces around their vertices (the halo), so that angles, siblings and
/// boundary there are those of the whole surface. Exactly one rank owns each face.
///
/// In one process a mesh is its own partition: it owns all faces, has no halo, local ids are global
/// ones, and there are no tables.
///
/// Faces are in global order, which is by rank. Vertices of owned faces come first, in the order of
/// their ids, then those of the halo only. Copies share the tables.
class MeshPartition
{
public:
  /// The whole surface, in one process.
  ///
  /// \param mesh must outlive this and its copies.
  explicit MeshPartition(const TriangleMesh& mesh)
    : mesh_(std::shared_ptr<const TriangleMesh>(), &mesh) // which it does not own
    , exchange_(&OneRank::instance())
    , endOfOwnFaces_(mesh.numberOfFaces())
  {
  }

  /// A collective call of all ranks. A single rank gets the whole surface.
  ///
  /// \param points this rank's points, each used by one of its triangles.
  /// \param triangles its faces. If faces of two ranks have the same vertices, only the lower
  ///        rank's is kept.
  /// \param keys one per point: points of different ranks with equal keys are one vertex, at the
  ///        coordinates that the lowest of these ranks has. The keys of one rank are distinct. A
  ///        single rank needs none.
  /// \param exchange must outlive this.
  /// \throws MeshError if the whole surface has no face, MeshTooLarge; errors of TriangleMesh;
  /// Aborted.
  MeshPartition(std::vector<Vec3> points, const std::vector<Triangle>& triangles,
    const std::vector<std::uint64_t>& keys, Exchange& exchange, const Job& job = {});

  /// Whether several ranks share the surface. If not, the exchange is trivial.
  bool isDistributed() const { return this->tables_ != nullptr; }
  Exchange& exchange() const { return *this->exchange_; }
  const TriangleMesh& mesh() const { return *this->mesh_; }

  /// This rank owns the faces from the first to before the end.
  Id firstOwnFace() const { return this->firstOwnFace_; }
  Id endOfOwnFaces() const { return this->endOfOwnFaces_; }
  /// For each face, whether this rank owns it; empty if it owns all.
  std::vector<std::uint8_t> ownFaces() const;
  bool isOwn(Id face) const
  {
    return face - this->firstOwnFace_ < this->endOfOwnFaces_ - this->firstOwnFace_;
  }
  /// The constructor's triangle that an owned face was made of.
  Id triangleOf(Id face) const
  {
    return this->mesh_->inputFace(face) - (this->tables_ ? this->tables_->firstTriangle : 0);
  }
  /// Vertices below this one are the constructor's points.
  Id numberOfOwnVertices() const
  {
    return this->tables_ ? this->tables_->numberOfOwnVertices : this->mesh_->numberOfVertices();
  }

  /// The owner of a face, of the halo or not, and its number there.
  RankAddress addressOf(Id face) const
  {
    return this->isOwn(face)
      ? RankAddress{ this->exchange_->rank(), face }
      : this->tables_
          ->halo[face < this->firstOwnFace_ ? face
                                            : face - (this->endOfOwnFaces_ - this->firstOwnFace_)];
  }
  /// A face by its address, owned by any rank; NoId if this rank has no copy of it.
  Id faceAt(const RankAddress& face) const;

  /// Sends faces of this rank, maybe of its halo, to their owners. All ranks call this together.
  ///
  /// \returns the faces that this rank owns among those of all ranks, maybe repeatedly. In one
  ///          process the faces themselves.
  std::vector<Id> sendToOwners(const std::vector<Id>& faces) const;

  /// The other ranks whose faces have a vertex of this rank, and its number there, by rank.
  using Holders = ArrayRange<RankAddress>;
  Holders othersWith(Id vertex) const
  {
    return this->tables_ ? this->tables_->othersWith(vertex) : Holders();
  }
  /// The other ranks that own faces at an edge, ascending.
  std::vector<int> otherRanksAt(Id halfedge) const;
  /// The global id of a vertex, the same on all ranks. The ids of the vertices that a rank counts
  /// are consecutive and follow those of lower ranks.
  GlobalId globalId(Id vertex) const
  {
    return this->tables_ ? this->tables_->globalIds[vertex] : GlobalId{ vertex };
  }
  Id numberOfGlobalVertices() const
  {
    return this->tables_ ? this->tables_->numberOfGlobalVertices : this->mesh_->numberOfVertices();
  }
  Id numberOfGlobalFaces() const
  {
    return this->tables_ ? this->tables_->numberOfGlobalFaces : this->mesh_->numberOfFaces();
  }
  /// The number of a face that this rank owns among those of all ranks.
  Id globalFace(Id face) const
  {
    return this->tables_ ? face - this->firstOwnFace_ + this->tables_->firstGlobalFace : face;
  }
  /// The rank that counts a vertex: the lowest one that has it.
  int rankCounting(GlobalId id) const;
  /// The vertex with this global id if this rank counts it, else NoId.
  Id countedVertex(GlobalId id) const;
  bool isCountedHere(Id vertex) const
  {
    return this->countedVertex(this->globalId(vertex)) == vertex;
  }

  GlobalTriangle globalIds(const Triangle& vertices) const
  {
    const auto& [a, b, c] = vertices;
    return { this->globalId(a), this->globalId(b), this->globalId(c) };
  }
  SentFace sentFace(Id face) const;

private:
  /// What a rank knows of the other ranks.
  struct Tables
  {
    Holders othersWith(Id vertex) const
    {
      const RankAddress* data = this->holders.data();
      return { data + this->firstHolder[vertex], data + this->firstHolder[vertex + 1] };
    }

    TriangleMesh mesh;
    Id firstTriangle = 0;
    Id firstOwnFace = 0;
    Id endOfOwnFaces = 0;
    Id numberOfOwnVertices = 0;
    Id numberOfGlobalVertices = 0;
    Id firstGlobalFace = 0;
    Id numberOfGlobalFaces = 0;
    /// Ascending within a rank.
    std::vector<RankAddress> halo;
    std::vector<Id> firstHolder;
    std::vector<RankAddress> holders;
    std::vector<GlobalId> globalIds;
    /// The vertices that this rank counts, in the order of their global ids.
    std::vector<Id> counted;
    /// The global id of the first vertex that each rank counts.
    std::vector<GlobalId> firstOfRank;
  };
  class TablesBuilder;

  /// Null in one process.
  std::shared_ptr<const Tables> tables_;
  std::shared_ptr<const TriangleMesh> mesh_;
  Exchange* exchange_;
  Id firstOwnFace_ = 0;
  Id endOfOwnFaces_ = 0;
};

}

#endif
