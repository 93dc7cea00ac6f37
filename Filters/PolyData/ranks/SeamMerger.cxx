// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/Hash.h"
#include "PolyData/ranks/RankSeams.h"
#include "Tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace geodesic
{

namespace
{

using Label = RankLabels::Label;

/// A cube of a grid whose edges are a power of two, the last number.
using Cell = std::array<std::int64_t, 4>;

/// The least cubes that are twice as large as a distance, or larger.
int levelFor(double distance)
{
  return std::ilogb(distance) + 2;
}

/// \param shift of the point, in cubes.
Cell cellAt(const Vec3& point, int level, double shift = 0.0)
{
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    cell[k] = static_cast<std::int64_t>(std::floor(std::ldexp(point[k], -level) + shift));
  }
  cell[3] = level;
  return cell;
}

/// The cubes that have all points whose coordinates differ by at most half a cube.
std::array<Cell, 8> cellsAround(const Vec3& point, int level)
{
  std::array<Cell, 8> cells;
  cells.fill(cellAt(point, level, -0.5));
  for (std::size_t side = 0; side < cells.size(); ++side)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      cells[side][k] += static_cast<std::int64_t>(side >> k & 1U);
    }
  }
  return cells;
}

using Cells = std::unordered_set<Cell, Hash>;

/// The cubes of a level that have all points near a corner of a ghost of any rank: all points whose
/// coordinates differ by at most half a cube.
Cells cellsNearGhosts(const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks,
  int level, Exchange& exchange)
{
  std::set<Id> corners;
  for (const SeamBlock& block : blocks)
  {
    for (const Triangle& triangle : block.ghosts)
    {
      corners.insert(triangle.begin(), triangle.end());
    }
  }
  Message message;
  for (const Id vertex : corners)
  {
    put(message, vertices[vertex]);
  }
  Cells near;
  readEach(exchange.tellAll(message),
    [&](int, MessageReader& reader)
    {
      const std::array<Cell, 8> cells = cellsAround(reader.get<Vec3>(), level);
      near.insert(cells.begin(), cells.end());
    });
  return near;
}

/// A vertex of a block: on its boundary, at a ghost, or near one.
struct VertexOfBlock
{
  Label label;
  Vec3 position;
  std::size_t block;
  /// Whether the block has a triangle there; it may have ghosts only.
  bool hasFace = false;
  bool isOnBoundary = false;
  /// Whether it is a corner of a ghost.
  bool isAtGhost = false;
  /// The rounding of coordinates around.
  double rounding = 0.0;
  double shortestEdge = Infinity;

  /// How far it may be from another to be one with it.
  double tolerance() const { return tolerance::SeamRoundings * this->rounding; }
};

using Edge = std::array<Id, 2>;

std::vector<Edge> sortedEdges(const std::vector<Triangle>& triangles)
{
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({ low, high });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The vertices of a block that may have to be joined with others.
///
/// \param number of the block.
/// \param isNearGhost whether a place may be within a tolerance of a ghost's corner.
template <typename IsNearGhost>
std::vector<VertexOfBlock> verticesOf(std::size_t number, const SeamBlock& block,
  const std::vector<Vec3>& vertices, const RankLabels& labels, const IsNearGhost& isNearGhost)
{
  std::vector<VertexOfBlock> entries;
  std::unordered_map<Id, std::size_t> numbers;
  const auto entryOf = [&](Id vertex, const Edge& edge) -> VertexOfBlock&
  {
    const auto [place, isNew] = numbers.emplace(vertex, entries.size());
    if (isNew)
    {
      entries.push_back({ labels.of(vertex), vertices[vertex], number });
    }
    VertexOfBlock& entry = entries[place->second];
    const Vec3& a = vertices[edge[0]];
    const Vec3& b = vertices[edge[1]];
    entry.rounding = std::max(
      entry.rounding, block.precision * std::max(largestCoordinate(a), largestCoordinate(b)));
    entry.shortestEdge = std::min(entry.shortestEdge, norm(b - a));
    return entry;
  };
  const std::vector<Edge> edges = sortedEdges(block.triangles);
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto last = std::upper_bound(first, edges.end(), *first);
    const bool isBoundary = last - first == 1;
    for (const Id vertex : *first)
    {
      if (isBoundary || isNearGhost(vertices[vertex]))
      {
        VertexOfBlock& entry = entryOf(vertex, *first);
        entry.hasFace = true;
        entry.isOnBoundary = entry.isOnBoundary || isBoundary;
      }
    }
    first = last;
  }
  for (const Edge& edge : sortedEdges(block.ghosts))
  {
    for (const Id vertex : edge)
    {
      entryOf(vertex, edge).isAtGhost = true;
    }
  }
  return entries;
}

