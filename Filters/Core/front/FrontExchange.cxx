// SPDX-License-Identifier: BSD-3-Clause
#include "front/FrontExchange.h"

#include "Questions.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

FrontExchange::FrontExchange(const MeshPartition& surface)
  : surface_(surface)
  , updates_(rankIndex(surface.exchange().numberOfRanks()))
  , lists_(surface.exchange().noMessages())
{
}

void FrontExchange::addList(const SentList& list, WindowPool& pool)
{
  const RankAddress owner = this->surface_.ownerOf(TriangleMesh::faceOf(list.halfedge));
  Message& message = this->lists_[rankIndex(owner.rank)];
  put(message, 3 * owner.id + list.halfedge % 3);
  put(message, static_cast<std::uint32_t>(list.windows.size));
  put(message, list.windows.data, list.windows.size);
  pool.free(list.windows);
}

void FrontExchange::addUpdate(const DistanceUpdate& update)
{
  for (const RankAddress& other : this->surface_.othersWith(update.vertex))
  {
    DistanceUpdate& added = this->updates_[rankIndex(other.rank)].emplace_back(update);
    added.vertex = other.id;
  }
}

FrontExchange::Received FrontExchange::step(std::vector<double>& least, WindowPool& pool)
{
  std::vector<Message> messages = this->surface_.exchange().noMessages();
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    std::vector<DistanceUpdate>& updates = this->updates_[rank];
    if (!updates.empty() || !this->lists_[rank].empty())
    {
      put(messages[rank], updates.size());
      put(messages[rank], updates.data(), updates.size());
      put(messages[rank], this->lists_[rank].data(), this->lists_[rank].size());
      updates.clear();
      this->lists_[rank].clear();
    }
  }
  messages = this->surface_.exchange().step(std::move(messages), least);

  Received received;
  std::vector<Window> windows;
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    if (messages[rank].empty())
    {
      continue;
    }
    const auto sender = static_cast<int>(rank);
    MessageReader reader(messages[rank]);
    std::vector<DistanceUpdate>& updates =
      sender < this->surface_.exchange().rank() ? received.fromLower : received.fromHigher;
    for (auto left = reader.get<std::size_t>(); left > 0; --left)
    {
      updates.push_back(this->translated(sender, reader.get<DistanceUpdate>()));
    }
    while (!reader.isAtEnd())
    {
      const Id halfedge = reader.get<Id>();
      windows.resize(reader.get<std::uint32_t>());
      reader.get(windows.data(), windows.size());
      received.lists.push_back(
        { halfedge, pool.copyOf({ windows.data(), windows.data() + windows.size() }) });
    }
  }
  return received;
}

// The sender owns the face through which the path arrives; this rank has a copy of that face.
DistanceUpdate FrontExchange::translated(int sender, DistanceUpdate update) const
{
  Id& halfedge = update.from.halfedge;
  if (halfedge != NoId)
  {
    halfedge = 3 * this->surface_.copyOf({ sender, TriangleMesh::faceOf(halfedge) }) + halfedge % 3;
  }
  return update;
}

void FrontExchange::shareNeeded(CompleteFaces& faces)
{
  if (!this->surface_.isDistributed())
  {
    return;
  }
  std::vector<Message> messages = this->surface_.exchange().noMessages();
  for (Id face = 0; face < this->surface_.mesh().numberOfFaces(); ++face)
  {
    if (faces.isNeeded(face) && !this->surface_.isOwn(face))
    {
      const RankAddress owner = this->surface_.ownerOf(face);
      put(messages[rankIndex(owner.rank)], owner.id);
    }
  }
  readEach(this->surface_.exchange().step(std::move(messages)),
    [&](int, MessageReader& reader) { faces.add(reader.get<Id>()); });
}

void FrontExchange::shareMarks(std::vector<std::uint8_t>& marks)
{
  if (!this->surface_.isDistributed())
  {
    return;
  }
  std::vector<Message> messages = this->surface_.exchange().noMessages();
  for (Id vertex = 0; vertex < this->surface_.numberOfOwnVertices(); ++vertex)
  {
    for (const RankAddress& other : this->surface_.othersWith(vertex))
    {
      if (marks[vertex])
      {
        put(messages[rankIndex(other.rank)], other.id);
      }
    }
  }
  readEach(this->surface_.exchange().step(std::move(messages)),
    [&](int, MessageReader& reader) { marks[reader.get<Id>()] = 1; });
}

void FrontExchange::completeHalo(std::vector<double>& distances)
{
  if (!this->surface_.isDistributed())
  {
    return;
  }
  const TriangleMesh& mesh = this->surface_.mesh();
  const Id firstOfHalo = this->surface_.numberOfOwnVertices();
  Questions questions(this->surface_.exchange());
  std::vector<std::uint8_t> isAsked(mesh.numberOfVertices() - firstOfHalo, 0);
  for (Id corner = 0; corner < mesh.numberOfHalfedges(); ++corner)
  {
    const Id vertex = mesh.origin(corner);
    if (vertex >= firstOfHalo && !isAsked[vertex - firstOfHalo])
    {
      const RankAddress owner = this->surface_.ownerOf(TriangleMesh::faceOf(corner));
      questions.ask(owner.rank, vertex, 3 * owner.id + corner % 3);
      isAsked[vertex - firstOfHalo] = 1;
    }
  }
  questions.exchangeAnswers([&](MessageReader& question, Message& answer)
    { put(answer, distances[mesh.origin(question.get<Id>())]); },
    [&](std::size_t vertex, MessageReader& answer) { distances[vertex] = answer.get<double>(); });
}

}
