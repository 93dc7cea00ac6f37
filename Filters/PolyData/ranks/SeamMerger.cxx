// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/SeamMerger.h"

#include "Tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

using Edge = std::pair<Id, Id>;

/// The edges that a block has once.
std::vector<Edge> boundaryEdges(const std::vector<Triangle>& triangles)
{
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.emplace_back(low, high);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> boundary;
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto last = std::upper_bound(first, edges.end(), *first);
    if (last - first == 1)
    {
      boundary.push_back(*first);
    }
    first = last;
  }
  return boundary;
}

/// Collects the vertices that may have to be joined.
class SeamVertices
{
public:
  explicit SeamVertices(const std::vector<Vec3>& vertices)
    : vertices_(vertices)
    , numbers_(vertices.size(), NoId)
  {
  }

  void addBlock(std::size_t block, const SeamBlock& data, const GhostPlaces& ghosts)
  {
    for (const auto& [a, b] : boundaryEdges(data.triangles))
    {
      for (const Id vertex : { a, b })
      {
        SeamVertex& entry = this->add(vertex, a, b, data.precision);
        entry.isOnBoundary = true;
        addTo(entry.blocks, block);
      }
    }
    forEachEnd(data.triangles,
      [&](Id vertex, Id other)
      {
        if (ghosts.isNear(this->vertices_[vertex]))
        {
          addTo(this->add(vertex, vertex, other, data.precision).blocks, block);
        }
      });
    forEachEnd(data.ghosts,
      [&](Id vertex, Id other)
      { this->add(vertex, vertex, other, data.precision).isAtGhost = true; });
  }

  std::vector<SeamVertex>&& take() { return std::move(this->entries_); }

private:
  /// Calls with each corner of triangles and its neighbours.
  template <typename Visit>
  static void forEachEnd(const std::vector<Triangle>& triangles, Visit&& visit)
  {
    for (const Triangle& t : triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        visit(t[k], t[(k + 1) % 3]);
        visit(t[k], t[(k + 2) % 3]);
      }
    }
  }

  static void addTo(std::vector<std::size_t>& blocks, std::size_t block)
  {
    if (blocks.empty() || blocks.back() != block)
    {
      blocks.push_back(block);
    }
  }

  /// \param a, b the ends of an edge at the vertex.
  SeamVertex& add(Id vertex, Id a, Id b, double precision)
  {
    SeamVertex& entry = this->entryOf(vertex);
    const double largest =
      std::max(largestCoordinate(this->vertices_[a]), largestCoordinate(this->vertices_[b]));
    entry.rounding = std::max(entry.rounding, precision * largest);
    entry.shortestEdge =
      std::min(entry.shortestEdge, norm(this->vertices_[b] - this->vertices_[a]));
    return entry;
  }

  SeamVertex& entryOf(Id vertex)
  {
    Id& number = this->numbers_[vertex];
    if (number == NoId)
    {
      number = static_cast<Id>(this->entries_.size());
      SeamVertex& entry = this->entries_.emplace_back();
      entry.vertex = vertex;
      entry.position = this->vertices_[vertex];
    }
    return this->entries_[number];
  }

  const std::vector<Vec3>& vertices_;
  std::vector<Id> numbers_;
  std::vector<SeamVertex> entries_;
};

/// Finds pairs of vertices that are close. A vertex is looked for among those whose
/// tolerance is as large or larger: for each power of two there is a grid of cells that large, so
/// that the coarse coordinates of one block do not crowd the fine ones of another into one cell.
class ClosePairs
{
public:
  struct Pair
  {
    double distance;
    std::size_t a;
    std::size_t b;
    bool operator<(const Pair& other) const
    {
      return std::tie(this->distance, this->a, this->b) <
        std::tie(other.distance, other.a, other.b);
    }
  };

  explicit ClosePairs(const std::vector<SeamVertex>& entries)
    : entries_(entries)
  {
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      const int level = levelOf(entries[i]);
      this->cells_[this->cellOf(i, level, { 0, 0, 0 })].push_back(i);
      this->levels_.push_back(level);
    }
    std::sort(this->levels_.begin(), this->levels_.end());
    this->levels_.erase(
      std::unique(this->levels_.begin(), this->levels_.end()), this->levels_.end());
  }

  /// Nearest first.
  std::vector<Pair> find()
  {
    for (std::size_t i = 0; i < this->entries_.size(); ++i)
    {
      for (const int level : this->levels_)
      {
        if (level >= levelOf(this->entries_[i]))
        {
          this->lookAround(i, level);
        }
      }
    }
    std::sort(this->pairs_.begin(), this->pairs_.end());
    return std::move(this->pairs_);
  }

private:
  /// The least power of two that is over the tolerance.
  static int levelOf(const SeamVertex& entry) { return std::ilogb(entry.tolerance()) + 1; }

  SeamCell cellOf(std::size_t i, int level, const std::array<int, 3>& step) const
  {
    SeamCell cell = cellAt(this->entries_[i].position, level);
    for (std::size_t k = 0; k < 3; ++k)
    {
      cell[k] += step[k];
    }
    return cell;
  }

  void lookAround(std::size_t i, int level)
  {
    for (int step = 0; step < 27; ++step)
    {
      const auto cell =
        this->cells_.find(this->cellOf(i, level, { step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1 }));
      if (cell == this->cells_.end())
      {
        continue;
      }
      for (const std::size_t j : cell->second)
      {
        this->tryPair(i, j);
      }
    }
  }

  void tryPair(std::size_t i, std::size_t j)
  {
    const SeamVertex& a = this->entries_[i];
    const SeamVertex& b = this->entries_[j];
    if (!a.isAtGhost && !b.isAtGhost && !(a.isOnBoundary && b.isOnBoundary))
    {
      return;
    }
    const double distance = norm(a.position - b.position);
    const double limit = std::min(std::max(a.tolerance(), b.tolerance()),
      tolerance::SeamFraction * std::min(a.shortestEdge, b.shortestEdge));
    if (i != j && distance <= limit)
    {
      this->pairs_.push_back({ distance, std::min(i, j), std::max(i, j) });
    }
  }

  const std::vector<SeamVertex>& entries_;
  std::unordered_map<SeamCell, std::vector<std::size_t>, SeamCellHash> cells_;
  std::vector<int> levels_;
  std::vector<Pair> pairs_;
};

