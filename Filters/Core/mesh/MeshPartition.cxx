// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/MeshPartition.h"

#include "Questions.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

/// A number, which is a point's key or another rank's vertex, and a vertex that belongs to it.
using KeyedVertex = std::pair<std::uint64_t, RankAddress>;

Id checkedId(std::uint64_t number, const char* what)
{
  if (number >= NoId / 3)
  {
    throw MeshTooLarge("The surface has " + std::to_string(number) + " " + what +
      " on all ranks together; at most " + std::to_string(NoId / 3 - 1) +
      " can be numbered. Split the surface.");
  }
  return static_cast<Id>(number);
}

} // anonymous namespace

/// Fills the tables in stages, all of which the ranks take together.
class MeshPartition::TablesBuilder : public Tables
{
public:
  TablesBuilder(std::vector<Vec3> points, const std::vector<Triangle>& triangles,
    const std::vector<std::uint64_t>& keys, Exchange& exchange, const Job& job)
    : exchange_(exchange)
  {
    this->numberOfOwnVertices = static_cast<Id>(points.size());
    this->findHolders(keys);
    this->numberVertices(points);
    const std::vector<SentFace> received = this->exchangeHalo(points, triangles);
    this->makeMesh(std::move(points), triangles, received, job);
    this->exchangeAddresses(triangles.size(), received);
  }

private:
  // Each key is managed by one rank: all ranks report their keys to their managers, who tell those
  // that share a key.
  void findHolders(const std::vector<std::uint64_t>& keys)
  {
    std::vector<Message> messages = this->exchange_.noMessages();
    for (Id vertex = 0; vertex < this->numberOfOwnVertices; ++vertex)
    {
      // Keys may have any pattern; a multiplication scatters them (Knuth, 6.4).
      const std::uint64_t hash = keys[vertex] * 0x9e3779b97f4a7c15U;
      Message& message = messages[(hash >> 32) % messages.size()];
      put(message, keys[vertex]);
      put(message, vertex);
    }
    std::vector<KeyedVertex> known;
    readEach(this->exchange_.step(std::move(messages)),
      [&](int rank, MessageReader& reader)
      {
        const auto key = reader.get<std::uint64_t>();
        known.emplace_back(key, RankAddress{ rank, reader.get<Id>() });
      });
    std::sort(known.begin(), known.end());

    std::vector<Message> answers = this->exchange_.noMessages();
    auto first = known.begin(); // with the same key
    for (const auto& [key, holder] : known)
    {
      first = std::find_if(
        first, known.end(), [wanted = key](const auto& k) { return k.first == wanted; });
      for (auto other = first; other != known.end() && other->first == key; ++other)
      {
        if (other->second.rank != holder.rank)
        {
          Message& message = answers[rankIndex(holder.rank)];
          put(message, holder.id);
          put(message, other->second);
        }
      }
    }
    known = {};

    std::vector<KeyedVertex> shared;
    readEach(this->exchange_.step(std::move(answers)),
      [&](int, MessageReader& reader)
      {
        const Id vertex = reader.get<Id>();
        shared.emplace_back(vertex, reader.get<RankAddress>());
      });
    std::sort(shared.begin(), shared.end());
    this->firstHolder.assign(this->numberOfOwnVertices + std::size_t(1), 0);
    for (const auto& [vertex, other] : shared)
    {
      ++this->firstHolder[vertex + 1];
      this->holders.push_back(other);
    }
    std::partial_sum(this->firstHolder.begin(), this->firstHolder.end(), this->firstHolder.begin());
  }

  // The lowest rank that has a vertex assigns its global id and its coordinates: points that are
  // one may differ by roundings.
  void numberVertices(std::vector<Vec3>& points)
  {
    for (Id vertex = 0; vertex < this->numberOfOwnVertices; ++vertex)
    {
      const Holders others = this->othersWith(vertex);
      if (others.size() == 0 || others.first->rank > this->exchange_.rank())
      {
        this->counted.push_back(vertex);
      }
    }
    std::uint64_t all = 0;
    for (const std::uint64_t count :
      valuesOfRanks<std::uint64_t>(this->exchange_, this->counted.size()))
    {
      this->firstOfRank.push_back(static_cast<GlobalId>(all));
      all += count;
    }
    this->numberOfGlobalVertices = checkedId(all, "points");
    Id number = static_cast<Id>(this->firstOfRank[rankIndex(this->exchange_.rank())]);
    this->globalIds.resize(this->numberOfOwnVertices);
    std::vector<Message> messages = this->exchange_.noMessages();
    for (const Id vertex : this->counted)
    {
      this->globalIds[vertex] = GlobalId{ number };
      for (const RankAddress& other : this->othersWith(vertex))
      {
        Message& message = messages[rankIndex(other.rank)];
        put(message, other.id);
        put(message, this->globalIds[vertex]);
        put(message, points[vertex]);
      }
      ++number;
    }
    readEach(this->exchange_.step(std::move(messages)),
      [&](int, MessageReader& reader)
      {
        const Id vertex = reader.get<Id>();
        this->globalIds[vertex] = reader.get<GlobalId>();
        points[vertex] = reader.get<Vec3>();
      });
  }

