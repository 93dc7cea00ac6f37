// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PieceVertices_h
#define geodesic_PieceVertices_h

#include "PolyData/ranks/RankSeams.h"
#include "PolyData/reading/PolyDataSurface.h"

#include <unordered_map>
#include <utility>
#include <vector>

namespace geodesic
{

/// The vertices of this rank's blocks.
struct PieceVertices
{
  using Label = RankLabels::Label;

  std::vector<Vec3> positions;
  VertexOfPoint of;
  RankLabels labels;

  /// Appends the places and the labels of some vertices.
  void copy(const std::vector<Id>& some, std::vector<Vec3>& points, std::vector<Label>& keys) const
  {
    for (const Id vertex : some)
    {
      points.push_back(this->positions[vertex]);
      keys.push_back(this->labels.of(vertex));
    }
  }

  /// Makes one vertex of those that are the same.
  ///
  /// \param same for each vertex the one of the same that stays.
  void join(const std::vector<Id>& same)
  {
    std::vector<Label>& known = this->labels.labels;
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

  /// Makes one vertex of those with the same label, if ranks share any.
  void joinSameLabels()
  {
    std::unordered_map<Label, Id> first;
    std::vector<Id> same(this->positions.size());
    for (Id vertex = 0; vertex < same.size(); ++vertex)
    {
      same[vertex] = this->labels.isSharedAt(vertex)
        ? first.emplace(this->labels.of(vertex), vertex).first->second
        : vertex;
    }
    this->join(same);
  }
};

}

#endif
