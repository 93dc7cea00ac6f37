// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SurfaceParts.h"

#include "mesh/FacesWithoutArea.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

using Label = PieceVertices::Label;

/// Gives the corners of parts points.
struct PartCorners
{
  const std::vector<Triangle>& triangles;
  const std::vector<Id>& same;
  const std::vector<Vec3>& places;
  /// To which cut points are added.
  PolyDataSurface& surface;
  /// The vertex of each of these.
  std::vector<Id> cutVertices{};
  std::map<std::pair<std::size_t, Id>, Id> pointAt{};
  std::map<std::tuple<Id, Id, Id>, Id> cuts{};

  /// Makes a triangle's own points known to its block, for the parts of other triangles.
  void addOwnPoints(Id triangle)
  {
    const Triangle points = pointsOfTriangle(this->surface.blocks, triangle);
    const Triangle vertices = this->verticesOf(triangle);
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->pointAt.emplace(std::pair(this->blockOf(triangle), vertices[k]), points[k]);
    }
  }

  Triangle pointsOf(const Triangle& part, Id triangle)
  {
    const Triangle vertices = this->verticesOf(triangle);
    const Triangle points = pointsOfTriangle(this->surface.blocks, triangle);
    const auto pointAtCorner = [&](std::size_t k)
    { return this->pointOf(part[k], triangle, vertices, points); };
    return part == vertices ? points
                            : Triangle{ pointAtCorner(0), pointAtCorner(1), pointAtCorner(2) };
  }

  std::size_t blockOf(Id triangle) const
  {
    return this->surface.blockOf(triangle, &SurfaceBlock::firstTriangle);
  }

  Triangle verticesOf(Id triangle) const
  {
    const Triangle& t = this->triangles[triangle];
    return { this->same[t[0]], this->same[t[1]], this->same[t[2]] };
  }

  Id pointOf(Id vertex, Id triangle, const Triangle& own, const Triangle& points)
  {
    const auto corner = std::find(own.begin(), own.end(), vertex) - own.begin();
    if (corner < 3)
    {
      return points[static_cast<std::size_t>(corner)];
    }
    const auto known = this->pointAt.find({ this->blockOf(triangle), vertex });
    return known != this->pointAt.end() ? known->second : this->cutPointOf(vertex, own, points);
  }

  /// The point at a vertex on an edge of a triangle, which its neighbor at the edge has, too.
  Id cutPointOf(Id vertex, const Triangle& own, const Triangle& points)
  {
    std::array<Id, 2> parents = { points[0], points[1] };
    double weight = 0.0;
    double least = Infinity;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3& from = this->places[own[k]];
      const Vec3 along = this->places[own[(k + 1) % 3]] - from;
      const double fraction =
        std::clamp(dot(this->places[vertex] - from, along) / dot(along, along), 0.0, 1.0);
      const double distance = norm(this->places[vertex] - (from + fraction * along));
      if (distance < least)
      {
        least = distance;
        parents = { points[k], points[(k + 1) % 3] };
        weight = fraction;
      }
    }
    if (parents[1] < parents[0])
    {
      std::swap(parents[0], parents[1]);
      weight = 1.0 - weight;
    }
    const auto next =
      this->surface.numberOfPoints + static_cast<Id>(this->surface.cutPoints.size());
    const auto [found, isNew] =
      this->cuts.emplace(std::tuple(parents[0], parents[1], vertex), next);
    if (isNew)
    {
      this->surface.cutPoints.push_back({ parents, weight });
      this->cutVertices.push_back(vertex);
    }
    return found->second;
  }
};

/// What faces without area leave, on vertices.
CutTriangles removeFlatFaces(const std::vector<Triangle>& triangles,
  const std::vector<TriangleRole>& roles, Id numberOfPoints, PieceVertices& vertices,
  Exchange& exchange, const Job& job)
{
  std::vector<std::uint8_t> areOpen;
  for (const TriangleRole role : roles)
  {
    areOpen.push_back(role == TriangleRole::Open ? 1 : 0);
  }
  std::vector<Label> keys;
  Label firstNewKey = vertices.positions.size();
  if (exchange.numberOfRanks() > 1)
  {
    for (Id vertex = 0; vertex < vertices.positions.size(); ++vertex)
    {
      keys.push_back(vertices.labelOf(vertex));
    }
    // Labels of the first rank that no vertex has.
    firstNewKey = static_cast<Label>(exchange.largestOf(static_cast<double>(numberOfPoints)));
  }
  CutTriangles cut = removeFacesWithoutArea(
    vertices.positions, keys, firstNewKey, triangles, areOpen, exchange, job);
  std::vector<Label>& labels = vertices.labels;
  for (std::size_t vertex = 0; vertex < keys.size(); ++vertex)
  {
    if (vertex == labels.size() || (labels[vertex] & ~PieceVertices::Shared) != keys[vertex])
    {
      labels.resize(std::max(labels.size(), vertex + 1));
      labels[vertex] = keys[vertex] | PieceVertices::Shared;
    }
  }
  return cut;
}

} // anonymous namespace

void cutTriangles(const std::vector<Triangle>& triangles, Exchange& exchange,
  PieceVertices& vertices, PolyDataSurface& surface, const Job& job)
{
  const CutTriangles cut =
    removeFlatFaces(triangles, surface.roles, surface.numberOfPoints, vertices, exchange, job);
  if (cut.isEmpty())
  {
    return;
  }
  PartCorners corners{ triangles, cut.same, vertices.positions, surface };
  const std::vector<TriangleRole> roles = std::move(surface.roles);
  surface.roles.clear();
  for (std::size_t i = 0; i < cut.parts.size(); ++i)
  {
    const TriangleRole role = roles.empty() ? TriangleRole::Open : roles[cut.triangles[i]];
    const bool isSegment = role == TriangleRole::Open && !cut.areFaces[i];
    surface.roles.push_back(isSegment ? TriangleRole::Segment : role);
    if (isSegment)
    {
      corners.addOwnPoints(cut.triangles[i]);
    }
  }
  for (std::size_t i = 0; i < cut.parts.size(); ++i)
  {
    surface.corners.push_back(corners.pointsOf(cut.parts[i], cut.triangles[i]));
  }
  surface.triangles = cut.triangles;
  vertices.of.append(surface.numberOfPoints, corners.cutVertices);
  if (!vertices.labels.empty())
  {
    // Vertices at which triangles of other ranks may be cut, too.
    for (const Triangle& part : cut.parts)
    {
      for (const Id vertex : part)
      {
        vertices.labels[vertex] |= PieceVertices::Shared;
      }
    }
  }
  vertices.join(cut.same);
}

}
