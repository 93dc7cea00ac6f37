// SPDX-License-Identifier: BSD-3-Clause
#include "contours/IsolineSupport.h"

#include "contours/SolveForIsolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace geodesictest
{

MeshPoint testPoint(const geodesic::TriangleMesh& mesh, const geodesic::SurfacePoint& point)
{
  const geodesic::Id face = geodesic::someFace(mesh, point);
  return { mesh.inputFace(face), geodesic::barycentric(mesh, point, face) };
}

geodesic::Isolines isolinesOf(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, const std::vector<double>& values,
  double chordTolerance)
{
  geodesic::IsolineOptions options;
  options.values = values;
  options.chordTolerance = chordTolerance;
  return geodesic::drawIsolines(solveForIsolines(mesh, curves, values), options);
}

std::vector<double> randomValues(const std::vector<double>& distances, double largest,
  const std::vector<double>& leastShares, Random& random)
{
  std::vector<double> values;
  for (const double least : leastShares)
  {
    values.push_back(largest * random.uniform(least, 1.02));
  }
  const double atVertex = distances[random.below(distances.size())];
  if (atVertex > 0.0 && std::isfinite(atVertex))
  {
    values.push_back(atVertex);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

double lengthOf(
  const geodesic::TriangleMesh& mesh, const geodesic::Isolines& isolines, std::size_t line)
{
  const std::vector<geodesic::Id>& points = isolines.lines[line].points;
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += spaceDistance(geodesic::position(mesh, isolines.points[points[i]]),
      geodesic::position(mesh, isolines.points[points[i - 1]]));
  }
  return length;
}

geodesic::SourceCurve sideOf(const geodesic::TriangleMesh& mesh, std::size_t axis)
{
  std::vector<std::pair<double, geodesic::Id>> vertices;
  for (geodesic::Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    if (mesh.point(vertex)[axis] == 0.0)
    {
      vertices.emplace_back(mesh.point(vertex)[1 - axis], vertex);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  geodesic::SourceCurve side;
  for (const auto& [along, vertex] : vertices)
  {
    side.points.push_back(geodesic::SurfacePoint::atVertex(vertex));
    side.isCut.push_back(0);
  }
  for (std::size_t i = 0; i + 1 < side.points.size(); ++i)
  {
    side.faces.push_back(geodesic::commonFace(mesh, side.points[i], side.points[i + 1]));
  }
  return side;
}

void expectChordsInFaces(const geodesic::TriangleMesh& mesh, const geodesic::Isolines& isolines)
{
  for (const geodesic::Isoline& line : isolines.lines)
  {
    ASSERT_EQ(line.points.size(), line.faces.size() + 1);
    for (std::size_t i = 0; i < line.faces.size(); ++i)
    {
      EXPECT_NE(line.points[i], line.points[i + 1]);
      for (const geodesic::Id point : { line.points[i], line.points[i + 1] })
      {
        ASSERT_LT(point, isolines.points.size());
        EXPECT_TRUE(geodesic::contains(mesh, line.faces[i], isolines.points[point]));
      }
    }
  }
}

void expectGrowthToTheLeft(const geodesic::DistanceField& field, const geodesic::Isolines& isolines)
{
  const geodesic::TriangleMesh& mesh = field.mesh();
  for (const geodesic::Isoline& line : isolines.lines)
  {
    for (std::size_t i = 0; i < line.faces.size(); ++i)
    {
      const geodesic::Id face = line.faces[i];
      const geodesic::Id frame = geodesic::longestHalfedge(mesh, face);
      const auto inPlane = [&](geodesic::Id point)
      {
        return geodesic::inHalfedgeFrame(
          mesh, frame, geodesic::barycentric(mesh, isolines.points[point], face));
      };
      const geodesic::Vec2 a = inPlane(line.points[i]);
      const geodesic::Vec2 b = inPlane(line.points[i + 1]);
      const geodesic::Vec2 left = { a.y - b.y, b.x - a.x };
      const geodesic::Vec2 middle = 0.5 * (a + b);
      const double value = field.distance(isolines.points[line.points[i]]);
      // Beside a long chord the distance may fall again behind a ridge, even beyond the source.
      const double step = std::min(0.1, 1e-5 * value / geodesic::norm(b - a));
      const auto at = [&](double t)
      {
        const geodesic::Vec2 p = middle + t * left;
        const geodesic::Barycentric w = geodesic::fromHalfedgeFrame(mesh, frame, p);
        return *std::min_element(w.begin(), w.end()) >= 0.0
          ? field.distance(geodesic::fromBarycentric(mesh, face, w))
          : geodesic::Infinity;
      };
      const double before = at(-step);
      const double behind = at(step);
      if (before < geodesic::Infinity && behind < geodesic::Infinity)
      {
        EXPECT_LT(before, behind) << "chord " << i << " in face " << face;
      }
    }
  }
}

LineCount countLines(const geodesic::Isolines& isolines, std::size_t value)
{
  LineCount count;
  for (const geodesic::Isoline& line : isolines.lines)
  {
    if (line.value == value)
    {
      ++(line.isClosed() ? count.closed : count.open);
    }
  }
  return count;
}

LevelTruth::LevelTruth(const PlainMesh& mesh, const Sources& sources, double value)
  : mesh_(mesh)
  , sources_(sources)
  , value_(value)
{
  for (Index face = 0; face < mesh.triangles.size(); ++face)
  {
    this->cells_.push_back({ face, 0, 0, false });
    const Triangle& t = mesh.triangles[face];
    for (std::size_t k = 0; k < 3; ++k)
    {
      ++this->facesAt_[std::minmax(t[k], t[(k + 1) % 3])];
    }
  }
}

std::array<std::array<Index, 2>, 3> LevelTruth::corners(const Cell& cell) const
{
  const auto [face, i, j, isTurned] = cell;
  using Corners = std::array<std::array<Index, 2>, 3>;
  return isTurned ? Corners{ { { i + 1, j + 1 }, { i, j + 1 }, { i + 1, j } } }
                  : Corners{ { { i, j }, { i + 1, j }, { i, j + 1 } } };
}

/// The middle of a cell.
MeshPoint LevelTruth::place(const Cell& cell) const
{
  Barycentric weights{};
  for (const auto& [i, j] : this->corners(cell))
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      weights[k] += this->steps(i, j)[k] / (3.0 * this->parts_);
    }
  }
  return { cell.face, weights };
}

/// The longest edge of the cells in a face.
double LevelTruth::sizeOf(Index face) const
{
  const Triangle& t = this->mesh_.triangles[face];
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    longest = std::max(
      longest, spaceDistance(this->mesh_.points[t[k]], this->mesh_.points[t[(k + 1) % 3]]));
  }
  return longest / this->parts_;
}

void LevelTruth::refine()
{
  this->parts_ *= 2;
  std::vector<Cell> cells;
  std::vector<MeshPoint> places;
  for (const auto& [face, i, j, isTurned] : this->cells_)
  {
    const Index k = isTurned ? 1 : 0;
    for (const Cell& cell :
      { Cell{ face, 2 * i + k, 2 * j + k, isTurned }, Cell{ face, 2 * i + 1, 2 * j, isTurned },
        Cell{ face, 2 * i, 2 * j + 1, isTurned }, Cell{ face, 2 * i + k, 2 * j + k, !isTurned } })
    {
      cells.push_back(cell);
      places.push_back(this->place(cell));
    }
  }
  const std::vector<double> middles =
    bruteForceDistances(this->mesh_, this->sources_, places).queries;
  this->cells_.clear();
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    // Corners are no farther from the middle than two thirds of the longest edge.
    if (std::abs(middles[i] - this->value_) <=
      0.7 * this->sizeOf(cells[i].face) + 1e-9 * this->value_)
    {
      this->cells_.push_back(cells[i]);
    }
  }
}

