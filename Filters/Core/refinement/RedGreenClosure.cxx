// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RedGreenClosure.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

// Leaves out triangles that are no leaves any more, and puts the others in order, each once.
void keepLeaves(const RedGreenMesh& mesh, std::vector<Id>& triangles)
{
  const auto isNoLeaf = [&mesh](Id triangle) { return !mesh.isLeaf(triangle); };
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), isNoLeaf), triangles.end());
}

} // anonymous namespace

RedGreenClosure::RedGreenClosure(const MeshPartition& part, RedGreenMesh& mesh, SplitRules& rules)
  : part_(part)
  , mesh_(mesh)
  , rules_(rules)
  , frozen_(part.mesh().numberOfFaces(), 0)
  , messages_(part.exchange().noMessages())
{
  // Each rank tells those that have a copy of a frozen face: those that have one of its vertices.
  std::vector<Message> messages = this->part_.exchange().noMessages();
  for (Id face = this->part_.firstOwnFace(); face < this->part_.endOfOwnFaces(); ++face)
  {
    if (!this->mesh_.isFrozen(face))
    {
      continue;
    }
    this->frozen_[face] = 1;
    for (const Id vertex : this->part_.mesh().triangle(face))
    {
      for (const RankAddress& other : this->part_.othersWith(vertex))
      {
        put(messages[rankIndex(other.rank)], face);
      }
    }
  }
  readEach(this->part_.exchange().step(std::move(messages)),
    [&](int rank, MessageReader& reader) {
      this->frozen_[this->part_.copyOf({ rank, reader.get<Id>() })] = 1;
    });
}

bool RedGreenClosure::split(Id edge)
{
  const Id face = this->firstRefinedFaceAt(edge);
  if (!this->part_.isOwn(face))
  {
    this->send(this->part_.ownerOf(face).rank, Kind::Request, edge);
    return false;
  }
  this->mesh_.split(edge, this->rules_.place(edge));
  const Id halfedge = this->mesh_.edgeData(edge).halfedge;
  if (halfedge != NoId)
  {
    for (const int other : this->part_.otherRanksAt(halfedge))
    {
      this->send(other, Kind::Decision, edge);
      put(this->messages_[rankIndex(other)], this->mesh_.placementOf(edge));
    }
  }
  return true;
}

// Faces are in the order of the ranks, and siblings in the order of the faces. The rank that owns
// this face decides about the edge.
Id RedGreenClosure::firstRefinedFaceAt(Id edge) const
{
  Id first = NoId;
  this->mesh_.forEachFaceAt(this->mesh_.edgeData(edge),
    [&](Id face) { first = first == NoId && this->frozen_[face] == 0 ? face : first; });
  return first;
}

void RedGreenClosure::send(int rank, Kind kind, Id edge)
{
  std::vector<std::uint8_t> path; // which half, from the edge up to the input edge
  Id ancestor = edge;
  while (this->mesh_.edgeData(ancestor).parent != NoId)
  {
    const Id parent = this->mesh_.edgeData(ancestor).parent;
    path.push_back(this->mesh_.edgeData(parent).halves == ancestor ? 0 : 1);
    ancestor = parent;
  }
  const Id halfedge = this->mesh_.edgeData(ancestor).halfedge;
  const RankAddress face = this->part_.addressOf(TriangleMesh::faceOf(halfedge));
  Message& message = this->messages_[rankIndex(rank)];
  put(message,
    SplitMessage{ kind, this->round_, face, TriangleMesh::indexInFace(halfedge),
      static_cast<Id>(path.size()) });
  std::reverse(path.begin(), path.end());
  put(message, path.data(), path.size());
}

Id RedGreenClosure::takeEdge(const SplitMessage& split, MessageReader& reader)
{
  Id edge = this->mesh_.ensureEdge(this->part_.faceAt(split.face), split.halfedge);
  for (Id i = 0; i < split.depth; ++i)
  {
    edge = this->mesh_.edgeData(edge).halves + reader.get<std::uint8_t>();
  }
  return edge;
}

void RedGreenClosure::splitIntoFour(Id triangle)
{
  bool areSplit = true;
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->mesh_.ensureEdge(triangle, k);
    if (!this->mesh_.isSplit(edge))
    {
      areSplit = this->split(edge) && areSplit;
    }
  }
  if (areSplit)
  {
    this->waiting_.erase(triangle);
    this->mesh_.splitIntoFour(triangle);
  }
  else
  {
    this->waiting_.insert(triangle);
  }
}

