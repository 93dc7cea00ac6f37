// SPDX-License-Identifier: BSD-3-Clause
#include "front/FrontExchange.h"

#include "Questions.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

void FrontExchange::addList(const SentList& list, WindowPool& pool)
{
  const RankAddress owner = this->surface_.ownerOf(TriangleMesh::faceOf(list.halfedge));
  Message& message = this->messages_[rankIndex(owner.rank)];
  put(message, TriangleMesh::inCopy(list.halfedge, owner.id));
  put(message, list.windows.size);
  put(message, list.windows.data, list.windows.size);
  pool.free(list.windows);
}

void FrontExchange::addUpdate(const DistanceUpdate& update)
{
  for (const RankAddress& other : this->surface_.othersWith(update.vertex))
  {
    Message& message = this->messages_[rankIndex(other.rank)];
    DistanceUpdate added = update;
    added.vertex = other.id;
    put(message, NoId);
    put(message, added);
  }
}

FrontExchange::Received FrontExchange::step(std::vector<double>& least, WindowPool& pool)
{
  Exchange& exchange = this->surface_.exchange();
  std::vector<Message> messages = exchange.noMessages();
  messages.swap(this->messages_);
  Received received;
  std::vector<Window> windows;
  readEach(exchange.step(std::move(messages), least),
    [&](int sender, MessageReader& reader)
    {
      const Id halfedge = reader.get<Id>();
      if (halfedge != NoId)
      {
        windows.resize(reader.get<std::uint32_t>());
        reader.get(windows.data(), windows.size());
        received.lists.push_back(
          { halfedge, pool.copyOf({ windows.data(), windows.data() + windows.size() }) });
        return;
      }
      auto update = reader.get<DistanceUpdate>();
      Id& through = update.from.halfedge;
      if (through != NoId) // in a face of the sender, of which this rank has a copy
      {
        const Id copy = this->surface_.copyOf({ sender, TriangleMesh::faceOf(through) });
        through = TriangleMesh::inCopy(through, copy);
      }
      received.updates[sender > exchange.rank() ? 1 : 0].push_back(update);
    });
  return received;
}

void FrontExchange::shareNeeded(CompleteFaces& faces)
{
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
      questions.ask(owner.rank, vertex, TriangleMesh::inCopy(corner, owner.id));
      isAsked[vertex - firstOfHalo] = 1;
    }
  }
  questions.exchangeAnswers([&](MessageReader& question, Message& answer)
    { put(answer, distances[mesh.origin(question.get<Id>())]); },
    [&](std::size_t vertex, MessageReader& answer) { distances[vertex] = answer.get<double>(); });
}

}
