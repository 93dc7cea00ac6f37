// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/RankSeams.h"

#include "PolyData/Hash.h"
#include "Questions.h"
#include "Tolerance.h"
#include "mesh/Box.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace geodesic
{

namespace
{

using Label = RankSeams::Label;

/// A vertex that other ranks have, too, in the answer with its label.
constexpr Label SharedFlag = Label(1) << 63;

/// \param margin to all sides of the point.
Box boxAround(const Vec3& point, double margin)
{
  const Vec3 margins = { margin, margin, margin };
  return { point - margins, point + margins };
}

/// The boxes of the other ranks.
std::vector<Box> boxesOfOthers(const Box& own, Exchange& exchange)
{
  std::vector<Box> boxes = valuesOfRanks(exchange, own);
  boxes.erase(boxes.begin() + exchange.rank());
  return boxes;
}

bool isNearAny(const std::vector<Box>& boxes, const Vec3& point, double margin = 0.0)
{
  const Box around = boxAround(point, margin);
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return box.meets(around); });
}

template <typename Key>
struct HashOfKey
{
  std::size_t operator()(const Key& key) const { return static_cast<std::size_t>(hashOf(key)); }
};

/// What is known of a key by the rank that looks after it.
struct KnownKey
{
  Label least;
  int rank;
  bool isShared = false;
};

} // anonymous namespace

RankSeams::RankSeams(const std::vector<Vec3>& vertices, Exchange& exchange)
  : vertices_(vertices)
  , exchange_(exchange)
{
  this->labels_.labels.resize(vertices.size());
  this->labels_.isShared.resize(vertices.size(), 0);
  for (Id vertex = 0; vertex < vertices.size(); ++vertex)
  {
    this->labels_.labels[vertex] = makeLabel(exchange.rank(), vertex);
  }
}

void RankSeams::joinSame(bool byPlace, const std::vector<std::pair<std::int64_t, Id>>& globalIds)
{
  std::vector<std::pair<Vec3, Id>> places;
  if (byPlace)
  {
    for (const Id vertex : this->verticesNearOthers())
    {
      places.emplace_back(this->vertices_[vertex], vertex);
    }
  }
  const bool byGlobalIds = this->exchange_.isTrueAnywhere(!globalIds.empty());
  // Labels go on from a place to an id and from there to another place, until none changes. They
  // only fall, so that there is an end.
  bool hasChanged = byPlace || byGlobalIds;
  while (hasChanged)
  {
    hasChanged = byPlace && this->shareLeast(places);
    hasChanged = (byGlobalIds && this->shareLeast(globalIds)) || hasChanged;
    hasChanged = byPlace && byGlobalIds && this->exchange_.isTrueAnywhere(hasChanged);
  }
}

/// Those that another rank can have, by its bounding box.
std::vector<Id> RankSeams::verticesNearOthers() const
{
  Box own;
  for (const Vec3& p : this->vertices_)
  {
    own.add(p);
  }
  const std::vector<Box> boxes = boxesOfOthers(own, this->exchange_);
  std::vector<Id> near;
  for (Id vertex = 0; vertex < this->vertices_.size(); ++vertex)
  {
    if (isNearAny(boxes, this->vertices_[vertex]))
    {
      near.push_back(vertex);
    }
  }
  return near;
}

/// Gives vertices with equal keys the least label of these. Each key is looked after by one rank.
///
/// \returns whether a label on this rank has changed.
template <typename Key>
bool RankSeams::shareLeast(const std::vector<std::pair<Key, Id>>& items)
{
  Questions questions(this->exchange_);
  const auto ranks = static_cast<std::uint64_t>(this->exchange_.numberOfRanks());
  for (const auto& [key, vertex] : items)
  {
    questions.ask(static_cast<int>(hashOf(key) % ranks), vertex, key, this->labels_.labels[vertex]);
  }
  std::unordered_map<Key, KnownKey, HashOfKey<Key>> known;
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
      put(answer, entry.least | (entry.isShared ? SharedFlag : 0));
    },
    [&](std::size_t vertex, MessageReader& answer)
    {
      const auto label = answer.get<Label>();
      if ((label & ~SharedFlag) < this->labels_.labels[vertex])
      {
        this->labels_.labels[vertex] = label & ~SharedFlag;
        hasChanged = true;
      }
      if (label & SharedFlag)
      {
        this->labels_.isShared[vertex] = 1;
      }
    });
  return hasChanged;
}

/// The places of the ghosts of all ranks.
GhostPlaces RankSeams::gatherGhosts(const SeamBlock& piece) const
{
  Message message;
  for (const Id vertex : ghostVertices(piece))
  {
    put(message, this->vertices_[vertex]);
  }
  GhostPlaces places(this->exchange_.largestOf(largestTolerance(this->vertices_, { piece })));
  readEach(this->exchange_.tellAll(message),
    [&](int, MessageReader& reader) { places.add(reader.get<Vec3>()); });
  return places;
}

