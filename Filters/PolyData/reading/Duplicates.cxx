// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/Duplicates.h"

#include "PolyData/Hash.h"
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

/// Of cells that were cut into several triangles, takes the cut of an original over to its
/// duplicates.
class CutCopier
{
public:
  CutCopier(const VertexOfPoint& vertexOf, TriangleList& triangles)
    : vertexOf_(vertexOf)
    , triangles_(triangles)
  {
  }

  void run()
  {
    this->forEachCut(true,
      [this](std::size_t first, std::size_t last)
      { this->duplicates_[this->verticesOf(first, last)].push_back(first); });
    if (this->duplicates_.empty())
    {
      return;
    }
    this->forEachCut(false,
      [this](std::size_t first, std::size_t last)
      {
        const auto found = this->duplicates_.find(this->verticesOf(first, last));
        if (found == this->duplicates_.end())
        {
          return;
        }
        for (const std::size_t duplicate : found->second)
        {
          this->copy(first, last, duplicate);
        }
      });
  }

private:
  /// Calls with the first triangle of each cell that has several, and the one after its last.
  template <typename Visitor>
  void forEachCut(bool marked, Visitor&& visit)
  {
    this->triangles_.forEachCell(
      [&](std::size_t first, std::size_t last)
      {
        if (last > first + 1 && this->triangles_.isDuplicate[first] == marked)
        {
          visit(first, last);
        }
      });
  }

  std::vector<Id> verticesOf(std::size_t first, std::size_t last) const
  {
    std::set<Id> vertices;
    for (std::size_t i = first; i < last; ++i)
    {
      for (const Id point : this->triangles_.corners[i])
      {
        vertices.insert(this->vertexOf_(point));
      }
    }
    return { vertices.begin(), vertices.end() };
  }

  /// Cells on the same corners have as many triangles, unless they touch themselves.
  void copy(std::size_t first, std::size_t last, std::size_t duplicate)
  {
    std::map<Id, Id> ownPoints;
    const std::size_t count = last - first;
    const auto& cells = this->triangles_.cells;
    if (duplicate + count > cells.size() || cells[duplicate + count - 1] != cells[duplicate])
    {
      return;
    }
    for (std::size_t i = duplicate; i < duplicate + count; ++i)
    {
      for (const Id point : this->triangles_.corners[i])
      {
        ownPoints.emplace(this->vertexOf_(point), point);
      }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      Triangle triangle = this->triangles_.corners[first + i];
      for (Id& corner : triangle)
      {
        const auto own = ownPoints.find(this->vertexOf_(corner));
        if (own == ownPoints.end())
        {
          return;
        }
        corner = own->second;
      }
      this->triangles_.corners[duplicate + i] = triangle;
    }
  }

  const VertexOfPoint& vertexOf_;
  TriangleList& triangles_;
  std::map<std::vector<Id>, std::vector<std::size_t>> duplicates_;
};

/// Marks the triangles that are copies of others of this rank.
std::vector<std::uint8_t> findCopiesHere(const VertexOfPoint& vertexOf, TriangleList& triangles)
{
  CutCopier(vertexOf, triangles).run();
  const auto sortedVertices = [&](std::size_t i)
  {
    Triangle vertices = vertexOf(triangles.corners[i]);
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  };
  // The vertices of marked triangles, and whether an original is there.
  std::map<Triangle, bool> isTaken;
  for (std::size_t i = 0; i < triangles.corners.size(); ++i)
  {
    if (triangles.isDuplicate[i])
    {
      isTaken.emplace(sortedVertices(i), false);
    }
  }
  for (std::size_t i = 0; i < triangles.corners.size(); ++i)
  {
    const auto place = triangles.isDuplicate[i] ? isTaken.end() : isTaken.find(sortedVertices(i));
    if (place != isTaken.end())
    {
      place->second = true;
    }
  }
  std::vector<std::uint8_t> isCopy(triangles.corners.size(), 0);
  for (std::size_t i = 0; i < triangles.corners.size(); ++i)
  {
    if (triangles.isDuplicate[i])
    {
      isCopy[i] = std::exchange(isTaken[sortedVertices(i)], true) ? 1 : 0;
    }
  }
  return isCopy;
}

/// The vertices of a cell, as two numbers that no other cell has.
using CellKey = std::array<std::uint64_t, 2>;

/// \param labels of the cell's corners.
CellKey keyOf(std::vector<RankLabels::Label> labels)
{
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  const std::uint64_t hash = hashOf(labels.data(), labels.size());
  labels.push_back(~hash);
  return { hash, hashOf(labels.data(), labels.size()) };
}

/// Marks the triangles that are copies of other ranks' cells.
void findCopiesOfOthers(const RankLabels& labels, const VertexOfPoint& vertexOf,
  const TriangleList& triangles, std::vector<std::uint8_t>& isCopy, Exchange& exchange)
{
  Questions questions(exchange);
  std::vector<std::pair<std::size_t, std::size_t>> cells;
  triangles.forEachCell(
    [&](std::size_t first, std::size_t last)
    {
      std::vector<RankLabels::Label> corners;
      bool areAllShared = isCopy[first] == 0;
      for (std::size_t i = first; i < last; ++i)
      {
        for (const Id point : triangles.corners[i])
        {
          areAllShared = areAllShared && labels.isSharedAt(vertexOf(point));
          corners.push_back(labels.of(vertexOf(point)));
        }
      }
      if (areAllShared) // else no other rank has such a cell
      {
        const CellKey key = keyOf(std::move(corners));
        const auto ranks = static_cast<std::uint64_t>(exchange.numberOfRanks());
        questions.ask(static_cast<int>(key[1] % ranks), cells.size(), key,
          std::uint8_t(triangles.isDuplicate[first] ? 1 : 0));
        cells.emplace_back(first, last);
      }
    });
  std::map<CellKey, bool> isTaken;
  questions.exchangeAnswers(
    [&](int, MessageReader& question)
    {
      bool& taken = isTaken[question.get<CellKey>()];
      taken = question.get<std::uint8_t>() == 0 || taken;
    },
    [&](MessageReader& question, Message& answer)
    {
      bool& taken = isTaken[question.get<CellKey>()];
      const bool isMarked = question.get<std::uint8_t>() != 0;
      put(answer, std::uint8_t(isMarked && taken ? 1 : 0));
      taken = true;
    },
    [&](std::size_t cell, MessageReader& answer)
    {
      if (answer.get<std::uint8_t>() != 0)
      {
        const auto begin = isCopy.begin();
        std::fill(begin + static_cast<std::ptrdiff_t>(cells[cell].first),
          begin + static_cast<std::ptrdiff_t>(cells[cell].second), std::uint8_t(1));
      }
    });
}

} // anonymous namespace

std::vector<std::uint8_t> findCopies(const RankLabels& labels, const VertexOfPoint& vertexOf,
  TriangleList& triangles, Exchange& exchange)
{
  if (!exchange.isTrueAnywhere(triangles.hasDuplicates()))
  {
    return {};
  }
  std::vector<std::uint8_t> isCopy = findCopiesHere(vertexOf, triangles);
  findCopiesOfOthers(labels, vertexOf, triangles, isCopy, exchange);
  const bool isAny = std::find(isCopy.begin(), isCopy.end(), 1) != isCopy.end();
  return isAny ? isCopy : std::vector<std::uint8_t>();
}

}
