// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/RemoteVertices.h"

#include "Questions.h"

#include <unordered_map>

namespace geodesic
{

BorrowedValues remoteVertices(
  const RankLabels& labels, const std::vector<Id>& ownNumbers, Exchange& exchange)
{
  // The rank that looks after a label hears who has a face at the vertex. The others ask it.
  constexpr RankAddress nobody{ -1, NoId };
  std::vector<RankAddress> holders;
  Questions questions(exchange);
  std::vector<Message> messages = exchange.noMessages();
  for (Id vertex = 0; vertex < ownNumbers.size(); ++vertex)
  {
    const Id own = ownNumbers[vertex];
    if (labels.isSharedAt(vertex))
    {
      const RankLabels::Label label = labels.of(vertex);
      const int rank = RankSeams::rankOf(label);
      if (own == NoId)
      {
        questions.ask(rank, holders.size(), label);
      }
      else
      {
        put(messages[rankIndex(rank)], label);
        put(messages[rankIndex(rank)], own);
      }
    }
    if (own == NoId)
    {
      holders.push_back(nobody);
    }
  }
  if (!exchange.isTrueAnywhere(!holders.empty()))
  {
    return {};
  }
  std::unordered_map<RankLabels::Label, RankAddress> lowest;
  readEach(exchange.step(std::move(messages)),
    [&](int rank, MessageReader& reader)
    {
      const auto label = reader.get<RankLabels::Label>();
      lowest.emplace(label, RankAddress{ rank, reader.get<Id>() }); // ranks ascend
    });
  questions.exchangeAnswers(
    [&](MessageReader& question, Message& answer)
    {
      const auto found = lowest.find(question.get<RankLabels::Label>());
      put(answer, found != lowest.end() ? found->second : nobody);
    },
    [&](std::size_t vertex, MessageReader& answer)
    { holders[vertex] = answer.get<RankAddress>(); });
  return BorrowedValues(holders, exchange);
}

}
