// SPDX-License-Identifier: BSD-3-Clause
#include "front/FrontOnRanks.h"

#include "Questions.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

void FrontOnRanks::addUpdate(const DistanceUpdate& update)
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

void FrontOnRanks::exchangeLists()
{
  if (!this->surface_.isDistributed())
  {
    return;
  }
  Mailboxes& mailboxes = this->front_.mailboxes;
  for (District& district : this->front_.districts)
  {
    for (const HalfedgeList& list : district.toRanks.lists)
    {
      this->addList(list);
    }
    district.toRanks.lists.clear();
    mailboxes.forEachOf(district.number,
      [this](const MailBatch& mail)
      {
        for (const DistanceUpdate& update : mail.updates)
        {
          this->addUpdate(update);
        }
      });
  }
  std::vector<double> nothing;
  const Received received = this->step(nothing);
  for (const bool areHigher : { false, true })
  {
    for (const DistanceUpdate& update : received.updates[areHigher ? 1 : 0])
    {
      mailboxes.fromRanks(areHigher, this->front_.districtNumbers.of(update.vertex))
        .updates.push_back(update);
    }
  }
  for (const HalfedgeList& list : received.lists)
  {
    const Id receiver = this->front_.districtNumbers.of(this->front_.mesh.opposite(list.halfedge));
    mailboxes.fromRanks(true, receiver).lists.push_back(list);
  }
}

std::vector<DistanceUpdate> FrontOnRanks::exchangeArrivals(VertexSchedule::Outlook& next)
{
  if (!this->surface_.isDistributed())
  {
    return {};
  }
  for (District& district : this->front_.districts)
  {
    for (const DistanceUpdate& arrival : district.toRanks.arrivals)
    {
      this->addUpdate(arrival);
    }
    district.toRanks.arrivals.clear();
  }
  std::vector<double> least = { next.least, next.last, -this->front_.retention.neededDistance() };
  Received received = this->step(least);
  next = { least[0], least[1] };
  this->neededDistance_ = -least[2];
  std::vector<DistanceUpdate>& updates = received.updates[0];
  updates.insert(updates.end(), received.updates[1].begin(), received.updates[1].end());
  return std::move(updates);
}

double FrontOnRanks::neededDistance() const
{
  return this->surface_.isDistributed() ? this->neededDistance_
                                        : this->front_.retention.neededDistance();
}

void FrontOnRanks::shareNeeded(CompleteFaces& faces)
{
  if (!this->surface_.isDistributed())
  {
    return;
  }
  std::vector<Id> needed;
  for (Id face = 0; face < this->surface_.mesh().numberOfFaces(); ++face)
  {
    if (faces.isNeeded(face) && !this->surface_.isOwn(face))
    {
      needed.push_back(face);
    }
  }
  for (const Id face : this->surface_.sendToOwners(needed))
  {
    faces.add(face);
  }
}

void FrontOnRanks::shareMarks(std::vector<std::uint8_t>& marks)
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

void FrontOnRanks::completeHalo(std::vector<double>& distances)
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
      const RankAddress owner = this->surface_.addressOf(TriangleMesh::faceOf(corner));
      questions.ask(owner.rank, vertex, TriangleMesh::inCopy(corner, owner.id));
      isAsked[vertex - firstOfHalo] = 1;
    }
  }
  questions.exchangeAnswers([&](MessageReader& question, Message& answer)
    { put(answer, distances[mesh.origin(question.get<Id>())]); },
    [&](std::size_t vertex, MessageReader& answer) { distances[vertex] = answer.get<double>(); });
}

void FrontOnRanks::addList(const HalfedgeList& list)
{
  const RankAddress owner = this->surface_.addressOf(TriangleMesh::faceOf(list.halfedge));
  Message& message = this->messages_[rankIndex(owner.rank)];
  put(message, TriangleMesh::inCopy(list.halfedge, owner.id));
  put(message, list.windows.size);
  put(message, list.windows.data, list.windows.size);
  this->pool_.free(list.windows);
}

FrontOnRanks::Received FrontOnRanks::step(std::vector<double>& least)
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
          { halfedge, this->pool_.copyOf({ windows.data(), windows.data() + windows.size() }) });
        return;
      }
      auto update = reader.get<DistanceUpdate>();
      Id& through = update.from.halfedge;
      if (through != NoId) // in a face of the sender, of which this rank has a copy
      {
        const Id copy = this->surface_.faceAt({ sender, TriangleMesh::faceOf(through) });
        through = TriangleMesh::inCopy(through, copy);
      }
      received.updates[sender > exchange.rank() ? 1 : 0].push_back(update);
    });
  return received;
}

}
