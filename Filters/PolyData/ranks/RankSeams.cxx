// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/RankSeams.h"

#include "PolyData/Hash.h"
#include "Questions.h"
#include "mesh/Box.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace geodesic
{

namespace
{

using Label = RankLabels::Label;

constexpr int BitsOfVertex = 40;

/// What is known of a key by the rank that looks after it.
struct KnownKey
{
  Label least;
  int rank;
  bool isShared = false;
};

/// Adds the places of those vertices that another rank can have, by its bounding box.
void addPlacesNearOthers(
  const std::vector<Vec3>& vertices, Exchange& exchange, std::vector<KeyedVertex>& keys)
{
  Box own;
  for (const Vec3& p : vertices)
  {
    own.add(p);
  }
  std::vector<Box> others = valuesOfRanks(exchange, own);
  others.erase(others.begin() + exchange.rank());
  for (Id vertex = 0; vertex < vertices.size(); ++vertex)
  {
    const Vec3& p = vertices[vertex];
    if (std::any_of(others.begin(), others.end(), [&p](const Box& box) { return box.holds(p); }))
    {
      const Vec3 place = p + Vec3{}; // -0 and 0 are one place
      keys.push_back({ { place[0], place[1], place[2], 0.0 }, vertex });
    }
  }
}

/// Gives vertices with equal keys the least label of these. Each key is looked after by one rank.
///
/// \returns whether a label on this rank has changed.
bool shareLeast(const std::vector<KeyedVertex>& keys, Exchange& exchange, RankLabels& labels)
{
  Questions questions(exchange);
  const auto ranks = static_cast<std::uint64_t>(exchange.numberOfRanks());
  for (const auto& [key, vertex] : keys)
  {
    questions.ask(static_cast<int>(hashOf(key) % ranks), vertex, key, labels.of(vertex));
  }
  std::unordered_map<VertexKey, KnownKey, Hash> known;
  bool hasChanged = false;
  questions.exchangeAnswers(
    [&](int rank, MessageReader& question)
    {
      const auto key = question.get<VertexKey>();
      const auto label = question.get<Label>();
      KnownKey& entry = known.try_emplace(key, KnownKey{ label, rank }).first->second;
      entry.least = std::min(entry.least, label);
      entry.isShared = entry.isShared || entry.rank != rank;
    },
    [&](MessageReader& question, Message& answer)
    {
      const KnownKey& entry = known.at(question.get<VertexKey>());
      question.get<Label>();
      put(answer, entry.least | (entry.isShared ? RankLabels::Shared : 0));
    },
    [&](std::size_t item, MessageReader& reader)
    {
      const auto answer = reader.get<Label>();
      const auto vertex = static_cast<Id>(item);
      const Label before = labels.of(vertex);
      const Label after = std::min(before, answer & ~RankLabels::Shared);
      hasChanged = hasChanged || after != before;
      Label& label = labels.labels[vertex];
      label = after | ((label | answer) & RankLabels::Shared);
    });
  return hasChanged;
}

}

RankLabels joinSameVertices(const std::vector<Vec3>& vertices, bool byPlace,
  std::vector<KeyedVertex> globalIds, Exchange& exchange)
{
  RankLabels labels;
  std::vector<KeyedVertex> keys = std::move(globalIds);
  for (Id vertex = 0; vertex < vertices.size(); ++vertex)
  {
    labels.labels.push_back((static_cast<Label>(exchange.rank()) << BitsOfVertex) | vertex);
  }
  if (byPlace)
  {
    addPlacesNearOthers(vertices, exchange, keys);
  }
  // Labels go on from a place to an id and from there to another place, until none changes. They
  // only fall, so that there is an end.
  while (exchange.isTrueAnywhere(shareLeast(keys, exchange, labels)))
  {
  }
  return labels;
}

// The rank with the lowest vertex of those with a label hears who has a face there.
BorrowedValues findValuesElsewhere(
  const RankLabels& labels, const std::vector<Id>& ownNumbers, Exchange& exchange)
{
  constexpr RankAddress nobody{ -1, NoId };
  constexpr auto nowhere = ~std::size_t(0);
  std::vector<RankAddress> holders;
  Questions questions(exchange);
  for (Id vertex = 0; vertex < ownNumbers.size(); ++vertex)
  {
    const Id own = ownNumbers[vertex];
    if (labels.isSharedAt(vertex))
    {
      const Label label = labels.of(vertex);
      questions.ask(static_cast<int>(label >> BitsOfVertex), own == NoId ? holders.size() : nowhere,
        label, own);
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
  std::unordered_map<Label, RankAddress> lowest;
  questions.exchangeAnswers(
    [&](int rank, MessageReader& question)
    {
      const auto label = question.get<Label>();
      const Id number = question.get<Id>();
      if (number != NoId)
      {
        lowest.emplace(label, RankAddress{ rank, number }); // ranks ascend
      }
    },
    [&](MessageReader& question, Message& answer)
    {
      const auto found = lowest.find(question.get<Label>());
      question.get<Id>();
      put(answer, found != lowest.end() ? found->second : nobody);
    },
    [&](std::size_t item, MessageReader& answer)
    {
      const auto holder = answer.get<RankAddress>();
      if (item != nowhere)
      {
        holders[item] = holder;
      }
    });
  return BorrowedValues(holders, exchange);
}

}
