// SPDX-License-Identifier: BSD-3-Clause
#include "contours/IsolineSupport.h"

#include "contours/SolveForIsolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

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
      const double step = 0.1;
      const auto at = [&](double t)
      {
        const geodesic::Vec2 p = 0.5 * (a + b) + t * left;
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

GridTruth::GridTruth(const PlainMesh& mesh, const Sources& sources, Index cells)
  : mesh_(mesh)
  , cells_(cells)
{
  for (Index face = 0; face < mesh.triangles.size(); ++face)
  {
    const Triangle& t = mesh.triangles[face];
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->spacing_ = std::max(
        this->spacing_, spaceDistance(mesh.points[t[k]], mesh.points[t[(k + 1) % 3]]) / cells);
    }
    for (Index i = 0; i < cells; ++i)
    {
      for (Index j = 0; i + j < cells; ++j)
      {
        const Index right = this->nodeAt(face, i + 1, j);
        const Index up = this->nodeAt(face, i, j + 1);
        this->triangles_.push_back({ this->nodeAt(face, i, j), right, up });
        if (i + j + 1 < cells)
        {
          this->triangles_.push_back({ right, this->nodeAt(face, i + 1, j + 1), up });
        }
      }
    }
  }
  this->distances_ = bruteForceDistances(mesh, sources, this->places_).queries;
}

// A node is named by the smallest element that holds it: a vertex, an edge with the steps from its
// lower end, or a face.
Index GridTruth::nodeAt(Index face, Index i, Index j)
{
  const std::array<Index, 3> steps = { this->cells_ - i - j, i, j };
  const Triangle& t = this->mesh_.triangles[face];
  const auto points = static_cast<Index>(this->mesh_.points.size());
  std::array<Index, 3> name = { points + face, i, j };
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (steps[k] == 0)
    {
      const std::size_t a = (k + 1) % 3;
      const std::size_t b = (k + 2) % 3;
      name = t[a] < t[b] ? std::array<Index, 3>{ t[a], t[b], steps[b] }
                         : std::array<Index, 3>{ t[b], t[a], steps[a] };
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (steps[k] == this->cells_)
    {
      name = { t[k], t[k], 0 };
    }
  }
  const auto [node, isNew] = this->nodes_.emplace(name, static_cast<Index>(this->places_.size()));
  if (isNew)
  {
    const auto cells = static_cast<double>(this->cells_);
    this->places_.push_back({ face,
      { static_cast<double>(steps[0]) / cells, static_cast<double>(steps[1]) / cells,
        static_cast<double>(steps[2]) / cells } });
  }
  return node->second;
}

LineCount GridTruth::countLines(double value) const
{
  // The pieces that cross each grid edge; one piece a grid face at most.
  std::map<std::pair<Index, Index>, std::vector<std::size_t>> pieces;
  std::size_t count = 0;
  for (const Triangle& t : this->triangles_)
  {
    std::size_t crossed = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::pair<Index, Index> ends = std::minmax(t[k], t[(k + 1) % 3]);
      if ((this->distances_[ends.first] < value) != (this->distances_[ends.second] < value))
      {
        pieces[ends].push_back(count);
        ++crossed;
      }
    }
    count += crossed > 0 ? 1 : 0;
  }
  std::vector<std::size_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&parent](std::size_t piece)
  {
    while (parent[piece] != piece)
    {
      piece = parent[piece] = parent[parent[piece]];
    }
    return piece;
  };
  std::vector<std::size_t> ends;
  for (const auto& [edge, around] : pieces)
  {
    if (around.size() == 2)
    {
      parent[root(around[0])] = root(around[1]);
    }
    else
    {
      ends.insert(ends.end(), around.begin(), around.end());
    }
  }
  std::vector<bool> isOpen(count, false);
  for (const std::size_t piece : ends)
  {
    isOpen[root(piece)] = true;
  }
  LineCount result;
  for (std::size_t piece = 0; piece < count; ++piece)
  {
    if (root(piece) == piece)
    {
      ++(isOpen[piece] ? result.open : result.closed);
    }
  }
  return result;
}

}
