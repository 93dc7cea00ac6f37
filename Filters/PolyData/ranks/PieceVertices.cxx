// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/PieceVertices.h"

#include "PolyData/Hash.h"
#include "Questions.h"
#include "mesh/Box.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

using Label = PieceVertices::Label;

/// What vertices have in common that are one: x, y, z, 0 of a place, or a global id, 0, 0, 1.
using VertexKey = std::array<double, 4>;
/// A key and a vertex that has it.
using KeyedVertex = std::pair<VertexKey, Id>;

constexpr int BitsOfVertex = 40;

/// What is known of a key by the rank that looks after it.
struct KnownKey
{
  Label least;
  int rank;
  bool isShared = false;
};

/// A global id and a vertex for each point; empty if points of any rank have no global ids.
std::vector<KeyedVertex> globalIds(const std::vector<PolyDataBlock>& inputs,
  const std::vector<SurfaceBlock>& blocks, const VertexOfPoint& vertexOf, Exchange& exchange)
{
  std::vector<KeyedVertex> ids;
  bool isComplete = true;
  for (std::size_t block = 0; block < blocks.size() && isComplete; ++block)
  {
    vtkPolyData* data = inputs[block].data;
    vtkDataArray* array = data->GetPointData()->GetGlobalIds();
    if (!array)
    {
      array = data->GetPointData()->GetArray("GlobalPointIds");
    }
    const vtkIdType count = data->GetNumberOfPoints();
    isComplete = count == 0 || (array && array->GetNumberOfTuples() >= count);
    for (vtkIdType i = 0; i < count && isComplete; ++i)
    {
      ids.push_back({ { array->GetComponent(i, 0), 0.0, 0.0, 1.0 },
        vertexOf(blocks[block].firstPoint + static_cast<Id>(i)) });
    }
  }
  if (exchange.isTrueAnywhere(!isComplete))
  {
    ids.clear();
  }
  return ids;
}

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
bool shareLeast(const std::vector<KeyedVertex>& keys, Exchange& exchange, PieceVertices& vertices)
{
  Questions questions(exchange);
  const auto ranks = static_cast<std::uint64_t>(exchange.numberOfRanks());
  for (const auto& [key, vertex] : keys)
  {
    questions.ask(static_cast<int>(hashOf(key) % ranks), vertex, key, vertices.labelOf(vertex));
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
      put(answer, entry.least | (entry.isShared ? PieceVertices::Shared : 0));
    },
    [&](std::size_t item, MessageReader& reader)
    {
      const auto answer = reader.get<Label>();
      const auto vertex = static_cast<Id>(item);
      const Label before = vertices.labelOf(vertex);
      const Label after = std::min(before, answer & ~PieceVertices::Shared);
      hasChanged = hasChanged || after != before;
      Label& label = vertices.labels[vertex];
      label = after | ((label | answer) & PieceVertices::Shared);
    });
  return hasChanged;
}

}

void PieceVertices::copy(
  const std::vector<Id>& some, std::vector<Vec3>& points, std::vector<Label>& keys) const
{
  for (const Id vertex : some)
  {
    points.push_back(this->positions[vertex]);
    keys.push_back(this->labelOf(vertex));
  }
}

void PieceVertices::join(const std::vector<Id>& same)
{
  std::vector<Label>& known = this->labels;
  std::vector<Id> numbers(same.size());
  Id count = 0;
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    if (same[vertex] == vertex)
    {
      this->positions[count] = this->positions[vertex];
      if (!known.empty())
      {
        known[count] = known[vertex];
      }
      numbers[vertex] = count++;
    }
  }
  if (count == same.size())
  {
    return;
  }
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    numbers[vertex] = numbers[same[vertex]];
  }
  this->positions.resize(count);
  known.resize(known.empty() ? 0 : count);
  this->of.renumber(std::move(numbers));
}

void PieceVertices::joinSameLabels()
{
  std::unordered_map<Label, Id> first;
  std::vector<Id> same(this->positions.size());
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    same[vertex] = this->isSharedAt(vertex)
      ? first.emplace(this->labelOf(vertex), vertex).first->second
      : vertex;
  }
  this->join(same);
}

void PieceVertices::joinRanks(const std::vector<PolyDataBlock>& inputs,
  const std::vector<SurfaceBlock>& blocks, bool byPlace, Exchange& exchange)
{
  if (exchange.numberOfRanks() == 1)
  {
    return;
  }
  std::vector<KeyedVertex> keys = globalIds(inputs, blocks, this->of, exchange);
  for (Id vertex = 0; vertex < this->positions.size(); ++vertex)
  {
    this->labels.push_back((static_cast<Label>(exchange.rank()) << BitsOfVertex) | vertex);
  }
  if (byPlace)
  {
    addPlacesNearOthers(this->positions, exchange, keys);
  }
  // Labels go on from a place to an id and from there to another place, until none changes. They
  // only fall, so that there is an end.
  while (exchange.isTrueAnywhere(shareLeast(keys, exchange, *this)))
  {
  }
  this->joinSameLabels();
}

std::vector<Id> PieceVertices::keepUsed(
  std::vector<Triangle>& faces, const Exchange& exchange, std::vector<Label>& keys)
{
  if (exchange.numberOfRanks() == 1)
  {
    return {};
  }
  std::vector<Id> numbers(this->positions.size(), NoId);
  const std::vector<Id> used = numberUsedVertices(faces, numbers.size());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    numbers[used[i]] = static_cast<Id>(i);
  }
  std::vector<Vec3> points;
  this->copy(used, points, keys);
  this->positions = std::move(points);
  return numbers;
}

// The rank with the lowest vertex of those with a label hears who has a face there.
BorrowedValues PieceVertices::valuesElsewhere(
  const std::vector<Id>& ownNumbers, Exchange& exchange) const
{
  constexpr RankAddress nobody{ -1, NoId };
  constexpr auto nowhere = ~std::size_t(0);
  std::vector<RankAddress> holders;
  Questions questions(exchange);
  for (Id vertex = 0; vertex < ownNumbers.size(); ++vertex)
  {
    const Id own = ownNumbers[vertex];
    if (this->isSharedAt(vertex))
    {
      const Label label = this->labelOf(vertex);
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
