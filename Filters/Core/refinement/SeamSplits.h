// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamSplits_h
#define geodesic_SeamSplits_h

#include "mesh/MeshPartition.h"
#include "refinement/RedGreenMesh.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// What ranks that refine their parts of a surface tell each other about splits of the edges that
/// faces of several ranks share.
///
/// One rank decides where such an edge is split, and all its halves in turn: the lowest that owns a
/// face there that is refined. It tells the others where, and the distance there, so that points on
/// seams are the same on all ranks, bit for bit. Others that need a split ask for it. The decider
/// never refuses, and waits for nobody to split an edge, so that nobody waits for ever.
class SeamSplits
{
public:
  /// All ranks call together.
  ///
  /// \param part, triangles must outlive this; the faces of other ranks are frozen in `triangles`.
  SeamSplits(const MeshPartition& part, RedGreenMesh& triangles);

  /// Whether this rank decides about an edge.
  bool isDecidedHere(Id edge) const;
  /// Asks the rank that decides about an edge to split it.
  ///
  /// \param round of the closure in which it is split (RedGreenClosure::close).
  void ask(Id edge, int round);
  /// Tells the other ranks that have an edge that this one, which decides, has split it.
  void tell(Id edge, int round);

  enum class State
  {
    /// No rank had anything to say.
    Settled,
    Going,
    /// One has more triangles than it can have. What was asked and told is lost.
    TooMany
  };
  /// All ranks together tell what they have to. Calls decided(edge, round, placement) for each
  /// split that another rank has decided, asked(edge, round) for each that others ask for, and that
  /// may have been made since: by rank, and in the order in which they were told.
  ///
  /// \param tooMany whether this rank has too many triangles.
  template <typename Decided, typename Asked>
  State exchange(bool tooMany, Decided&& decided, Asked&& asked);

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
    /// How many times it is halved.
    Id depth;
  };

  void shareFrozen();
  Id firstRefinedFaceAt(Id halfedge) const;
  int ownerOf(Id face) const;
  void put(Message& message, Kind kind, Id edge, int round) const;
  Id takeEdge(const Entry& entry, MessageReader& reader);
  std::vector<Message> takeMessages();

  const MeshPartition& part_;
  RedGreenMesh& triangles_;
  /// Whether each face is frozen where it is owned.
  std::vector<std::uint8_t> frozen_;
  std::vector<Message> messages_;
};

template <typename Decided, typename Asked>
SeamSplits::State SeamSplits::exchange(bool tooMany, Decided&& decided, Asked&& asked)
{
  bool isQuiet = true;
  for (const Message& message : this->messages_)
  {
    isQuiet = isQuiet && message.empty();
  }
  std::vector<double> least = { isQuiet ? 1.0 : 0.0, tooMany ? 0.0 : 1.0 };
  const std::vector<Message> received = this->part_.exchange().step(this->takeMessages(), least);
  if (least[1] == 0.0)
  {
    return State::TooMany;
  }
  readEach(received,
    [&](int, MessageReader& reader)
    {
      const auto entry = reader.get<Entry>();
      const Id edge = this->takeEdge(entry, reader);
      if (entry.kind == Kind::Decision)
      {
        decided(edge, entry.round, reader.get<RedGreenMesh::Placement>());
      }
      else
      {
        asked(edge, entry.round);
      }
    });
  return least[0] == 0.0 ? State::Going : State::Settled;
}

}

#endif
