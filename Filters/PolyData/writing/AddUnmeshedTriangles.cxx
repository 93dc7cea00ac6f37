// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/UnmeshedTriangles.h"

#include "mesh/FacesWithoutArea.h"
#include "refinement/RefinedOnRanks.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

/// Adds the points of a refined face that split one of its edges or a part of it, from one end to
/// the other, by their numbers in the face.
void addSplits(const RefinedMesh& face, Id a, Id b, std::vector<Id>& splits)
{
  const auto isMiddle = [a, b](const RefinedPoint& point)
  { return std::minmax(a, b) == std::minmax(point.parents[0], point.parents[1]); };
  const auto found = std::find_if(face.points.begin(), face.points.end(), isMiddle);
  if (found != face.points.end())
  {
    const auto middle = static_cast<Id>(3 + (found - face.points.begin()));
    addSplits(face, a, middle, splits);
    splits.push_back(middle);
    addSplits(face, middle, b, splits);
  }
}

/// Cuts triangles that are not faces like the faces at their edges, with points of their own.
struct TriangleCutter
{
  const UnmeshedTriangles& unmeshed;
  RefinedMesh& refined;
  /// The refined faces at the triangles' edges, three for each triangle; empty where there is none.
  const std::vector<RefinedMesh> faces;
  const PolyDataSurface& surface = unmeshed.surface();
  SplitPointNumbering numbering{ refined };
  const RefinedMesh* face = nullptr;
  /// The triangle's own points in place of the face's.
  std::unordered_map<Id, Id> numbers{};

  const UnmeshedTriangle& triangle(std::size_t i) const { return this->unmeshed.ofThisRank()[i]; }

  /// The points on edge k, by their numbers in the face there and along its edge.
  std::vector<Id> splitsAt(std::size_t i, std::size_t k) const
  {
    std::vector<Id> splits;
    const Id edge = this->triangle(i).faces[k].edge(k);
    addSplits(this->faces[3 * i + k], edge, (edge + 1) % 3, splits);
    return splits;
  }
  std::size_t numberOfParts(std::size_t i) const
  {
    return this->triangle(i).isOnFace()
      ? this->faces[3 * i].triangles.size()
      : 1 + this->splitsAt(i, 0).size() + this->splitsAt(i, 1).size() + this->splitsAt(i, 2).size();
  }

  /// Whether all ranks have more triangles than they may. Copies do not count.
  bool areTooMany(std::uint64_t maximumFaces) const
  {
    std::uint64_t total = this->refined.triangles.size();
    for (std::size_t i = 0; i < this->unmeshed.ofThisRank().size(); ++i)
    {
      total += this->surface.isCopy(this->triangle(i).part) ? 0 : this->numberOfParts(i);
    }
    return sumOverRanks(this->surface.exchange(), total).all > maximumFaces && maximumFaces > 0;
  }

  /// \param isWhole whether a triangle on the vertices of a face is not cut.
  void add(std::size_t i, bool isWhole, std::vector<Triangle>& triangles)
  {
    if (!this->triangle(i).isOnFace())
    {
      this->addCut(i, triangles);
    }
    else if (isWhole || this->numberOfParts(i) <= 1)
    {
      triangles.push_back(this->surface.cornersOf(this->triangle(i).part));
    }
    else
    {
      this->addParts(i, triangles);
    }
  }

  /// What follows is about the face at edge k of a triangle.
  void begin(std::size_t i, std::size_t k)
  {
    this->face = &this->faces[3 * i + k];
    this->numbers.clear();
    const Triangle points = this->surface.cornersOf(this->triangle(i).part);
    const Triangle& corners = this->triangle(i).faces[k].corners;
    for (Id own = 0; own < 3; ++own)
    {
      if (corners[own] != FaceAtEdge::None)
      {
        this->numbers[own] = points[corners[own]];
      }
    }
  }

  /// The triangle's own point in place of one of the face's, which lies between corners that both
  /// have.
  Id ownPoint(Id point)
  {
    return numberElsewhere(
      point, this->numbers, [this](Id number) { return this->face->pointAt(number); },
      [this](const RefinedPoint& own, Id number)
      {
        const std::size_t before = this->refined.points.size();
        const Id added = this->numbering.numberOf(own);
        if (this->refined.points.size() > before)
        {
          this->refined.copied.push_back(this->face->copied[number - 3]);
        }
        return added;
      });
  }

