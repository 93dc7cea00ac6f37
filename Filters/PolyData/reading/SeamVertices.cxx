// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SeamVertices.h"

#include "PolyData/Hash.h"
#include "Questions.h"
#include "Tolerance.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace geodesic
{

namespace
{

using Label = RankLabels::Label;
using Cells = std::unordered_set<SeamCell, Hash>;

/// The vertices that can be on the boundary, and some others where the orientation of faces
/// changes. At each vertex the neighbours are summed up, as hashes, each face adding the next and
/// taking away the previous of its corners: around an inner vertex the sum is 0. That takes a
/// fraction of the time of matching edges.
std::vector<bool> vertexMayBeOnBoundary(const SeamSurface& surface)
{
  std::vector<std::uint64_t> sums(surface.vertices.size(), 0);
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

/// The corners of this rank's ghosts.
std::vector<Id> ghostCorners(const SeamSurface& surface)
{
  std::vector<Id> corners;
  if (!surface.hasGhosts())
  {
    return corners; // the rule
  }
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
  return corners;
}

/// The cubes of a level that have all points near the corner of a ghost of any rank: all points
/// whose coordinates differ by at most half a cube.
Cells cellsNear(
  const std::vector<Id>& corners, const std::vector<Vec3>& vertices, int level, Exchange& exchange)
{
  std::vector<Vec3> own;
  for (const Id vertex : corners)
  {
    own.push_back(vertices[vertex]);
  }
  Cells near;
  for (const Vec3& point : valuesOfRanks(exchange, own))
  {
    const std::array<SeamCell, 8> cells = seamCellsAround(point, level);
    near.insert(cells.begin(), cells.end());
  }
  return near;
}

/// An edge of a face, and the face's third vertex.
struct EdgeOfFace
{
  Id low;
  Id high;
  Id apex;

  bool isOn(const EdgeOfFace& edge) const
  {
    return this->low == edge.low && this->high == edge.high;
  }
  bool operator<(const EdgeOfFace& other) const
  {
    return std::tie(this->low, this->high, this->apex) <
      std::tie(other.low, other.high, other.apex);
  }
};

/// Whether an edge has one face only, among those that ranks tell of.
struct FacesAtEdge
{
  Label apex;
  bool areOne = true;
};

/// Takes out the edges that have several faces on all ranks together, which call this together.
///
/// \param edges one of each edge, with the apex of its first face.
/// \param haveOneFace of each edge, whether this rank has one face there.
void keepBoundary(const RankLabels& labels, std::vector<EdgeOfFace>& edges,
  std::vector<char>& haveOneFace, Exchange& exchange)
{
  using Key = std::array<Label, 2>;
  Questions questions(exchange);
  const auto ranks = static_cast<std::uint64_t>(exchange.numberOfRanks());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (labels.isSharedAt(edges[i].low) && labels.isSharedAt(edges[i].high))
    {
      Key key{ labels.of(edges[i].low), labels.of(edges[i].high) };
      std::sort(key.begin(), key.end());
      questions.ask(static_cast<int>(hashOf(key) % ranks), i, key, labels.of(edges[i].apex),
        haveOneFace[i] != 0);
    }
  }
  std::unordered_map<Key, FacesAtEdge, Hash> known;
  questions.exchangeAnswers(
    [&](int, MessageReader& question)
    {
      const Key key = question.get<Key>();
      const auto apex = question.get<Label>();
      const bool isOne = question.get<bool>();
      FacesAtEdge& faces = known.try_emplace(key, FacesAtEdge{ apex }).first->second;
      faces.areOne = faces.areOne && isOne && faces.apex == apex;
    },
    [&](MessageReader& question, Message& answer)
    {
      put(answer, known.at(question.get<Key>()).areOne);
      question.get<Label>();
      question.get<bool>();
    },
    [&](std::size_t i, MessageReader& answer) { haveOneFace[i] = answer.get<bool>() ? 1 : 0; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (haveOneFace[i] != 0)
    {
      edges[kept++] = edges[i];
    }
  }
  edges.resize(kept);
}

/// The boundary edges of the whole surface that this rank has, of these edges of faces.
std::vector<EdgeOfFace> boundaryAmong(
  std::vector<EdgeOfFace> ofFaces, const RankLabels& labels, Exchange& exchange)
{
  std::sort(ofFaces.begin(), ofFaces.end());
  std::vector<EdgeOfFace> edges;
  std::vector<char> haveOneFace;
  for (const EdgeOfFace& edge : ofFaces)
  {
    if (edges.empty() || !edges.back().isOn(edge))
    {
      edges.push_back(edge);
      haveOneFace.push_back(1);
    }
    else if (edges.back().apex != edge.apex)
    {
      haveOneFace.back() = 0;
    }
  }
  keepBoundary(labels, edges, haveOneFace, exchange);
  return edges;
}

/// What is found at the vertices that may have to be joined, in one pass over the triangles.
struct Candidates
{
  const SeamSurface& surface;
  /// The number of each vertex among the candidates; NoId for others.
  std::vector<Id> numbers{};
  std::vector<SeamVertex> vertices{};
  /// The edges between candidates.
  std::vector<EdgeOfFace> edges{};

  void addVertex(Id vertex, bool isNearGhost)
  {
    this->numbers[vertex] = static_cast<Id>(this->vertices.size());
    SeamVertex& added = this->vertices.emplace_back();
    added.label = this->surface.labels.of(vertex);
    added.position = this->surface.vertices[vertex];
    added.isShared = this->surface.labels.isSharedAt(vertex);
    added.isNearGhost = isNearGhost;
  }

  void addCorner(const Triangle& t, std::size_t k, std::size_t block, bool isGhost)
  {
    SeamVertex& vertex = this->vertices[this->numbers[t[k]]];
    vertex.hasFace = vertex.hasFace || !isGhost;
    vertex.block = isGhost ? vertex.block : std::min(vertex.block, block);
    for (const std::size_t other : { (k + 1) % 3, (k + 2) % 3 })
    {
      const Vec3& p = this->surface.vertices[t[other]];
      const double largest = std::max(largestCoordinate(vertex.position), largestCoordinate(p));
      vertex.rounding = std::max(vertex.rounding, this->surface.precisions[block] * largest);
      vertex.shortestEdge = std::min(vertex.shortestEdge, norm(p - vertex.position));
    }
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
            const auto [low, high] = std::minmax(t[k], t[next]);
            this->edges.push_back({ low, high, t[(k + 2) % 3] });
          }
        }
      });
  }
};

}