  // Every rank sends each of its faces to the other ranks that have one of its vertices.
  std::vector<SentFace> exchangeHalo(
    const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
  {
    std::vector<Message> messages = this->exchange_.noMessages();
    std::vector<Id> lastSent(messages.size(), NoId);
    for (Id triangle = 0; triangle < triangles.size(); ++triangle)
    {
      const auto& [a, b, c] = triangles[triangle];
      const SentFace face = { { this->exchange_.rank(), triangle },
        { this->globalIds[a], this->globalIds[b], this->globalIds[c] },
        { points[a], points[b], points[c] } };
      for (const Id vertex : triangles[triangle])
      {
        for (const RankAddress& other : this->othersWith(vertex))
        {
          if (std::exchange(lastSent[rankIndex(other.rank)], triangle) != triangle)
          {
            put(messages[rankIndex(other.rank)], face);
          }
        }
      }
    }
    std::vector<SentFace> received;
    readEach(this->exchange_.step(std::move(messages)),
      [&](int, MessageReader& reader) { received.push_back(reader.get<SentFace>()); });
    return received;
  }

  void makeMesh(std::vector<Vec3> points, const std::vector<Triangle>& triangles,
    const std::vector<SentFace>& received, const Job& job)
  {
    std::unordered_map<GlobalId, Id> vertexOf;
    for (Id vertex = 0; vertex < this->numberOfOwnVertices; ++vertex)
    {
      if (this->othersWith(vertex).size() > 0)
      {
        vertexOf[this->globalIds[vertex]] = vertex;
      }
    }
    std::vector<Triangle> all;
    all.reserve(received.size() + triangles.size());
    const auto add = [&](const SentFace& face)
    {
      Triangle corners;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto found = vertexOf.try_emplace(face.vertices[k], static_cast<Id>(points.size()));
        if (found.second)
        {
          points.push_back(face.points[k]);
          this->globalIds.push_back(face.vertices[k]);
        }
        corners[k] = found.first->second;
      }
      all.push_back(corners);
    };
    const auto behind = std::find_if(received.begin(), received.end(),
      [&](const SentFace& face) { return face.owner.rank > this->exchange_.rank(); });
    std::for_each(received.begin(), behind, add);
    all.insert(all.end(), triangles.begin(), triangles.end());
    std::for_each(behind, received.end(), add);
    const std::uint64_t faces = sumOverRanks(this->exchange_, triangles.size()).all;
    if (faces == 0)
    {
      throw MeshError("The surface has no faces on any rank. Give a surface of triangles.");
    }
    if (!all.empty())
    {
      this->mesh = TriangleMesh(std::move(points), all, job);
    }
    this->firstHolder.resize(this->globalIds.size() + 1, this->firstHolder.back());
    this->firstTriangle = static_cast<Id>(behind - received.begin());
    this->firstOwnFace = this->mesh.firstFaceFrom(this->firstTriangle);
    this->endOfOwnFaces =
      this->mesh.firstFaceFrom(static_cast<Id>(this->firstTriangle + triangles.size()));
    const SumsOverRanks owned =
      sumOverRanks(this->exchange_, this->endOfOwnFaces - this->firstOwnFace);
    this->numberOfGlobalFaces = checkedId(owned.all, "faces");
    this->firstGlobalFace = static_cast<Id>(owned.before);
  }

  // Asks the owners for their numbers of the faces of the halo, which are known by their triangles.
  // All ranks leave out the same faces: those that name a vertex twice, and of faces on the same
  // vertices all but the lowest rank's first.
  void exchangeAddresses(std::size_t numberOfTriangles, const std::vector<SentFace>& received)
  {
    Questions questions(this->exchange_);
    for (Id face = 0; face < this->mesh.numberOfFaces(); ++face)
    {
      if (face < this->firstOwnFace || face >= this->endOfOwnFaces)
      {
        const Id input = this->mesh.inputFace(face);
        const RankAddress& triangle =
          received[input < this->firstTriangle ? input : input - numberOfTriangles].owner;
        questions.ask(triangle.rank, this->halo.size(), triangle.id);
        this->halo.push_back(triangle);
      }
    }
    questions.exchangeAnswers([this](MessageReader& question, Message& answer)
      { put(answer, this->mesh.firstFaceFrom(this->firstTriangle + question.get<Id>())); },
      [this](std::size_t i, MessageReader& answer) { this->halo[i].id = answer.get<Id>(); });
  }

