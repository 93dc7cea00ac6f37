// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SeamMerger.h"

#include "PolyData/reading/PointGrid.h"
#include "Tolerance.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>
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

/// The pairs of vertices that are close, nearest first.
std::vector<Pair> closePairs(const std::vector<SeamVertex>& vertices, const Limits& limits)
{
  PointGrid grid;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    grid.add(vertices[i].position, limits.at(vertices[i]), i);
  }
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const SeamVertex& vertex = vertices[i];
    // One of the two vertices reaches as far as the other one, and looks as far.
    grid.visitNear(vertex.position, limits.at(vertex),
      [&](std::size_t j)
      {
        const double distance = norm(vertex.position - vertices[j].position);
        if (i != j && distance <= limits.between(vertex, vertices[j]))
        {
          pairs.emplace_back(distance, std::min(i, j), std::max(i, j));
        }
      });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Makes one of what several ranks know of a vertex. Then vertices ascend.
std::vector<SeamVertex> combineRanks(std::vector<SeamVertex> parts)
{
  std::stable_sort(parts.begin(), parts.end(),
    [](const SeamVertex& a, const SeamVertex& b) { return a.label < b.label; });
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
    vertex.isNearGhost = vertex.isNearGhost || part.isNearGhost;
    vertex.rounding = std::max(vertex.rounding, part.rounding);
    vertex.shortestEdge = std::min(vertex.shortestEdge, part.shortestEdge);
  }
  return vertices;
}

/// Marks the ends of the edges that have one face; faces on the same three vertices count as one.
void markBoundary(std::vector<SeamEdge> edges, std::vector<SeamVertex>& vertices)
{
  std::sort(edges.begin(), edges.end());
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto end = std::find_if(
      first, edges.end(), [&first](const SeamEdge& edge) { return !edge.isOn(*first); });
    const bool isOnBoundary = first->apex == (end - 1)->apex;
    for (const Label label : { first->low, first->high })
    {
      const auto vertex = std::lower_bound(vertices.begin(), vertices.end(), label,
        [](const SeamVertex& v, Label wanted) { return v.label < wanted; });
      if (isOnBoundary && vertex != vertices.end() && vertex->label == label)
      {
        vertex->isOnBoundary = true;
      }
    }
    first = end;
  }
}

/// The vertices of all ranks that may be one with others, the same on each rank.
std::vector<SeamVertex> findSeamVertices(const SeamSurface& surface, Exchange& exchange)
{
  SeamCandidates found = findCandidates(surface, exchange);
  if (exchange.numberOfRanks() > 1)
  {
    found.vertices = combineRanks(valuesOfRanks(exchange, found.vertices));
    found.edges = valuesOfRanks(exchange, found.edges);
  }
  markBoundary(std::move(found.edges), found.vertices);
  const auto isInside = [](const SeamVertex& vertex)
  { return vertex.hasFace && !vertex.isOnBoundary && !vertex.isNearGhost; };
  std::vector<SeamVertex>& vertices = found.vertices;
  vertices.erase(std::remove_if(vertices.begin(), vertices.end(), isInside), vertices.end());
  return std::move(vertices);
}

/// The vertex that stands for several.
struct JoinedVertex
{
  Label label;
  Vec3 position;
};

/// Vertices that are one.
struct JoinedVertices
{
  /// For the label of each vertex that is one with others, the vertex that stands for all.
  std::map<Label, JoinedVertex> same;
  std::uint64_t count = 0;
};

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

/// Makes one vertex of those that are one on this rank.
void join(const JoinedVertices& joined, PieceVertices& vertices)
{
  std::vector<Label>& labels = vertices.labels.labels;
  std::vector<Id> same(vertices.positions.size());
  std::iota(same.begin(), same.end(), Id(0));
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    const auto found = joined.same.find(vertices.labels.of(vertex));
    if (found == joined.same.end())
    {
      continue;
    }
    vertices.positions[vertex] = found->second.position;
    if (labels.empty())
    {
      same[vertex] = static_cast<Id>(found->second.label);
    }
    else
    {
      labels[vertex] = found->second.label | RankLabels::Shared;
    }
  }
  vertices.join(same);
  vertices.joinSameLabels();
}

}

std::optional<std::uint64_t> mergeSeams(const SeamSurface& surface, Exchange& exchange)
{
  const Limits limits{ surface.mergeTolerance };
  const std::vector<SeamVertex> vertices = findSeamVertices(surface, exchange);
  Groups groups(vertices, limits);
  for (const auto& [distance, a, b] : closePairs(vertices, limits))
  {
    groups.join(a, b);
  }
  const JoinedVertices joined = groups.joined();
  if (joined.same.empty())
  {
    return {};
  }
  join(joined, surface.vertices);
  return joined.count;
}

}