// A node is named by the smallest element that holds it: a vertex, an edge with the steps from its
// lower end, or a face.
LevelTruth::Node LevelTruth::nameOf(Index face, const std::array<Index, 3>& steps) const
{
  const Triangle& t = this->mesh_.triangles[face];
  Node name = { static_cast<Index>(this->mesh_.points.size()) + face, steps[1], steps[2] };
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (steps[k] == 0)
    {
      const std::size_t a = (k + 1) % 3;
      const std::size_t b = (k + 2) % 3;
      name = t[a] < t[b] ? Node{ t[a], t[b], steps[b] } : Node{ t[b], t[a], steps[a] };
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (steps[k] == this->parts_)
    {
      name = { t[k], t[k], 0 };
    }
  }
  return name;
}

namespace
{

/// Sets that are united step by step.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : parent_(size)
  {
    std::iota(this->parent_.begin(), this->parent_.end(), std::size_t(0));
  }
  std::size_t root(std::size_t i)
  {
    while (this->parent_[i] != i)
    {
      i = this->parent_[i] = this->parent_[this->parent_[i]];
    }
    return i;
  }
  void unite(std::size_t i, std::size_t j) { this->parent_[this->root(i)] = this->root(j); }

private:
  std::vector<std::size_t> parent_;
};