  Exchange& exchange_;
};

MeshPartition::MeshPartition(std::vector<Vec3> points, const std::vector<Triangle>& triangles,
  const std::vector<std::uint64_t>& keys, Exchange& exchange, const Job& job)
  : tables_(exchange.numberOfRanks() > 1
        ? std::make_shared<TablesBuilder>(std::move(points), triangles, keys, exchange, job)
        : nullptr)
  , mesh_(tables_ ? std::shared_ptr<const TriangleMesh>(tables_, &tables_->mesh)
                  : std::make_shared<TriangleMesh>(std::move(points), triangles, job))
  , exchange_(&exchange)
  , firstOwnFace_(tables_ ? tables_->firstOwnFace : 0)
  , endOfOwnFaces_(tables_ ? tables_->endOfOwnFaces : mesh_->numberOfFaces())
{
}

std::vector<std::uint8_t> MeshPartition::ownFaces() const
{
  std::vector<std::uint8_t> faces(this->isDistributed() ? this->mesh_->numberOfFaces() : 0, 0);
  if (!faces.empty())
  {
    std::fill(
      faces.begin() + this->firstOwnFace_, faces.begin() + this->endOfOwnFaces_, std::uint8_t(1));
  }
  return faces;
}

// Faces are in the order of the ranks, and siblings in the order of the faces.
std::vector<Id> MeshPartition::sendToOwners(const std::vector<Id>& faces) const
{
  std::vector<Id> own;
  std::vector<Message> messages = this->exchange_->noMessages();
  for (const Id face : faces)
  {
    if (this->isOwn(face))
    {
      own.push_back(face);
      continue;
    }
    const RankAddress owner = this->addressOf(face);
    put(messages[rankIndex(owner.rank)], owner.id);
  }
  readEach(this->exchange_->step(std::move(messages)),
    [&](int, MessageReader& reader) { own.push_back(reader.get<Id>()); });
  return own;
}

std::vector<int> MeshPartition::otherRanksAt(Id halfedge) const
{
  std::vector<int> ranks;
  if (!this->isDistributed())
  {
    return ranks;
  }
  Id around = this->mesh_->edgeOf(halfedge);
  do
  {
    const Id face = TriangleMesh::faceOf(around);
    const int rank = this->addressOf(face).rank;
    if (rank != this->exchange_->rank() && (ranks.empty() || ranks.back() != rank))
    {
      ranks.push_back(rank);
    }
    around = this->mesh_->nextSibling(around);
  } while (around != this->mesh_->edgeOf(halfedge));
  return ranks;
}

Id MeshPartition::faceAt(const RankAddress& face) const
{
  if (face.rank == this->exchange_->rank())
  {
    return face.id;
  }
  const Id i = this->tables_ ? indexIn(this->tables_->halo, face) : NoId;
  return i == NoId || i < this->firstOwnFace_ ? i
                                              : i + (this->endOfOwnFaces_ - this->firstOwnFace_);
}

// A rank that counts no vertex begins at the same id as the next rank.
int MeshPartition::rankCounting(GlobalId id) const
{
  if (!this->tables_)
  {
    return 0;
  }
  const std::vector<GlobalId>& first = this->tables_->firstOfRank;
  const auto behind = std::upper_bound(first.begin(), first.end(), id);
  return static_cast<int>(behind - first.begin()) - 1;
}

Id MeshPartition::countedVertex(GlobalId id) const
{
  if (!this->tables_)
  {
    return static_cast<Id>(id) < this->mesh_->numberOfVertices() ? static_cast<Id>(id) : NoId;
  }
  const Id i = static_cast<Id>(id) -
    static_cast<Id>(this->tables_->firstOfRank[rankIndex(this->exchange_->rank())]);
  return i < this->tables_->counted.size() ? this->tables_->counted[i] : NoId;
}

SentFace MeshPartition::sentFace(Id face) const
{
  const auto& [a, b, c] = this->mesh_->triangle(face);
  return { this->addressOf(face), this->globalIds(this->mesh_->triangle(face)),
    { this->mesh_->point(a), this->mesh_->point(b), this->mesh_->point(c) } };
}

}
