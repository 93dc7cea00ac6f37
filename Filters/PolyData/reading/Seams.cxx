// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/Seams.h"

#include "PolyData/Hash.h"
#include "PolyData/reading/PointGrid.h"
#include "Tolerance.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

using Label = PieceVertices::Label;

/// A vertex that may be one with others.
struct SeamVertex
{
  Label label = 0;
  Vec3 position{};
  /// The first block that has a face there; where none has, after all blocks.
  std::size_t block = std::numeric_limits<std::size_t>::max();
  /// Whether there is a triangle that is no ghost.
  bool hasFace = false;
  /// Whether it is on the boundary of the whole surface.
  bool isOnBoundary = false;
  /// Whether it may be near a vertex that only ghosts have.
  bool isNearGhost = false;
  /// How far from each other points around may be stored that are one place.
  double rounding = 0.0;
  double shortestEdge = Infinity;
};

/// How far two vertices may be apart that are one.
struct Limits
{
  double mergeTolerance;

  double between(const SeamVertex& a, const SeamVertex& b) const
  {
    const double edge = std::min(a.shortestEdge, b.shortestEdge);
    const double rounding =
      std::min(std::max(a.rounding, b.rounding), tolerance::SeamFraction * edge);
    const bool areOnBoundary = a.isOnBoundary && b.isOnBoundary;
    return a.hasFace && b.hasFace && !areOnBoundary ? -1.0
      : areOnBoundary                               ? std::max(rounding, this->ofMerging(edge))
                                                    : rounding;
  }

  /// Between the vertex and any other with the same rounding or a smaller one.
  double at(const SeamVertex& a) const
  {
    return std::max({ std::min(a.rounding, tolerance::SeamFraction * a.shortestEdge),
      this->ofMerging(a.shortestEdge),
      tolerance::Rounding * largestCoordinate(a.position) }); // cells can be numbered
  }

private:
  double ofMerging(double edge) const
  {
    return std::min(this->mergeTolerance, tolerance::MergeFraction * edge);
  }
};

/// Calls visit(triangle of vertices, block, whether a ghost array marks it as a duplicate).
template <typename Visit>
void forEachTriangle(const SeamSurface& surface, const Visit& visit)
{
  const TriangleList& triangles = surface.triangles;
  for (std::size_t block = 0; block < surface.precisions.size(); ++block)
  {
    const std::size_t end = triangles.firstOfBlock[block + 1];
    for (std::size_t i = triangles.firstOfBlock[block]; i < end; ++i)
    {
      visit(surface.vertices.of(triangles.corners[i]), block, triangles.isDuplicate[i]);
    }
  }
}

/// For each vertex a number that is not 0 on the boundary, and at some other vertices where the
/// orientation of faces changes. The neighbours are summed up, as hashes, each face adding the next
/// and taking away the previous of its corners: around an inner vertex the sum is 0. That takes a
/// fraction of the time of matching edges.
std::vector<std::uint64_t> sumsOfNeighbors(const SeamSurface& surface)
{
  std::vector<std::uint64_t> sums(surface.vertices.positions.size(), 0);
  forEachTriangle(surface,
    [&sums](const Triangle& t, std::size_t, bool isGhost)
    {
      if (!isGhost)
      {
        const auto hash = [](Id vertex)
        { return mixed(mixed(std::uint64_t(vertex) + 1), 0xd6e8feb86659fd93ULL); };
        const std::array<std::uint64_t, 3> hashes = { hash(t[0]), hash(t[1]), hash(t[2]) };
        sums[t[0]] += hashes[1] - hashes[2];
        sums[t[1]] += hashes[2] - hashes[0];
        sums[t[2]] += hashes[0] - hashes[1];
      }
    });
  return sums;
}

/// The places of the corners of this rank's ghosts.
std::vector<Vec3> ghostCorners(const SeamSurface& surface)
{
  std::set<Id> corners;
  forEachTriangle(surface,
    [&corners](const Triangle& triangle, std::size_t, bool isGhost)
    {
      if (isGhost)
      {
        corners.insert(triangle.begin(), triangle.end());
      }
    });
  std::vector<Vec3> places;
  for (const Id vertex : corners)
  {
    places.push_back(surface.vertices.positions[vertex]);
  }
  return places;
}

