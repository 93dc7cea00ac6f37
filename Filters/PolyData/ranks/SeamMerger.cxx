// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/SeamMerger.h"

#include "PolyData/Hash.h"
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

struct CellHash
{
  std::size_t operator()(const Cell& cell) const
  {
    return static_cast<std::size_t>(hashOf(cell.data(), cell.size()));
  }
};

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

/// The places of ghosts' corners.
class GhostPlaces
{
public:
  /// Those of all ranks.
  ///
  /// \param margin the largest tolerance of all vertices.
  GhostPlaces(const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks,
    double margin, Exchange& exchange)
    : level_(levelFor(margin))
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
    readEach(exchange.tellAll(message),
      [this](int, MessageReader& reader)
      {
        const std::array<Cell, 8> cells = cellsAround(reader.get<Vec3>(), this->level_);
        this->cells_.insert(cells.begin(), cells.end());
      });
  }

  /// Whether a point may be within the margin of a corner. Never false if it is.
  bool isNear(const Vec3& point) const
  {
    return !this->cells_.empty() && this->cells_.count(cellAt(point, this->level_)) > 0;
  }

private:
  int level_;
  std::unordered_set<Cell, CellHash> cells_;
};

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

/// Collects the vertices that may have to be joined.
class VerticesOfBlocks
{
public:
  VerticesOfBlocks(const std::vector<Vec3>& vertices, const RankLabels& labels)
    : vertices_(vertices)
    , labels_(labels)
  {
  }

  void addBlock(std::size_t number, const SeamBlock& block, const GhostPlaces& ghosts)
  {
    this->numbers_.clear();
    const std::vector<Edge> edges = sortedEdges(block.triangles);
    for (auto first = edges.begin(); first != edges.end();)
    {
      const auto last = std::upper_bound(first, edges.end(), *first);
      const bool isBoundary = last - first == 1;
      for (const Id vertex : *first)
      {
        if (isBoundary || ghosts.isNear(this->vertices_[vertex]))
        {
          VertexOfBlock& entry = this->add(number, vertex, *first, block.precision);
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
        this->add(number, vertex, edge, block.precision).isAtGhost = true;
      }
    }
  }

  std::vector<VertexOfBlock>&& take() { return std::move(this->entries_); }

private:
  /// \param edge at the vertex.
  VertexOfBlock& add(std::size_t block, Id vertex, const Edge& edge, double precision)
  {
    const auto [number, isNew] = this->numbers_.emplace(vertex, this->entries_.size());
    if (isNew)
    {
      this->entries_.push_back({ this->labels_.of(vertex), this->vertices_[vertex], block });
    }
    VertexOfBlock& entry = this->entries_[number->second];
    const Vec3& a = this->vertices_[edge[0]];
    const Vec3& b = this->vertices_[edge[1]];
    entry.rounding =
      std::max(entry.rounding, precision * std::max(largestCoordinate(a), largestCoordinate(b)));
    entry.shortestEdge = std::min(entry.shortestEdge, norm(b - a));
    return entry;
  }

  const std::vector<Vec3>& vertices_;
  const RankLabels& labels_;
  std::vector<VertexOfBlock> entries_;
  /// The entries of one block's vertices.
  std::unordered_map<Id, std::size_t> numbers_;
};

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
  std::unordered_map<Cell, std::vector<std::size_t>, CellHash> grid;
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
  const GhostPlaces ghosts(vertices, blocks, margin, exchange);
  VerticesOfBlocks found(vertices, labels);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    found.addBlock(rankIndex(exchange.rank()) + i, blocks[i], ghosts);
  }
  std::vector<VertexOfBlock> all = found.take();
  if (!isAlone)
  {
    all = gatherNearOthers(all, exchange);
  }
  return joinClose(combineBlocks(all));
}

}