std::vector<SeamVertex> findSeamVertices(const SeamSurface& surface, Exchange& exchange)
{
  const std::vector<bool> mayBeOnBoundary = vertexMayBeOnBoundary(surface);
  const std::vector<Id> corners = ghostCorners(surface);
  if (!exchange.isTrueAnywhere(!mayBeOnBoundary.empty() || !corners.empty()))
  {
    return {};
  }
  double precision = 0.0;
  for (const double ofBlock : surface.precisions)
  {
    precision = std::max(precision, ofBlock);
  }
  const int level =
    seamLevelFor(tolerance::SeamRoundings * exchange.largestOf(precision) * surface.largest);
  const Cells near = cellsNear(corners, surface.vertices, level, exchange);
  Candidates candidates{ surface };
  candidates.numbers.assign(surface.vertices.size(), NoId);
  for (Id vertex = 0; vertex < surface.vertices.size(); ++vertex)
  {
    const bool isNearGhost =
      !near.empty() && near.count(seamCellAt(surface.vertices[vertex], level)) > 0;
    if (isNearGhost || (!mayBeOnBoundary.empty() && mayBeOnBoundary[vertex]))
    {
      candidates.addVertex(vertex, isNearGhost);
    }
  }
  candidates.addTriangles();
  std::vector<SeamVertex>& vertices = candidates.vertices;
  for (const EdgeOfFace& edge :
    boundaryAmong(std::move(candidates.edges), surface.labels, exchange))
  {
    vertices[candidates.numbers[edge.low]].isOnBoundary = true;
    vertices[candidates.numbers[edge.high]].isOnBoundary = true;
  }
  vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                   [](const SeamVertex& vertex)
                   {
                     const bool isPlain =
                       vertex.hasFace && !vertex.isOnBoundary && !vertex.isNearGhost;
                     return !(vertex.shortestEdge > 0.0 && vertex.shortestEdge < Infinity) ||
                       (isPlain && !vertex.isShared);
                   }),
    vertices.end());
  return std::move(vertices);
}

int seamLevelFor(double distance)
{
  return std::ilogb(distance) + 2;
}

SeamCell seamCellAt(const Vec3& point, int level, double shift)
{
  SeamCell cell{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    cell[k] = static_cast<std::int64_t>(std::floor(std::ldexp(point[k], -level) + shift));
  }
  cell[3] = level;
  return cell;
}

std::array<SeamCell, 8> seamCellsAround(const Vec3& point, int level)
{
  std::array<SeamCell, 8> cells;
  cells.fill(seamCellAt(point, level, -0.5));
  for (std::size_t side = 0; side < cells.size(); ++side)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      cells[side][k] += static_cast<std::int64_t>(side >> k & 1U);
    }
  }
  return cells;
}

double SeamVertex::tolerance() const
{
  return tolerance::SeamRoundings * this->rounding;
}

}