/// The vertices of this rank that can be on the boundary of the surface, that only ghosts have, or
/// that are near such a ghost's corner, in their order.
///
/// \param numbers gets the number of each vertex among them; NoId for others.
std::vector<SeamVertex> findCandidates(
  const SeamSurface& surface, Exchange& exchange, std::vector<Id>& numbers)
{
  const std::vector<std::uint64_t> sums = sumsOfNeighbors(surface);
  const double precision = std::accumulate(surface.precisions.begin(), surface.precisions.end(),
    0.0, [](double a, double b) { return std::max(a, b); });
  const double reach = tolerance::SeamRoundings * exchange.largestOf(precision) * surface.largest;
  PointGrid ghosts;
  for (const Vec3& corner : valuesOfRanks(exchange, ghostCorners(surface)))
  {
    ghosts.add(corner, reach, 0);
  }
  std::vector<SeamVertex> candidates;
  numbers.assign(sums.size(), NoId);
  for (Id vertex = 0; vertex < sums.size(); ++vertex)
  {
    const Vec3& position = surface.vertices.positions[vertex];
    bool isNearGhost = false;
    ghosts.visitNear(position, reach, [&isNearGhost](std::size_t) { isNearGhost = true; });
    if (isNearGhost || sums[vertex] != 0)
    {
      numbers[vertex] = static_cast<Id>(candidates.size());
      SeamVertex& added = candidates.emplace_back();
      added.label = surface.vertices.labelOf(vertex);
      added.position = position;
      added.isNearGhost = isNearGhost;
    }
  }
  return candidates;
}

/// Adds what a triangle tells of a candidate at its corner k.
void addCorner(const SeamSurface& surface, const Triangle& triangle, std::size_t k,
  std::size_t block, bool isGhost, SeamVertex& vertex)
{
  vertex.hasFace = vertex.hasFace || !isGhost;
  vertex.block = isGhost ? vertex.block : std::min(vertex.block, block);
  for (const std::size_t other : { (k + 1) % 3, (k + 2) % 3 })
  {
    const Vec3& p = surface.vertices.positions[triangle[other]];
    const double largest = std::max(largestCoordinate(vertex.position), largestCoordinate(p));
    vertex.rounding =
      std::max(vertex.rounding, tolerance::SeamRoundings * (surface.precisions[block] * largest));
    vertex.shortestEdge = std::min(vertex.shortestEdge, norm(p - vertex.position));
  }
}

/// Adds what the triangles tell of the candidates.
///
/// \param numbers of vertices among the candidates.
/// \returns the edges of faces between candidates, by labels.
std::vector<FaceEdge> addTriangles(
  const SeamSurface& surface, const std::vector<Id>& numbers, std::vector<SeamVertex>& candidates)
{
  std::vector<FaceEdge> edges;
  const PieceVertices& vertices = surface.vertices;
  forEachTriangle(surface,
    [&](const Triangle& t, std::size_t block, bool isGhost)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id number = numbers[t[k]];
        if (number == NoId)
        {
          continue; // nearly always
        }
        addCorner(surface, t, k, block, isGhost, candidates[number]);
        if (const Id next = t[(k + 1) % 3]; !isGhost && numbers[next] != NoId)
        {
          edges.push_back(
            { vertices.labelOf(t[k]), vertices.labelOf(next), vertices.labelOf(t[(k + 2) % 3]) });
        }
      }
    });
  return edges;
}