/// Leaves only the faces that can have a vertex near one of another rank. Edges that are boundary
/// among these only are not near any.
void keepFacesNearOthers(
  const std::vector<Vec3>& vertices, double margin, Exchange& exchange, SeamBlock& block)
{
  Box own;
  for (const auto* triangles : { &block.triangles, &block.ghosts })
  {
    for (const Triangle& triangle : *triangles)
    {
      for (const Id vertex : triangle)
      {
        own.add(boxAround(vertices[vertex], margin));
      }
    }
  }
  const OtherRanks others(own, exchange);
  const auto isFar = [&](const Triangle& triangle)
  {
    return std::none_of(triangle.begin(), triangle.end(),
      [&](Id vertex) { return others.areNear(vertices[vertex], margin); });
  };
  for (auto* triangles : { &block.triangles, &block.ghosts })
  {
    triangles->erase(std::remove_if(triangles->begin(), triangles->end(), isFar), triangles->end());
  }
}

/// The vertices of all ranks that may have to be joined with another rank's, in the order of their
/// labels and then of the ranks.
std::vector<VertexOfBlock> gatherNearOthers(
  const std::vector<VertexOfBlock>& own, Exchange& exchange)
{
  Box box;
  for (const VertexOfBlock& vertex : own)
  {
    box.add(boxAround(vertex.position, vertex.tolerance()));
  }
  const OtherRanks others(box, exchange);
  Message message;
  for (const VertexOfBlock& vertex : own)
  {
    if (others.areNear(vertex.position, vertex.tolerance()))
    {
      put(message, vertex);
    }
  }
  std::vector<VertexOfBlock> all;
  readEach(exchange.tellAll(message),
    [&all](int, MessageReader& reader) { all.push_back(reader.get<VertexOfBlock>()); });
  std::stable_sort(all.begin(), all.end(),
    [](const VertexOfBlock& a, const VertexOfBlock& b) { return a.label < b.label; });
  return all;
}

/// A vertex and what all blocks have there.
struct SeamVertex : VertexOfBlock
{
  /// Those with a triangle there, ascending.
  std::vector<std::size_t> blocks;
};

std::vector<SeamVertex> combineBlocks(const std::vector<VertexOfBlock>& parts)
{
  std::vector<SeamVertex> vertices;
  std::unordered_map<Label, std::size_t> numbers;
  for (const VertexOfBlock& part : parts)
  {
    const auto [number, isNew] = numbers.emplace(part.label, vertices.size());
    if (isNew)
    {
      vertices.push_back({ part, {} });
    }
    SeamVertex& vertex = vertices[number->second];
    if (part.hasFace)
    {
      vertex.blocks.push_back(part.block);
    }
    vertex.isOnBoundary = vertex.isOnBoundary || part.isOnBoundary;
    vertex.isAtGhost = vertex.isAtGhost || part.isAtGhost;
    vertex.rounding = std::max(vertex.rounding, part.rounding);
    vertex.shortestEdge = std::min(vertex.shortestEdge, part.shortestEdge);
  }
  return vertices;
}

/// Two vertices by their distance.
using Pair = std::tuple<double, std::size_t, std::size_t>;

bool isClose(const SeamVertex& a, const SeamVertex& b, double distance)
{
  return (a.isAtGhost || b.isAtGhost || (a.isOnBoundary && b.isOnBoundary)) &&
    distance <= std::min(std::max(a.tolerance(), b.tolerance()),
                  tolerance::SeamFraction * std::min(a.shortestEdge, b.shortestEdge));
}

