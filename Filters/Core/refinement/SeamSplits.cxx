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
    if (this->frozen_[face] == 0)
    {
      continue;
    }
    std::vector<int> receivers;
    for (const Id vertex : this->part_.mesh().triangle(face))
    {
      for (const RankAddress& other : this->part_.othersWith(vertex))
      {
        if (std::find(receivers.begin(), receivers.end(), other.rank) == receivers.end())
        {
          receivers.push_back(other.rank);
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
  Id halfedge = edge;
  do
  {
    const Id face = TriangleMesh::faceOf(halfedge);
    if (this->frozen_[face] == 0)
    {
      return face;
    }
    halfedge = this->part_.mesh().nextSibling(halfedge);
  } while (halfedge != edge);
  return NoId;
}

bool SeamSplits::isDecidedHere(Id edge) const
{
  const Id halfedge = this->triangles_.edgeData(edge).halfedge;
  return halfedge == NoId || this->part_.isOwn(this->firstRefinedFaceAt(halfedge));
}

void SeamSplits::ask(Id edge, int round)
{
  const Id halfedge = this->triangles_.edgeData(edge).halfedge;
  const int decider = this->part_.addressOf(this->firstRefinedFaceAt(halfedge)).rank;
  this->put(this->messages_[rankIndex(decider)], Kind::Request, edge, round);
}

void SeamSplits::tell(Id edge, int round)
{
  const RedGreenMesh::Edge& split = this->triangles_.edgeData(edge);
  if (split.halfedge == NoId)
  {
    return;
  }
  int last = this->part_.exchange().rank();
  Id halfedge = split.halfedge;
  do
  {
    const int owner = this->part_.addressOf(TriangleMesh::faceOf(halfedge)).rank;
    if (owner != last && owner != this->part_.exchange().rank())
    {
      Message& message = this->messages_[rankIndex(owner)];
      this->put(message, Kind::Decision, edge, round);
      geodesic::put(message, this->triangles_.placementOf(edge));
    }
    last = owner; // faces of one rank are consecutive
    halfedge = this->part_.mesh().nextSibling(halfedge);
  } while (halfedge != split.halfedge);
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
