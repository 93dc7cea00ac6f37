// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/Hash.h"
#include "PolyData/reading/TriangleReader.h"
#include "Questions.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace geodesic
{

namespace
{

using Label = RankLabels::Label;

using Range = TriangleList::Range;

std::vector<Id> verticesOf(
  const Range& cell, const VertexOfPoint& vertexOf, const TriangleList& triangles)
{
  std::set<Id> vertices;
  for (std::size_t i = cell.first; i < cell.second; ++i)
  {
    const Triangle corners = vertexOf(triangles.corners[i]);
    vertices.insert(corners.begin(), corners.end());
  }
  return { vertices.begin(), vertices.end() };
}

/// Cells on the same vertices have as many triangles, unless they touch themselves.
void copyCut(const Range& original, const Range& duplicate, const VertexOfPoint& vertexOf,
  TriangleList& triangles)
{
  const std::size_t count = original.second - original.first;
  if (duplicate.second - duplicate.first < count)
  {
    return;
  }
  std::map<Id, Id> ownPoints;
  for (std::size_t i = duplicate.first; i < duplicate.first + count; ++i)
  {
    for (const Id point : triangles.corners[i])
    {
      ownPoints.emplace(vertexOf(point), point);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    Triangle triangle = triangles.corners[original.first + i];
    for (Id& corner : triangle)
    {
      const auto own = ownPoints.find(vertexOf(corner));
      if (own == ownPoints.end())
      {
        return;
      }
      corner = own->second;
    }
    triangles.corners[duplicate.first + i] = triangle;
  }
}

/// Of cells that were cut into several triangles, takes the cut of an original over to its
/// duplicates.
void copyCuts(const VertexOfPoint& vertexOf, TriangleList& triangles)
{
  const auto forEachCut = [&triangles](bool isMarked, const auto& visit)
  {
    triangles.forEachCell(
      [&](const Range& cell)
      {
        if (cell.second > cell.first + 1 && triangles.isDuplicate[cell.first] == isMarked)
        {
          visit(cell);
        }
      });
  };
  std::map<std::vector<Id>, std::vector<Range>> duplicates;
  forEachCut(true,
    [&](const Range& cell) { duplicates[verticesOf(cell, vertexOf, triangles)].push_back(cell); });
  if (duplicates.empty())
  {
    return;
  }
  forEachCut(false,
    [&](const Range& cell)
    {
      const auto found = duplicates.find(verticesOf(cell, vertexOf, triangles));
      if (found != duplicates.end())
      {
        for (const Range& duplicate : found->second)
        {
          copyCut(cell, duplicate, vertexOf, triangles);
        }
      }
    });
}

/// \param labels of the cell's corners.
Fingerprint keyOf(std::vector<Label> labels)
{
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  Fingerprint key{};
  addWord(labels.size(), key);
  for (const Label label : labels)
  {
    addWord(label, key);
  }
  return key;
}

/// Finds the marked ones among cells on the same vertices that are copies.
class CopyFinder
{
public:
  CopyFinder(const TriangleList& triangles, Exchange& exchange)
    : triangles_(triangles)
    , exchange_(exchange)
    , questions_(exchange)
  {
  }

  /// Adds a cell.
  ///
  /// \param labelOf of a point that another cell can have, too: (Id) -> Label; NoLabel for others.
  template <typename LabelOf>
  void add(const Range& cell, const LabelOf& labelOf)
  {
    std::vector<Label> labels;
    for (std::size_t i = cell.first; i < cell.second; ++i)
    {
      for (const Id point : this->triangles_.corners[i])
      {
        const Label label = labelOf(point);
        if (label == NoLabel)
        {
          return; // no other cell has all these vertices
        }
        labels.push_back(label);
      }
    }
    const Fingerprint key = keyOf(std::move(labels));
    const auto ranks = static_cast<std::uint64_t>(this->exchange_.numberOfRanks());
    this->questions_.ask(static_cast<int>(key[1] % ranks), this->cells_.size(), key,
      bool(this->triangles_.isDuplicate[cell.first]));
    this->cells_.push_back(cell);
  }

  /// Marks the copies among the cells of all ranks, which call this together.
  void find(std::vector<TriangleRole>& roles)
  {
    std::map<Fingerprint, bool> isTaken;
    this->questions_.exchangeAnswers(
      [&](int, MessageReader& question)
      {
        bool& taken = isTaken[question.get<Fingerprint>()];
        taken = !question.get<bool>() || taken;
      },
      [&](MessageReader& question, Message& answer)
      {
        bool& taken = isTaken[question.get<Fingerprint>()];
        const bool isMarked = question.get<bool>();
        put(answer, isMarked && taken);
        taken = true;
      },
      [&](std::size_t cell, MessageReader& answer)
      {
        const auto [first, last] = this->cells_[cell];
        if (answer.get<bool>())
        {
          std::fill(roles.begin() + std::ptrdiff_t(first), roles.begin() + std::ptrdiff_t(last),
            TriangleRole::Copy);
        }
      });
  }

  static constexpr Label NoLabel = ~Label(0);

private:
  const TriangleList& triangles_;
  Exchange& exchange_;
  Questions questions_;
  std::vector<Range> cells_;
};

/// Marks the triangles that are copies of others of this rank.
void findCopiesHere(
  const VertexOfPoint& vertexOf, const TriangleList& triangles, std::vector<TriangleRole>& roles)
{
  std::set<Id> marked;
  for (std::size_t i = 0; i < triangles.corners.size(); ++i)
  {
    if (triangles.isDuplicate[i])
    {
      const Triangle vertices = vertexOf(triangles.corners[i]);
      marked.insert(vertices.begin(), vertices.end());
    }
  }
  const auto labelOf = [&](Id point)
  { return marked.count(vertexOf(point)) > 0 ? Label(vertexOf(point)) : CopyFinder::NoLabel; };
  CopyFinder finder(triangles, OneRank::instance());
  for (std::size_t i = 0; i < triangles.corners.size() && !marked.empty(); ++i)
  {
    finder.add({ i, i + 1 }, labelOf);
  }
  finder.find(roles);
}

/// Marks the triangles that are copies of other ranks' cells.
void findCopiesOfOthers(const RankLabels& labels, const VertexOfPoint& vertexOf,
  const TriangleList& triangles, Exchange& exchange, std::vector<TriangleRole>& roles)
{
  const auto labelOf = [&](Id point)
  {
    const Id vertex = vertexOf(point);
    return labels.isSharedAt(vertex) ? labels.of(vertex) : CopyFinder::NoLabel;
  };
  CopyFinder finder(triangles, exchange);
  triangles.forEachCell(
    [&](const Range& cell)
    {
      if (roles[cell.first] != TriangleRole::Copy)
      {
        finder.add(cell, labelOf);
      }
    });
  finder.find(roles);
}

} // anonymous namespace

std::vector<TriangleRole> findCopies(const RankLabels& labels, const VertexOfPoint& vertexOf,
  TriangleList& triangles, Exchange& exchange)
{
  const std::vector<bool>& marks = triangles.isDuplicate;
  if (!exchange.isTrueAnywhere(std::find(marks.begin(), marks.end(), true) != marks.end()))
  {
    return {};
  }
  std::vector<TriangleRole> roles(triangles.corners.size(), TriangleRole::Open);
  copyCuts(vertexOf, triangles);
  findCopiesHere(vertexOf, triangles, roles);
  findCopiesOfOthers(labels, vertexOf, triangles, exchange, roles);
  const bool isAny = std::find(roles.begin(), roles.end(), TriangleRole::Copy) != roles.end();
  return isAny ? roles : std::vector<TriangleRole>();
}

}