/// Makes one of what several ranks know of a vertex. Then vertices ascend.
std::vector<SeamVertex> combineRanks(std::vector<SeamVertex> parts)
{
  std::stable_sort(parts.begin(), parts.end(),
    [](const SeamVertex& a, const SeamVertex& b) { return a.label < b.label; });
  std::vector<SeamVertex> vertices;
  for (const SeamVertex& part : parts)
  {
    if (!(part.shortestEdge > 0.0 && part.shortestEdge < Infinity))
    {
      continue; // without triangles
    }
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

/// Marks the ends of the edges that have one face.
void markBoundary(const std::vector<FaceEdge>& edges, std::vector<SeamVertex>& vertices)
{
  for (const FaceEdge& edge : edgesOfOneFace(edges))
  {
    for (const Label label : { edge[0], edge[1] })
    {
      const auto vertex = std::lower_bound(vertices.begin(), vertices.end(), label,
        [](const SeamVertex& v, Label wanted) { return v.label < wanted; });
      if (vertex != vertices.end() && vertex->label == label)
      {
        vertex->isOnBoundary = true;
      }
    }
  }
}

/// The vertices of all ranks that may be one with others, the same on each rank.
std::vector<SeamVertex> findSeamVertices(const SeamSurface& surface, Exchange& exchange)
{
  std::vector<Id> numbers;
  std::vector<SeamVertex> own = findCandidates(surface, exchange, numbers);
  std::vector<FaceEdge> edges;
  if (!own.empty())
  {
    edges = addTriangles(surface, numbers, own);
  }
  if (exchange.numberOfRanks() > 1)
  {
    own = valuesOfRanks(exchange, own);
    edges = valuesOfRanks(exchange, edges);
  }
  std::vector<SeamVertex> vertices = combineRanks(std::move(own));
  markBoundary(edges, vertices);
  const auto isInside = [](const SeamVertex& vertex)
  { return vertex.hasFace && !vertex.isOnBoundary && !vertex.isNearGhost; };
  vertices.erase(std::remove_if(vertices.begin(), vertices.end(), isInside), vertices.end());
  return vertices;
}

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

using Group = std::vector<std::size_t>;

/// Divides the vertices into groups, in each of which all are close to each other.
std::vector<Group> groupClose(const std::vector<SeamVertex>& vertices, const Limits& limits)
{
  std::vector<Group> groups(vertices.size());
  std::vector<std::size_t> groupOf(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    groups[i] = { i };
    groupOf[i] = i;
  }
  const auto areClose = [&](std::size_t i, std::size_t j)
  {
    const SeamVertex& a = vertices[i];
    const SeamVertex& b = vertices[j];
    return norm(a.position - b.position) <= limits.between(a, b);
  };
  const auto isCloseToAll = [&](std::size_t i, const Group& group) {
    return std::all_of(group.begin(), group.end(), [&](std::size_t j) { return areClose(i, j); });
  };
  for (const auto& [distance, a, b] : closePairs(vertices, limits))
  {
    Group& first = groups[groupOf[a]];
    Group& second = groups[groupOf[b]];
    if (&first == &second ||
      !std::all_of(
        first.begin(), first.end(), [&](std::size_t i) { return isCloseToAll(i, second); }))
    {
      continue;
    }
    for (const std::size_t i : second)
    {
      groupOf[i] = groupOf[a];
    }
    first.insert(first.end(), second.begin(), second.end());
    second.clear();
  }
  return groups;
}

/// The vertex of a group that stands for all.
const SeamVertex& firstOf(const Group& group, const std::vector<SeamVertex>& vertices)
{
  const auto isBefore = [&vertices](std::size_t i, std::size_t j)
  {
    const SeamVertex& a = vertices[i];
    const SeamVertex& b = vertices[j];
    return std::tie(a.block, a.position, a.label) < std::tie(b.block, b.position, b.label);
  };
  return vertices[*std::min_element(group.begin(), group.end(), isBefore)];
}

/// Makes one vertex of those that are one on this rank.
///
/// \param firsts for the label of each vertex that is one with others, the vertex that stands for
///        all.
void join(const std::map<Label, const SeamVertex*>& firsts, PieceVertices& vertices)
{
  std::vector<Label>& labels = vertices.labels;
  std::vector<Id> same(vertices.positions.size());
  std::iota(same.begin(), same.end(), Id(0));
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    const auto found = firsts.find(vertices.labelOf(vertex));
    if (found == firsts.end())
    {
      continue;
    }
    vertices.positions[vertex] = found->second->position;
    if (labels.empty())
    {
      same[vertex] = static_cast<Id>(found->second->label);
    }
    else
    {
      labels[vertex] = found->second->label | PieceVertices::Shared;
    }
  }
  vertices.join(same);
  vertices.joinSameLabels();
}

}

std::uint64_t mergeSeams(const SeamSurface& surface, Exchange& exchange)
{
  const std::vector<SeamVertex> vertices = findSeamVertices(surface, exchange);
  std::map<Label, const SeamVertex*> firsts;
  std::uint64_t count = 0;
  for (const Group& group : groupClose(vertices, Limits{ surface.mergeTolerance }))
  {
    if (group.size() < 2)
    {
      continue;
    }
    const SeamVertex& first = firstOf(group, vertices);
    std::uint64_t withFaces = 0;
    for (const std::size_t i : group)
    {
      firsts.emplace(vertices[i].label, &first);
      withFaces += vertices[i].hasFace ? 1 : 0;
    }
    count += std::max<std::uint64_t>(withFaces, 1) - 1;
  }
  if (!firsts.empty())
  {
    join(firsts, surface.vertices);
  }
  return count;
}

}