/// What is in a band of cells, and beside it.
struct Band
{
  /// The rims towards regions below and above the value.
  std::array<std::set<std::size_t>, 2> rims;
  /// Whether it has nodes below and above.
  std::array<bool, 2> hasNodes{};
  /// Whether the value is on an edge where lines end.
  bool isOpen = false;
};

}

/// The cells with nodes and edges of their own.
struct LevelTruth::CellMesh
{
  struct Edge
  {
    std::vector<std::size_t> cells;
    /// Of the mesh, not only of the band.
    std::size_t facesAround = 2;

    bool endsLines() const { return this->facesAround != 2; }
    bool isRim() const { return !this->endsLines() && this->cells.size() == 1; }
  };

  std::vector<MeshPoint> places;
  std::vector<std::array<std::size_t, 3>> nodesOf;
  std::map<std::pair<std::size_t, std::size_t>, Edge> edges;
};

LevelTruth::CellMesh LevelTruth::cellMesh() const
{
  CellMesh result;
  std::map<Node, std::size_t> nodes;
  for (const Cell& cell : this->cells_)
  {
    std::array<std::array<Index, 3>, 3> steps{};
    std::array<std::size_t, 3> ids{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto [i, j] = this->corners(cell)[k];
      const auto& s = steps[k] = this->steps(i, j);
      const auto [node, isNew] = nodes.emplace(this->nameOf(cell.face, s), nodes.size());
      ids[k] = node->second;
      if (isNew)
      {
        const double part = 1.0 / this->parts_;
        result.places.push_back({ cell.face, { part * s[0], part * s[1], part * s[2] } });
      }
    }
    const Triangle& t = this->mesh_.triangles[cell.face];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next = (k + 1) % 3;
      CellMesh::Edge& edge = result.edges[std::minmax(ids[k], ids[next])];
      edge.cells.push_back(result.nodesOf.size());
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        if (steps[k][corner] == 0 && steps[next][corner] == 0)
        {
          edge.facesAround =
            this->facesAt_.at(std::minmax(t[(corner + 1) % 3], t[(corner + 2) % 3]));
        }
      }
    }
    result.nodesOf.push_back(ids);
  }
  return result;
}

std::optional<LineCount> LevelTruth::count() const
{
  if (std::any_of(this->cells_.begin(), this->cells_.end(),
        [this](const Cell& cell) { return this->sizeOf(cell.face) > this->value_; }))
  {
    return std::nullopt; // the region around a source may hold no corner
  }
  const CellMesh mesh = this->cellMesh();
  const std::vector<double> distances =
    bruteForceDistances(this->mesh_, this->sources_, mesh.places).queries;
  const auto sideOf = [&](std::size_t node) -> std::size_t
  { return distances[node] < this->value_ ? 0 : 1; };
  DisjointSets cells(mesh.nodesOf.size());
  for (const auto& [ends, edge] : mesh.edges)
  {
    if (!edge.endsLines() && edge.cells.size() == 2)
    {
      cells.unite(edge.cells[0], edge.cells[1]);
    }
  }
  std::map<std::size_t, Band> bands;
  for (std::size_t i = 0; i < mesh.nodesOf.size(); ++i)
  {
    for (const std::size_t node : mesh.nodesOf[i])
    {
      bands[cells.root(i)].hasNodes[sideOf(node)] = true;
    }
  }
  // Edges of a rim share nodes. Several bands may have a node.
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> atRims;
  DisjointSets rims(2 * mesh.edges.size());
  for (const auto& [ends, edge] : mesh.edges)
  {
    const std::size_t band = cells.root(edge.cells[0]);
    if (edge.isRim())
    {
      const std::size_t a =
        atRims.emplace(std::pair(band, ends.first), atRims.size()).first->second;
      const std::size_t b =
        atRims.emplace(std::pair(band, ends.second), atRims.size()).first->second;
      rims.unite(a, b);
    }
    for (const std::size_t cell : edge.cells)
    {
      Band& here = bands[cells.root(cell)];
      here.isOpen = here.isOpen || (edge.endsLines() && sideOf(ends.first) != sideOf(ends.second));
    }
  }
  for (const auto& [bandAndNode, atRim] : atRims)
  {
    bands[bandAndNode.first].rims[sideOf(bandAndNode.second)].insert(rims.root(atRim));
  }
  LineCount count;
  for (const auto& [root, band] : bands)
  {
    const std::size_t below = band.rims[0].size();
    const std::size_t above = band.rims[1].size();
    const bool hasLine = band.hasNodes[0] && band.hasNodes[1];
    if (hasLine && (below != 1 || above != 1))
    {
      return std::nullopt;
    }
    (band.isOpen ? count.open : count.closed) += hasLine ? 1 : 0;
  }
  return count;
}

}