/// Groups of vertices that are one, no two of one block.
class Groups
{
public:
  explicit Groups(std::vector<SeamVertex>& entries)
    : entries_(entries)
    , parents_(entries.size())
  {
    std::iota(this->parents_.begin(), this->parents_.end(), std::size_t(0));
  }

  std::size_t rootOf(std::size_t i)
  {
    while (this->parents_[i] != i)
    {
      i = this->parents_[i] = this->parents_[this->parents_[i]];
    }
    return i;
  }

  void join(std::size_t a, std::size_t b)
  {
    std::size_t low = this->rootOf(a);
    std::size_t high = this->rootOf(b);
    if (low == high)
    {
      return;
    }
    const auto rank = [this](std::size_t i)
    { return std::pair(this->entries_[i].blocks.empty(), this->entries_[i].vertex); };
    if (rank(high) < rank(low))
    {
      std::swap(low, high);
    }
    std::vector<std::size_t>& blocks = this->entries_[low].blocks;
    const std::vector<std::size_t>& others = this->entries_[high].blocks;
    std::vector<std::size_t> both;
    std::set_union(
      blocks.begin(), blocks.end(), others.begin(), others.end(), std::back_inserter(both));
    if (both.size() < blocks.size() + others.size())
    {
      return; // two of one block
    }
    blocks = std::move(both);
    this->parents_[high] = low;
  }

private:
  std::vector<SeamVertex>& entries_;
  std::vector<std::size_t> parents_;
};

}

double SeamVertex::tolerance() const
{
  return tolerance::SeamRoundings * this->rounding;
}

SeamCell cellAt(const Vec3& point, int level)
{
  SeamCell cell{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    cell[k] = static_cast<std::int64_t>(std::floor(std::ldexp(point[k], -level)));
  }
  cell[3] = level;
  return cell;
}

GhostPlaces::GhostPlaces(double margin)
  : level_(std::ilogb(margin) + 2)
{
}

// A box with a margin of half a cell meets no cells but those of its corners.
void GhostPlaces::add(const Vec3& corner)
{
  const double margin = std::ldexp(1.0, this->level_ - 1);
  for (unsigned int side = 0; side < 8; ++side)
  {
    Vec3 p = corner;
    for (std::size_t k = 0; k < 3; ++k)
    {
      p[k] += (side >> k & 1U) != 0 ? margin : -margin;
    }
    this->cells_.insert(cellAt(p, this->level_));
  }
}

double largestTolerance(const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks)
{
  double largest = 0.0;
  double precision = 0.0;
  for (const SeamBlock& block : blocks)
  {
    precision = std::max(precision, block.precision);
    for (const auto* triangles : { &block.triangles, &block.ghosts })
    {
      for (const Triangle& triangle : *triangles)
      {
        for (const Id vertex : triangle)
        {
          largest = std::max(largest, largestCoordinate(vertices[vertex]));
        }
      }
    }
  }
  return tolerance::SeamRoundings * precision * largest;
}

std::vector<Id> ghostVertices(const SeamBlock& block)
{
  std::vector<Id> all;
  for (const Triangle& triangle : block.ghosts)
  {
    all.insert(all.end(), triangle.begin(), triangle.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<SeamVertex> findSeamVertices(const std::vector<Vec3>& vertices,
  const std::vector<SeamBlock>& blocks, const GhostPlaces& ghosts)
{
  SeamVertices found(vertices);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    found.addBlock(i, blocks[i], ghosts);
  }
  return found.take();
}

std::vector<std::size_t> joinSeamVertices(std::vector<SeamVertex> entries)
{
  const std::vector<ClosePairs::Pair> pairs = ClosePairs(entries).find();
  if (pairs.empty())
  {
    return {};
  }
  Groups groups(entries);
  for (const ClosePairs::Pair& pair : pairs)
  {
    groups.join(pair.a, pair.b);
  }
  std::vector<std::size_t> result(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    result[i] = groups.rootOf(i);
  }
  return result;
}

JoinedVertices mergeSeams(const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks)
{
  GhostPlaces ghosts(largestTolerance(vertices, blocks));
  for (const SeamBlock& block : blocks)
  {
    for (const Id vertex : ghostVertices(block))
    {
      ghosts.add(vertices[vertex]);
    }
  }
  const std::vector<SeamVertex> entries = findSeamVertices(vertices, blocks, ghosts);
  const std::vector<std::size_t> roots = joinSeamVertices(entries);
  if (roots.empty())
  {
    return {};
  }
  JoinedVertices result;
  result.same.resize(vertices.size());
  std::iota(result.same.begin(), result.same.end(), Id(0));
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    result.same[entries[i].vertex] = static_cast<Id>(entries[roots[i]].vertex);
    result.count += roots[i] != i && !entries[i].blocks.empty() ? 1 : 0;
  }
  return result;
}

}
