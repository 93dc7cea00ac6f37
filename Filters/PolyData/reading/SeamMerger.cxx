// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SeamMerger.h"

#include "PolyData/Hash.h"
#include "Tolerance.h"
#include "mesh/Box.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace geodesic
{

namespace
{

using Label = RankLabels::Label;

/// How far two vertices may be apart that are one.
struct Limits
{
  double mergeTolerance;

  double between(const SeamVertex& a, const SeamVertex& b) const
  {
    const double edge = std::min(a.shortestEdge, b.shortestEdge);
    const double rounding =
      std::min(std::max(a.tolerance(), b.tolerance()), tolerance::SeamFraction * edge);
    const bool areOnBoundary = a.isOnBoundary && b.isOnBoundary;
    return a.hasFace && b.hasFace && !areOnBoundary ? -1.0
      : areOnBoundary                               ? std::max(rounding, this->ofMerging(edge))
                                                    : rounding;
  }

  /// Between the vertex and any other with the same tolerance or a smaller one.
  double at(const SeamVertex& a) const
  {
    return std::max({ std::min(a.tolerance(), tolerance::SeamFraction * a.shortestEdge),
      this->ofMerging(a.shortestEdge),
      tolerance::Rounding * largestCoordinate(a.position) }); // cells can be numbered
  }

private:
  double ofMerging(double edge) const
  {
    return std::min(this->mergeTolerance, tolerance::MergeFraction * edge);
  }
};

/// Two vertices by their distance.
using Pair = std::tuple<double, std::size_t, std::size_t>;

/// The pairs of vertices that are close, nearest first. A vertex is looked for among those whose
/// limit is as large or larger: for each power of two there is a grid of cells that large, so that
/// the coarse coordinates of one block do not crowd the fine ones of another into one cell.
std::vector<Pair> closePairs(const std::vector<SeamVertex>& vertices, const Limits& limits)
{
  std::unordered_map<SeamCell, std::vector<std::size_t>, Hash> grid;
  std::set<int> levels;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const int level = *levels.insert(seamLevelFor(limits.at(vertices[i]))).first;
    grid[seamCellAt(vertices[i].position, level)].push_back(i);
  }
  std::vector<Pair> pairs;
  const auto lookInto = [&](const SeamCell& cell, std::size_t i)
  {
    const auto found = grid.find(cell);
    for (std::size_t k = 0; found != grid.end() && k < found->second.size(); ++k)
    {
      const std::size_t j = found->second[k];
      const double distance = norm(vertices[i].position - vertices[j].position);
      if (i != j && distance <= limits.between(vertices[i], vertices[j]))
      {
        pairs.emplace_back(distance, std::min(i, j), std::max(i, j));
      }
    }
  };
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const auto least = levels.find(seamLevelFor(limits.at(vertices[i])));
    for (auto level = least; level != levels.end(); ++level)
    {
      for (const SeamCell& cell : seamCellsAround(vertices[i].position, *level))
      {
        lookInto(cell, i);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The vertices of all ranks that have another close by, in the order of their labels and then of
/// the ranks: those that have one here, and those near the other ranks'.
std::vector<SeamVertex> gatherClose(
  const std::vector<SeamVertex>& own, const Limits& limits, Exchange& exchange)
{
  std::vector<char> isWanted(own.size(), 0);
  for (const auto& [distance, a, b] : closePairs(own, limits))
  {
    isWanted[a] = isWanted[b] = 1;
  }
  Box box;
  for (const SeamVertex& vertex : own)
  {
    box.add(boxAround(vertex.position, limits.at(vertex)));
  }
  const OtherRanks others(box, exchange);
  std::vector<SeamVertex> wanted;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    if (isWanted[i] != 0 || others.areNear(own[i].position, limits.at(own[i])))
    {
      wanted.push_back(own[i]);
    }
  }
  std::vector<SeamVertex> all = valuesOfRanks(exchange, wanted);
  std::stable_sort(all.begin(), all.end(),
    [](const SeamVertex& a, const SeamVertex& b) { return a.label < b.label; });
  return all;
}

/// Makes one of what several ranks know of a vertex, whose entries follow each other.
std::vector<SeamVertex> combineRanks(const std::vector<SeamVertex>& parts)
{
  std::vector<SeamVertex> vertices;
  for (const SeamVertex& part : parts)
  {
    if (vertices.empty() || vertices.back().label != part.label)
    {
      vertices.push_back(part);
      continue;
    }
    SeamVertex& vertex = vertices.back();
    vertex.block = std::min(vertex.block, part.block);
    vertex.hasFace = vertex.hasFace || part.hasFace;
    vertex.isOnBoundary = vertex.isOnBoundary || part.isOnBoundary;
    vertex.rounding = std::max(vertex.rounding, part.rounding);
    vertex.shortestEdge = std::min(vertex.shortestEdge, part.shortestEdge);
  }
  return vertices;
}

/// Groups of vertices that are all close to each other.
class Groups
{
public:
  Groups(const std::vector<SeamVertex>& vertices, const Limits& limits)
    : vertices_(vertices)
    , limits_(limits)
    , groups_(vertices.size())
    , groupOf_(vertices.size())
  {
    std::iota(this->groupOf_.begin(), this->groupOf_.end(), std::size_t(0));
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      this->groups_[i] = { i };
    }
  }

  /// Makes one group of those of two vertices, if all of them are close.
  void join(std::size_t a, std::size_t b)
  {
    std::vector<std::size_t>& first = this->groups_[this->groupOf_[a]];
    std::vector<std::size_t>& second = this->groups_[this->groupOf_[b]];
    if (&first == &second || !this->areClose(first, second))
    {
      return;
    }
    for (const std::size_t i : second)
    {
      this->groupOf_[i] = this->groupOf_[a];
    }
    first.insert(first.end(), second.begin(), second.end());
    second.clear();
  }

  JoinedVertices joined() const
  {
    JoinedVertices result;
    for (const std::vector<std::size_t>& group : this->groups_)
    {
      if (group.size() < 2)
      {
        continue;
      }
      const auto order = [this](std::size_t i)
      {
        const SeamVertex& vertex = this->vertices_[i];
        return std::tie(vertex.block, vertex.position, vertex.label); // without faces: the last
      };
      const SeamVertex& first = this->vertices_[*std::min_element(group.begin(), group.end(),
        [&order](std::size_t i, std::size_t j) { return order(i) < order(j); })];
      std::uint64_t withFaces = 0;
      for (const std::size_t i : group)
      {
        const SeamVertex& vertex = this->vertices_[i];
        result.same.emplace(vertex.label, JoinedVertex{ first.label, first.position });
        withFaces += vertex.hasFace ? 1 : 0;
      }
      result.count += std::max<std::uint64_t>(withFaces, 1) - 1;
    }
    return result;
  }

private:
  bool areClose(const std::vector<std::size_t>& some, const std::vector<std::size_t>& others) const
  {
    return std::all_of(some.begin(), some.end(),
      [&](std::size_t i)
      {
        return std::all_of(others.begin(), others.end(),
          [&](std::size_t j)
          {
            const SeamVertex& a = this->vertices_[i];
            const SeamVertex& b = this->vertices_[j];
            return norm(a.position - b.position) <= this->limits_.between(a, b);
          });
      });
  }

  const std::vector<SeamVertex>& vertices_;
  const Limits& limits_;
  std::vector<std::vector<std::size_t>> groups_;
  std::vector<std::size_t> groupOf_;
};

}

JoinedVertices mergeSeams(const SeamSurface& surface, Exchange& exchange)
{
  const Limits limits{ surface.mergeTolerance };
  std::vector<SeamVertex> vertices = findSeamVertices(surface, exchange);
  if (exchange.numberOfRanks() > 1)
  {
    vertices = combineRanks(gatherClose(vertices, limits, exchange));
  }
  Groups groups(vertices, limits);
  for (const auto& [distance, a, b] : closePairs(vertices, limits))
  {
    groups.join(a, b);
  }
  return groups.joined();
}

}
