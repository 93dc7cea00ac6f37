// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/RemoteVertices.h"

#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

using Label = RankLabels::Label;

/// What is told to the rank that looks after a label: who has faces at the vertex.
struct ToldHolder
{
  Label label;
  Id vertex;
  Id isHolder;
};

/// Answers each question with the lowest holder of its label.
std::vector<Message> findHolders(const std::vector<Message>& told)
{
  std::unordered_map<Label, RankAddress> holders;
  readEach(told,
    [&](int rank, MessageReader& reader)
    {
      const auto entry = reader.get<ToldHolder>();
      if (entry.isHolder != 0)
      {
        holders.emplace(entry.label, RankAddress{ rank, entry.vertex }); // ranks ascend
      }
    });
  std::vector<Message> answers(told.size());
  readEach(told,
    [&](int rank, MessageReader& reader)
    {
      const auto entry = reader.get<ToldHolder>();
      if (entry.isHolder == 0)
      {
        const auto found = holders.find(entry.label);
        put(answers[rankIndex(rank)],
          found != holders.end() ? found->second : RankAddress{ -1, NoId });
      }
    });
  return answers;
}

}

RemoteVertices::RemoteVertices(
  const RankLabels& labels, const std::vector<Id>& ownNumbers, Exchange& exchange)
{
  std::vector<Message> messages = exchange.noMessages();
  std::vector<std::vector<Id>> asked(messages.size());
  Id withoutFace = 0;
  for (Id vertex = 0; vertex < ownNumbers.size(); ++vertex)
  {
    const bool isHolder = ownNumbers[vertex] != NoId;
    if (labels.isShared[vertex])
    {
      const Label label = labels.labels[vertex];
      const auto rank = rankIndex(RankSeams::rankOf(label));
      put(messages[rank], ToldHolder{ label, ownNumbers[vertex], isHolder ? Id(1) : Id(0) });
      if (!isHolder)
      {
        asked[rank].push_back(this->count_);
      }
    }
    else
    {
      withoutFace += isHolder ? 0 : 1;
    }
    this->count_ += isHolder ? 0 : 1;
  }
  if (!exchange.isTrueAnywhere(this->count_ > 0))
  {
    return;
  }
  const std::vector<Message> told = exchange.step(std::move(messages));
  std::vector<RankAddress> holders(this->count_, { -1, NoId });
  std::vector<std::size_t> next(asked.size(), 0);
  readEach(exchange.step(findHolders(told)),
    [&](int rank, MessageReader& reader)
    {
      const auto from = rankIndex(rank);
      const Id borrowed = asked[from][next[from]++];
      holders[borrowed] = reader.get<RankAddress>();
      const bool isCountedHere = from == rankIndex(exchange.rank());
      withoutFace += holders[borrowed].id == NoId && isCountedHere ? 1 : 0;
    });
  this->values_ = BorrowedValues(holders, exchange);
  this->numberWithoutFace_ = static_cast<Id>(sumOverRanks(exchange, withoutFace).all);
}

}