  void addParts(std::size_t i, std::vector<Triangle>& triangles)
  {
    this->begin(i, 0);
    const Triangle& corners = this->triangle(i).faces[0].corners;
    const bool isTurned = corners[1] != (corners[0] + 1) % 3;
    for (const Triangle& t : this->face->triangles)
    {
      const Id a = this->ownPoint(t[0]);
      const Id b = this->ownPoint(t[1]);
      const Id c = this->ownPoint(t[2]);
      triangles.push_back(isTurned ? Triangle{ a, c, b } : Triangle{ a, b, c });
    }
  }

  /// Cuts a triangle as the faces at its edges are.
  void addCut(std::size_t i, std::vector<Triangle>& triangles)
  {
    const Triangle points = this->surface.cornersOf(this->triangle(i).part);
    const auto positionOf = [&](Id point)
    {
      return std::find(points.begin(), points.end(), point) != points.end()
        ? this->unmeshed.vertex(this->surface.vertexOf(point)).position
        : this->refined.pointAt(point).position;
    };
    std::array<std::vector<Id>, 3> splits; // on the edge from corner k to the next
    for (std::size_t k = 0; k < 3; ++k)
    {
      splits[k] = this->splitsAt(i, k);
      this->begin(i, k);
      for (Id& point : splits[k])
      {
        point = this->ownPoint(point);
      }
      const FaceAtEdge& there = this->triangle(i).faces[k];
      if (there.corners[there.edge(k)] != k)
      {
        std::reverse(splits[k].begin(), splits[k].end());
      }
    }
    cutAtEdges(points, splits, positionOf, triangles);
  }
};

/// Counts the surface's cut points among the points of refinement: the first of these.
void takeCutPoints(
  const UnmeshedTriangles& unmeshed, std::vector<double> vertexDistances, RefinedMesh& refined)
{
  const PolyDataSurface& surface = unmeshed.surface();
  surface.completeValues(Infinity, vertexDistances);
  std::vector<RefinedPoint> points;
  for (std::size_t i = 0; i < surface.cutPoints.size(); ++i)
  {
    const Id vertex = surface.vertexOf(surface.numberOfPoints + static_cast<Id>(i));
    const bool isInMesh = vertex < surface.mesh().numberOfVertices();
    points.push_back({ surface.cutPoints[i].parents, surface.cutPoints[i].weight,
      SurfacePoint::atVertex(isInMesh ? vertex : NoId), unmeshed.vertex(vertex).position,
      vertexDistances[vertex] });
  }
  points.insert(points.end(), refined.points.begin(), refined.points.end());
  refined.points = std::move(points);
  refined.numberOfInputPoints = surface.numberOfPoints;
}

} // anonymous namespace

RefinedMesh addUnmeshedTriangles(const UnmeshedTriangles& unmeshed, std::uint64_t maximumFaces,
  const std::vector<Triangle>& cornerPoints, const std::vector<double>& vertexDistances,
  RefinedMesh refined)
{
  const PolyDataSurface& surface = unmeshed.surface();
  if (!unmeshed.areOnAnyRank())
  {
    for (Id& face : refined.faces)
    {
      face = surface.triangleOf(face);
    }
    return refined;
  }
  takeCutPoints(unmeshed, vertexDistances, refined);
  std::vector<RankAddress> faces;
  for (const UnmeshedTriangle& triangle : unmeshed.ofThisRank())
  {
    for (const FaceAtEdge& face : triangle.faces)
    {
      faces.push_back(face.address);
    }
  }
  TriangleCutter cutter{ unmeshed, refined,
    findRefinedFaces(faces, surface.partition, refined, cornerPoints) };
  const bool stayWhole = cutter.areTooMany(maximumFaces);
  std::vector<Triangle> triangles;
  std::vector<Id> parents;
  std::size_t next = 0;
  std::size_t cut = 0;
  for (Id part = 0; part < surface.numberOfParts; ++part)
  {
    if (cut < unmeshed.ofThisRank().size() && cutter.triangle(cut).part == part)
    {
      cutter.add(cut++, stayWhole && !surface.isCopy(part), triangles);
    }
    for (; next < refined.faces.size() && surface.partOf(refined.faces[next]) == part; ++next)
    {
      triangles.push_back(refined.triangles[next]);
    }
    parents.resize(triangles.size(), surface.triangleOfPart(part));
  }
  refined.triangles = std::move(triangles);
  refined.faces = std::move(parents);
  return refined;
}

}
