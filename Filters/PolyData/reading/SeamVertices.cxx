// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SeamVertices.h"

#include "PolyData/Hash.h"
#include "PolyData/reading/PointGrid.h"
#include "Tolerance.h"

#include <algorithm>
#include <array>
#include <utility>

namespace geodesic
{

namespace
{

/// The vertices that can be on the boundary, and some others where the orientation of faces
/// changes. At each vertex the neighbours are summed up, as hashes, each face adding the next and
/// taking away the previous of its corners: around an inner vertex the sum is 0. That takes a
/// fraction of the time of matching edges.
std::vector<bool> vertexMayBeOnBoundary(const SeamSurface& surface)
{
  std::vector<std::uint64_t> sums(surface.vertices.positions.size(), 0);
  surface.forEachTriangle(
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
  std::vector<bool> mayBe;
  if (std::any_of(sums.begin(), sums.end(), [](std::uint64_t sum) { return sum != 0; }))
  {
    mayBe.resize(sums.size());
    std::transform(
      sums.begin(), sums.end(), mayBe.begin(), [](std::uint64_t sum) { return sum != 0; });
  }
  return mayBe;
}

/// The places of the corners of this rank's ghosts.
std::vector<Vec3> ghostCorners(const SeamSurface& surface)
{
  if (!surface.hasGhosts())
  {
    return {}; // the rule
  }
  std::vector<Id> corners;
  surface.forEachTriangle(
    [&corners](const Triangle& triangle, std::size_t, bool isGhost)
    {
      if (isGhost)
      {
        corners.insert(corners.end(), triangle.begin(), triangle.end());
      }
    });
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<Vec3> places;
  for (const Id vertex : corners)
  {
    places.push_back(surface.vertices.positions[vertex]);
  }
  return places;
}

/// What is found at the vertices that may have to be joined, in one pass over the triangles.
struct Candidates
{
  const SeamSurface& surface;
  /// The number of each vertex among the candidates; NoId for others.
  std::vector<Id> numbers{};
  SeamCandidates found{};

  void addVertex(Id vertex, bool isNearGhost)
  {
    this->numbers[vertex] = static_cast<Id>(this->found.vertices.size());
    SeamVertex& added = this->found.vertices.emplace_back();
    added.label = this->surface.vertices.labels.of(vertex);
    added.position = this->surface.vertices.positions[vertex];
    added.isNearGhost = isNearGhost;
  }

  void addCorner(const Triangle& t, std::size_t k, std::size_t block, bool isGhost)
  {
    SeamVertex& vertex = this->found.vertices[this->numbers[t[k]]];
    vertex.hasFace = vertex.hasFace || !isGhost;
    vertex.block = isGhost ? vertex.block : std::min(vertex.block, block);
    for (const std::size_t other : { (k + 1) % 3, (k + 2) % 3 })
    {
      const Vec3& p = this->surface.vertices.positions[t[other]];
      const double largest = std::max(largestCoordinate(vertex.position), largestCoordinate(p));
      vertex.rounding = std::max(vertex.rounding, this->surface.precisions[block] * largest);
      vertex.shortestEdge = std::min(vertex.shortestEdge, norm(p - vertex.position));
    }
  }

  void addEdge(Id a, Id b, Id apex)
  {
    const RankLabels& labels = this->surface.vertices.labels;
    const auto [low, high] = std::minmax({ labels.of(a), labels.of(b) });
    this->found.edges.push_back({ low, high, labels.of(apex) });
  }

  void addTriangles()
  {
    this->surface.forEachTriangle(
      [this](const Triangle& t, std::size_t block, bool isGhost)
      {
        const std::array<bool, 3> areCandidates = { this->numbers[t[0]] != NoId,
          this->numbers[t[1]] != NoId, this->numbers[t[2]] != NoId };
        if (!areCandidates[0] && !areCandidates[1] && !areCandidates[2])
        {
          return; // nearly always
        }
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::size_t next = (k + 1) % 3;
          if (areCandidates[k])
          {
            this->addCorner(t, k, block, isGhost);
          }
          if (!isGhost && areCandidates[k] && areCandidates[next])
          {
            this->addEdge(t[k], t[next], t[(k + 2) % 3]);
          }
        }
      });
  }
};

}

SeamCandidates findCandidates(const SeamSurface& surface, Exchange& exchange)
{
  const std::vector<bool> mayBeOnBoundary = vertexMayBeOnBoundary(surface);
  const std::vector<Vec3> corners = valuesOfRanks(exchange, ghostCorners(surface));
  double precision = 0.0;
  for (const double ofBlock : surface.precisions)
  {
    precision = std::max(precision, ofBlock);
  }
  const double reach = tolerance::SeamRoundings * exchange.largestOf(precision) * surface.largest;
  if (mayBeOnBoundary.empty() && corners.empty())
  {
    return {};
  }
  PointGrid grid;
  for (const Vec3& corner : corners)
  {
    grid.add(corner, reach, 0);
  }
  const std::vector<Vec3>& positions = surface.vertices.positions;
  Candidates candidates{ surface };
  candidates.numbers.assign(positions.size(), NoId);
  for (Id vertex = 0; vertex < positions.size(); ++vertex)
  {
    bool isNearGhost = false;
    grid.visitNear(positions[vertex], reach, [&](std::size_t) { isNearGhost = true; });
    if (isNearGhost || (!mayBeOnBoundary.empty() && mayBeOnBoundary[vertex]))
    {
      candidates.addVertex(vertex, isNearGhost);
    }
  }
  candidates.addTriangles();
  std::vector<SeamVertex>& vertices = candidates.found.vertices;
  vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                   [](const SeamVertex& vertex)
                   { return !(vertex.shortestEdge > 0.0 && vertex.shortestEdge < Infinity); }),
    vertices.end());
  return std::move(candidates.found);
}

double SeamVertex::tolerance() const
{
  return tolerance::SeamRoundings * this->rounding;
}

}