void RedGreenClosure::splitInside(Id triangle)
{
  if (!this->mesh_.isThin(triangle))
  {
    this->splitIntoFour(triangle);
  }
  else if (this->mesh_.pointsOnEdges(triangle) == 0)
  {
    this->split(this->mesh_.ensureEdge(triangle, this->mesh_.longestEdge(triangle)));
  }
  else
  {
    const Id edge = this->rules_.edgeToSplitBeforeParts(triangle);
    if (edge != NoId)
    {
      this->split(edge);
    }
    else
    {
      this->mesh_.divide(triangle);
    }
  }
}

void RedGreenClosure::close()
{
  constexpr int rounds = 2;
  std::vector<Id> changed;
  this->closeTouched(changed);
  while (this->round_ < rounds)
  {
    ++this->round_;
    for (const Id triangle : changed)
    {
      if (this->mesh_.isLeaf(triangle) && !this->mesh_.isThin(triangle) &&
        this->mesh_.splitEdges(triangle) == 1 && this->waiting_.count(triangle) == 0 &&
        !this->rules_.mayClose(triangle))
      {
        this->splitIntoFour(triangle);
      }
    }
    this->closeTouched(changed);
  }
  this->round_ = 0;
  this->changed_.insert(this->changed_.end(), changed.begin(), changed.end());
}

// The loop ends: it splits into four only triangles that already have a split edge, so it adds no
// level of parts to the existing ones; and the rules end the splits of thin leaves. These are
// examined when there is nothing else to do, as each of several splits touches them.
void RedGreenClosure::closeTouched(std::vector<Id>& changed)
{
  std::vector<Id> thin;
  do
  {
    for (Id triangle = this->mesh_.takeTouched(); triangle != NoId;
         triangle = this->mesh_.takeTouched())
    {
      if (!this->mesh_.isLeaf(triangle))
      {
        continue;
      }
      if (this->mesh_.isThin(triangle))
      {
        thin.push_back(triangle);
      }
      else if (this->waiting_.count(triangle) != 0 ||
        (this->mesh_.pointsOnEdges(triangle) > 1 && !this->rules_.mayClose(triangle)))
      {
        this->splitIntoFour(triangle);
      }
      else
      {
        changed.push_back(triangle);
      }
    }
    keepLeaves(this->mesh_, thin);
    for (const Id triangle : thin)
    {
      const Id edge = this->rules_.edgeToSplit(triangle);
      if (edge != NoId)
      {
        this->split(edge);
      }
      changed.push_back(triangle);
    }
    thin.clear();
  } while (this->mesh_.isAnyTouched());
  keepLeaves(this->mesh_, changed);
}

bool RedGreenClosure::exchangeSplits(std::uint64_t most, const std::function<void()>& report)
{
  Exchange& exchange = this->part_.exchange();
  std::vector<double> least;
  do
  {
    const bool isQuiet = std::all_of(this->messages_.begin(), this->messages_.end(),
      [](const Message& message) { return message.empty(); });
    least = { isQuiet ? 1.0 : 0.0, this->mesh_.numberOfTriangles() > most ? 0.0 : 1.0 };
    const std::vector<Message> received =
      exchange.step(std::exchange(this->messages_, exchange.noMessages()), least);
    if (least[1] == 0.0)
    {
      return false;
    }
    readEach(received,
      [&](int, MessageReader& reader)
      {
        const auto split = reader.get<SplitMessage>();
        const Id edge = this->takeEdge(split, reader);
        if (split.round != this->round_)
        {
          this->close();
          this->round_ = split.round;
        }
        if (split.kind == Kind::Decision)
        {
          this->mesh_.split(edge, reader.get<RedGreenMesh::Placement>());
          report();
        }
        else if (!this->mesh_.isSplit(edge))
        {
          this->split(edge);
        }
      });
    this->close();
  } while (least[0] == 0.0);
  return true;
}

std::vector<Id> RedGreenClosure::takeChanged()
{
  keepLeaves(this->mesh_, this->changed_);
  return std::exchange(this->changed_, {});
}

void RedGreenClosure::forget()
{
  this->waiting_.clear();
  this->changed_.clear();
}

}
