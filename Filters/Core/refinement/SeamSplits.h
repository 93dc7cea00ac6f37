// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamSplits_h
#define geodesic_SeamSplits_h

#include "mesh/MeshPartition.h"
#include "refinement/RedGreenMesh.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace geodesic
{

/// The messages between ranks about splits of edges that faces of several ranks share.
///
/// One rank decides where such an edge, and in turn each of its halves, is split: the lowest rank
/// that owns a refined face there. It tells the others the place and the distance there, so that
/// points on seams are the same on all ranks, bit for bit. Other ranks ask it for the splits that
/// they need. The deciding rank never refuses and never waits for another rank to split an edge, so
/// there is no deadlock.
class SeamSplits
{
public:
  /// A collective call of all ranks.
  ///
  /// \param part, triangles must outlive this; the faces of other ranks are frozen in `triangles`.
  SeamSplits(const MeshPartition& part, RedGreenMesh& triangles);

  /// Whether this rank decides about an edge.
  bool isDecidedHere(Id edge) const;
  /// Asks the deciding rank to split an edge.
  ///
  /// \param round of the closure that needs the split (RedGreenClosure::close).
  void ask(Id edge, int round);
  /// Tells the other ranks that have an edge that this rank, which decides, has split it.
  void tell(Id edge, int round);

  enum class State
  {
    /// No rank sent anything.
    Settled,
    Going,
    /// A rank exceeds its number of triangles. All requests and decisions are lost.
    TooMany
  };
  /// Called with each split that another rank has decided, and with each that another rank asks
  /// for, even if it has been made since: then `decided` is null.
  using Receive = std::function<void(Id edge, int round, const RedGreenMesh::Placement* decided)>;
  /// A collective call of all ranks, which delivers requests and decisions: by rank, in the order
  /// of sending.
  ///
  /// \param tooMany whether this rank has too many triangles.
  State exchange(bool tooMany, const Receive& receive);

private:
  enum class Kind : std::uint32_t
  {
    Decision,
    Request
  };
  struct Entry
  {
    Kind kind;
    int round;
    /// The input edge: the face with its lowest halfedge, which all ranks that own a face at the
    /// edge have, and the halfedge's number there.
    RankAddress face;
    Id halfedge;
    /// How often it is halved.
    Id depth;
  };

  void shareFrozen();
  Id firstRefinedFaceAt(Id edge) const;
  void put(Message& message, Kind kind, Id edge, int round) const;
  Id takeEdge(const Entry& entry, MessageReader& reader);

  const MeshPartition& part_;
  RedGreenMesh& triangles_;
  /// Whether each face is frozen on the rank that owns it.
  std::vector<std::uint8_t> frozen_;
  std::vector<Message> messages_;
};

}

#endif