/// The pairs of vertices that are close, nearest first. A vertex is looked for among those whose
/// tolerance is as large or larger: for each power of two there is a grid of cells that large, so
/// that the coarse coordinates of one block do not crowd the fine ones of another into one cell.
std::vector<Pair> closePairs(const std::vector<SeamVertex>& vertices)
{
  std::unordered_map<Cell, std::vector<std::size_t>, Hash> grid;
  std::set<int> levels;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const int level = *levels.insert(levelFor(vertices[i].tolerance())).first;
    grid[cellAt(vertices[i].position, level)].push_back(i);
  }
  std::vector<Pair> pairs;
  const auto lookInto = [&](const Cell& cell, std::size_t i)
  {
    const auto found = grid.find(cell);
    for (std::size_t k = 0; found != grid.end() && k < found->second.size(); ++k)
    {
      const std::size_t j = found->second[k];
      const double distance = norm(vertices[i].position - vertices[j].position);
      if (i != j && isClose(vertices[i], vertices[j], distance))
      {
        pairs.emplace_back(distance, std::min(i, j), std::max(i, j));
      }
    }
  };
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const auto least = levels.find(levelFor(vertices[i].tolerance()));
    for (auto level = least; level != levels.end(); ++level)
    {
      for (const Cell& cell : cellsAround(vertices[i].position, *level))
      {
        lookInto(cell, i);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Adds blocks to others where none is among both. \returns whether that is so.
bool addBlocks(const std::vector<std::size_t>& blocks, std::vector<std::size_t>& others)
{
  std::vector<std::size_t> all;
  std::set_union(
    blocks.begin(), blocks.end(), others.begin(), others.end(), std::back_inserter(all));
  const bool areDisjoint = all.size() == blocks.size() + others.size();
  if (areDisjoint)
  {
    others = std::move(all);
  }
  return areDisjoint;
}

/// Joins vertices that are close in groups, no two of one block.
JoinedVertices joinClose(std::vector<SeamVertex> vertices)
{
  std::vector<std::size_t> parents(vertices.size());
  std::iota(parents.begin(), parents.end(), std::size_t(0));
  const auto rootOf = [&parents](std::size_t i)
  {
    while (parents[i] != i)
    {
      i = parents[i] = parents[parents[i]];
    }
    return i;
  };
  const auto order = [&vertices](std::size_t i)
  { return std::pair(vertices[i].blocks.empty(), vertices[i].label); };
  for (const auto& [distance, a, b] : closePairs(vertices))
  {
    const auto [low, high] = std::minmax({ rootOf(a), rootOf(b) },
      [&order](std::size_t i, std::size_t j) { return order(i) < order(j); });
    if (low != high && addBlocks(vertices[high].blocks, vertices[low].blocks))
    {
      parents[high] = low;
    }
  }
  JoinedVertices joined;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const std::size_t root = rootOf(i);
    if (root != i)
    {
      joined.same.emplace(vertices[i].label, vertices[root].label);
      joined.same.emplace(vertices[root].label, vertices[root].label);
      joined.count += vertices[i].blocks.empty() ? 0 : 1;
    }
  }
  return joined;
}

}

JoinedVertices mergeSeams(const std::vector<Vec3>& vertices, const RankLabels& labels,
  std::vector<SeamBlock> blocks, double largest, Exchange& exchange)
{
  const bool isAlone = exchange.numberOfRanks() == 1;
  double precision = 0.0;
  for (const SeamBlock& block : blocks)
  {
    precision = std::max(precision, block.precision);
  }
  const double margin = tolerance::SeamRoundings * exchange.largestOf(precision) * largest;
  if (!isAlone)
  {
    keepFacesNearOthers(vertices, margin, exchange, blocks.front());
  }
  const int level = levelFor(margin);
  const Cells near = cellsNearGhosts(vertices, blocks, level, exchange);
  const auto isNearGhost = [&](const Vec3& point)
  { return !near.empty() && near.count(cellAt(point, level)) > 0; };
  std::vector<VertexOfBlock> all;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const std::vector<VertexOfBlock> own =
      verticesOf(rankIndex(exchange.rank()) + i, blocks[i], vertices, labels, isNearGhost);
    all.insert(all.end(), own.begin(), own.end());
  }
  if (!isAlone)
  {
    all = gatherNearOthers(all, exchange);
  }
  return joinClose(combineBlocks(all));
}

}
