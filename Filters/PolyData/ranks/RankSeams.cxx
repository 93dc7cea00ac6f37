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

/// A key, such as a place, and a vertex that has it.
template <typename Key>
using Keyed = std::pair<Key, Id>;

/// What is known of a key by the rank that looks after it.
struct KnownKey
{
  Label least;
  int rank;
  bool isShared = false;
};

/// The places of those vertices that another rank can have, by its bounding box.
std::vector<Keyed<Vec3>> placesNearOthers(const std::vector<Vec3>& vertices, Exchange& exchange)
{
  Box own;
  for (const Vec3& p : vertices)
  {
    own.add(p);
  }
  std::vector<Box> others = valuesOfRanks(exchange, own);
  others.erase(others.begin() + exchange.rank());
  std::vector<Keyed<Vec3>> places;
  for (Id vertex = 0; vertex < vertices.size(); ++vertex)
  {
    if (std::any_of(others.begin(), others.end(),
          [&](const Box& box) { return box.holds(vertices[vertex]); }))
    {
      places.emplace_back(vertices[vertex], vertex);
    }
  }
  return places;
}

/// Gives vertices with equal keys the least label of these. Each key is looked after by one rank.
///
/// \returns whether a label on this rank has changed.
template <typename Key>
bool shareLeast(const std::vector<Keyed<Key>>& items, Exchange& exchange, RankLabels& labels)
{
  Questions questions(exchange);
  const auto ranks = static_cast<std::uint64_t>(exchange.numberOfRanks());
  for (const auto& [key, vertex] : items)
  {
    questions.ask(static_cast<int>(hashOf(key) % ranks), vertex, key, labels.of(vertex));
  }
  std::unordered_map<Key, KnownKey, Hash> known;
  bool hasChanged = false;
  questions.exchangeAnswers(
    [&](int rank, MessageReader& question)
    {
      const Key key = question.get<Key>();
      const auto label = question.get<Label>();
      KnownKey& entry = known.try_emplace(key, KnownKey{ label, rank }).first->second;
      entry.least = std::min(entry.least, label);
      entry.isShared = entry.isShared || entry.rank != rank;
    },
    [&](MessageReader& question, Message& answer)
    {
      const KnownKey& entry = known.at(question.get<Key>());
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
  const std::vector<std::pair<std::int64_t, Id>>& globalIds, Exchange& exchange)
{
  RankLabels labels;
  labels.labels.resize(vertices.size());
  for (Id vertex = 0; vertex < vertices.size(); ++vertex)
  {
    labels.labels[vertex] = (static_cast<Label>(exchange.rank()) << BitsOfVertex) | vertex;
  }
  std::vector<Keyed<Vec3>> places;
  if (byPlace)
  {
    places = placesNearOthers(vertices, exchange);
  }
  const bool byGlobalIds = exchange.isTrueAnywhere(!globalIds.empty());
  // Labels go on from a place to an id and from there to another place, until none changes. They
  // only fall, so that there is an end.
  bool hasChanged = byPlace || byGlobalIds;
  while (hasChanged)
  {
    hasChanged = byPlace && shareLeast(places, exchange, labels);
    hasChanged = (byGlobalIds && shareLeast(globalIds, exchange, labels)) || hasChanged;
    hasChanged = byPlace && byGlobalIds && exchange.isTrueAnywhere(hasChanged);
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
