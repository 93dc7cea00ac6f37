// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SeamSplits.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

SeamSplits::SeamSplits(const MeshPartition& part, RedGreenMesh& triangles)
  : part_(part)
  , triangles_(triangles)
  , frozen_(part.mesh().numberOfFaces(), 0)
  , messages_(part.exchange().noMessages())
{
  this->shareFrozen();
}

// Sends to the ranks that have a copy of a face: those that have one of its vertices.
void SeamSplits::shareFrozen()
{
  std::vector<Message> messages = this->part_.exchange().noMessages();
  for (Id face = this->part_.firstOwnFace(); face < this->part_.endOfOwnFaces(); ++face)
  {
    this->frozen_[face] = this->triangles_.isFrozen(face) ? 1 : 0;
    for (const Id vertex : this->part_.mesh().triangle(face))
    {
      for (const RankAddress& other : this->part_.othersWith(vertex))
      {
        if (this->frozen_[face] != 0)
        {
          geodesic::put(messages[rankIndex(other.rank)], face);
        }
      }
    }
  }
  readEach(this->part_.exchange().step(std::move(messages)),
    [&](int rank, MessageReader& reader) {
      this->frozen_[this->part_.copyOf({ rank, reader.get<Id>() })] = 1;
    });
}

// Faces are in the order of the ranks, and siblings in the order of the faces. NoId if all are
// frozen.
Id SeamSplits::firstRefinedFaceAt(Id edge) const
{
  Id first = NoId;
  this->triangles_.forEachFaceAt(this->triangles_.edgeData(edge),
    [&](Id face) { first = first == NoId && this->frozen_[face] == 0 ? face : first; });
  return first;
}

bool SeamSplits::isDecidedHere(Id edge) const
{
  return this->part_.isOwn(this->firstRefinedFaceAt(edge));
}

void SeamSplits::ask(Id edge, int round)
{
  const int decider = this->part_.addressOf(this->firstRefinedFaceAt(edge)).rank;
  this->put(this->messages_[rankIndex(decider)], Kind::Request, edge, round);
}

void SeamSplits::tell(Id edge, int round)
{
  int last = this->part_.exchange().rank();
  this->triangles_.forEachFaceAt(this->triangles_.edgeData(edge),
    [&](Id face)
    {
      const int owner = this->part_.addressOf(face).rank;
      if (owner != last && owner != this->part_.exchange().rank())
      {
        Message& message = this->messages_[rankIndex(owner)];
        this->put(message, Kind::Decision, edge, round);
        geodesic::put(message, this->triangles_.placementOf(edge));
      }
      last = owner; // faces of one rank are consecutive
    });
}

SeamSplits::State SeamSplits::exchange(bool tooMany, const Receive& receive)
{
  const bool isQuiet = std::all_of(this->messages_.begin(), this->messages_.end(),
    [](const Message& message) { return message.empty(); });
  std::vector<double> least = { isQuiet ? 1.0 : 0.0, tooMany ? 0.0 : 1.0 };
  const std::vector<Message> received = this->part_.exchange().step(
    std::exchange(this->messages_, this->part_.exchange().noMessages()), least);
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
        const auto decided = reader.get<RedGreenMesh::Placement>();
        receive(edge, entry.round, &decided);
      }
      else
      {
        receive(edge, entry.round, nullptr);
      }
    });
  return least[0] == 0.0 ? State::Going : State::Settled;
}

void SeamSplits::put(Message& message, Kind kind, Id edge, int round) const
{
  std::vector<std::uint8_t> path; // which half, from the edge up to the input edge
  Id ancestor = edge;
  while (this->triangles_.edgeData(ancestor).parent != NoId)
  {
    const Id parent = this->triangles_.edgeData(ancestor).parent;
    path.push_back(this->triangles_.edgeData(parent).halves == ancestor ? 0 : 1);
    ancestor = parent;
  }
  const Id halfedge = this->triangles_.edgeData(ancestor).halfedge;
  const Id face = TriangleMesh::faceOf(halfedge);
  geodesic::put(message,
    Entry{ kind, round, this->part_.addressOf(face), halfedge % 3, static_cast<Id>(path.size()) });
  std::reverse(path.begin(), path.end());
  geodesic::put(message, path.data(), path.size());
}

Id SeamSplits::takeEdge(const Entry& entry, MessageReader& reader)
{
  Id edge = this->triangles_.ensureEdge(this->part_.faceAt(entry.face), entry.halfedge);
  for (Id i = 0; i < entry.depth; ++i)
  {
    edge = this->triangles_.edgeData(edge).halves + reader.get<std::uint8_t>();
  }
  return edge;
}

}
