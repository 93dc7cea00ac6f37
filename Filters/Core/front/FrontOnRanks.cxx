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

template <typename Accept>
void FrontOnRanks::step(std::vector<double>& least, const Accept& accept)
{
  Exchange& exchange = this->surface_.exchange();
  std::vector<Message> messages = exchange.noMessages();
  messages.swap(this->messages_);
  std::vector<Window> windows;
  readEach(exchange.step(std::move(messages), least),
    [&](int sender, MessageReader& reader)
    {
      const Id halfedge = reader.get<Id>();
      if (halfedge != NoId)
      {
        windows.resize(reader.get<std::uint32_t>());
        reader.get(windows.data(), windows.size());
        const Id receiver = this->front_.districtNumbers.of(this->front_.mesh.opposite(halfedge));
        this->front_.mailboxes.fromRanks(true, receiver)
          .lists.push_back(
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
      accept(update, sender > exchange.rank());
    });
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
  this->step(nothing,
    [&](const DistanceUpdate& update, bool isOfHigherRank)
    {
      mailboxes.fromRanks(isOfHigherRank, this->front_.districtNumbers.of(update.vertex))
        .updates.push_back(update);
    });
}

std::vector<DistanceUpdate> FrontOnRanks::exchangeArrivals(VertexSchedule::Outlook& next)
{
  if (!this->surface_.isDistributed())
  {
    return {};
  }
  for (District& district : this->front_.districts)
  {
    for (const DistanceUpdate& arrival : district.toRanks.updates)
    {
      this->addUpdate(arrival);
    }
    district.toRanks.updates.clear();
  }
  std::vector<double> least = { next.least, next.last, -this->front_.retention.neededDistance() };
  std::vector<DistanceUpdate> updates;
  this->step(least, [&updates](const DistanceUpdate& update, bool) { updates.push_back(update); });
  next = { least[0], least[1] };
  this->neededDistance_ = -least[2];
  return updates;
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

}