/// The vertices of all pieces that may have to be joined with another piece's, the same on all
/// ranks, in the order of their labels.
std::vector<SeamVertex> RankSeams::gatherSeams(const SeamBlock& piece) const
{
  struct Entry
  {
    Vec3 position;
    Label label;
    double rounding;
    double shortestEdge;
    std::uint8_t hasFace;
    std::uint8_t isOnBoundary;
    std::uint8_t isAtGhost;
  };
  const std::vector<SeamVertex> own =
    findSeamVertices(this->vertices_, { piece }, this->gatherGhosts(piece));
  Box box;
  for (const SeamVertex& vertex : own)
  {
    box.add(boxAround(vertex.position, vertex.tolerance()));
  }
  const std::vector<Box> boxes = boxesOfOthers(box, this->exchange_);
  Message message;
  for (const SeamVertex& vertex : own)
  {
    if (isNearAny(boxes, vertex.position, vertex.tolerance()))
    {
      put(message,
        Entry{ vertex.position, this->labels_.labels[static_cast<Id>(vertex.vertex)],
          vertex.rounding, vertex.shortestEdge, !vertex.blocks.empty(), vertex.isOnBoundary,
          vertex.isAtGhost });
    }
  }
  std::map<Label, SeamVertex> all;
  readEach(this->exchange_.tellAll(message),
    [&](int rank, MessageReader& reader)
    {
      const Entry entry = reader.get<Entry>();
      const auto [at, isNew] = all.try_emplace(entry.label);
      SeamVertex& vertex = at->second;
      if (isNew)
      {
        vertex.vertex = entry.label;
        vertex.position = entry.position;
      }
      const bool isOfRank = !vertex.blocks.empty() && vertex.blocks.back() == rankIndex(rank);
      if (entry.hasFace != 0 && !isOfRank)
      {
        vertex.blocks.push_back(rankIndex(rank));
      }
      vertex.isOnBoundary = vertex.isOnBoundary || entry.isOnBoundary != 0;
      vertex.isAtGhost = vertex.isAtGhost || entry.isAtGhost != 0;
      vertex.rounding = std::max(vertex.rounding, entry.rounding);
      vertex.shortestEdge = std::min(vertex.shortestEdge, entry.shortestEdge);
    });
  std::vector<SeamVertex> sorted;
  sorted.reserve(all.size());
  for (auto& [label, vertex] : all)
  {
    sorted.push_back(std::move(vertex));
  }
  return sorted;
}

/// Those faces that can have a vertex near one of another rank. Edges that are boundary among these
/// only are not near any.
SeamBlock RankSeams::facesNearOthers(SeamBlock piece) const
{
  double largest = 0.0;
  for (const Vec3& p : this->vertices_)
  {
    largest = std::max(largest, largestCoordinate(p));
  }
  const double margin = tolerance::SeamRoundings * piece.precision * largest;
  Box own;
  for (const auto* triangles : { &piece.triangles, &piece.ghosts })
  {
    for (const Triangle& triangle : *triangles)
    {
      for (const Id vertex : triangle)
      {
        own.add(boxAround(this->vertices_[vertex], margin));
      }
    }
  }
  const std::vector<Box> boxes = boxesOfOthers(own, this->exchange_);
  const auto isFar = [&](const Triangle& triangle)
  {
    return std::none_of(triangle.begin(), triangle.end(),
      [&](Id vertex) { return isNearAny(boxes, this->vertices_[vertex], margin); });
  };
  for (auto* triangles : { &piece.triangles, &piece.ghosts })
  {
    triangles->erase(std::remove_if(triangles->begin(), triangles->end(), isFar), triangles->end());
  }
  return piece;
}

std::uint64_t RankSeams::joinNear(SeamBlock piece)
{
  const std::vector<SeamVertex> seams = this->gatherSeams(this->facesNearOthers(std::move(piece)));
  const std::vector<std::size_t> roots = joinSeamVertices(seams);
  std::map<Label, Label> joined;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < roots.size(); ++i)
  {
    if (roots[i] != i)
    {
      joined.emplace(seams[i].vertex, seams[roots[i]].vertex);
      // The one that they are joined with is shared then, too.
      joined.emplace(seams[roots[i]].vertex, seams[roots[i]].vertex);
      count += seams[i].blocks.empty() ? 0 : 1;
    }
  }
  if (!joined.empty())
  {
    for (Id vertex = 0; vertex < this->labels_.labels.size(); ++vertex)
    {
      const auto found = joined.find(this->labels_.labels[vertex]);
      if (found != joined.end())
      {
        this->labels_.labels[vertex] = found->second;
        this->labels_.isShared[vertex] = 1;
      }
    }
  }
  return count;
}

}
