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

/// A triangle that is not a face, and the refined faces at its edges; empty where there is none.
struct TriangleToCut
{
  const UnmeshedTriangle& triangle;
  const RefinedMesh* faces;

  /// The edge of the face at edge k.
  Id edgeOfFace(std::size_t k) const
  {
    const Triangle& vertices = this->triangle.vertices;
    return this->triangle.faces[k].edgeBetween(vertices[k], vertices[(k + 1) % 3]);
  }
  /// The points on edge k, by their numbers in the face there and along its edge.
  std::vector<Id> splitsAt(std::size_t k) const
  {
    std::vector<Id> splits;
    const Id edge = this->edgeOfFace(k);
    addSplits(this->faces[k], edge, (edge + 1) % 3, splits);
    return splits;
  }
  std::size_t numberOfParts() const
  {
    return this->triangle.isOnFace()
      ? this->faces[0].triangles.size()
      : 1 + this->splitsAt(0).size() + this->splitsAt(1).size() + this->splitsAt(2).size();
  }
};

/// How the faces at the triangles' edges are refined, three for each triangle.
std::vector<RefinedMesh> facesAtEdges(const UnmeshedTriangles& unmeshed,
  const std::vector<Triangle>& cornerPoints, const RefinedMesh& refined)
{
  std::vector<RankAddress> faces;
  for (const UnmeshedTriangle& triangle : unmeshed.ofThisRank())
  {
    for (const GlobalFace& face : triangle.faces)
    {
      faces.push_back(face.address);
    }
  }
  return findRefinedFaces(faces, unmeshed.surface().partition, refined, cornerPoints);
}

/// Cuts triangles like faces, with points of their own.
struct TriangleCutter
{
  const UnmeshedTriangles& unmeshed;
  RefinedMesh& refined;
  const PolyDataSurface& surface = unmeshed.surface();
  SplitPointNumbering numbering{ refined };
  const RefinedMesh* face = nullptr;
  /// The triangle's own points in place of the face's.
  std::unordered_map<Id, Id> numbers{};

  /// \param isWhole whether a triangle on the vertices of a face is not cut.
  void add(const TriangleToCut& cut, bool isWhole, std::vector<Triangle>& triangles)
  {
    if (!cut.triangle.isOnFace())
    {
      this->addCut(cut, triangles);
    }
    else if (isWhole || cut.numberOfParts() <= 1)
    {
      triangles.push_back(this->surface.cornersOf(cut.triangle.part));
    }
    else
    {
      this->addParts(cut, triangles);
    }
  }

  /// What follows is about the face at an edge of a triangle.
  ///
  /// \param corners how many of the triangle's corners the face has, from corner k on.
  void begin(const TriangleToCut& cut, std::size_t k, std::size_t corners)
  {
    this->face = &cut.faces[k];
    this->numbers.clear();
    const Triangle points = this->surface.cornersOf(cut.triangle.part);
    for (std::size_t i = k; i < k + corners; ++i)
    {
      const Id vertex = cut.triangle.vertices[i % 3];
      this->numbers[cornerAt(cut.triangle.faces[k].vertices, vertex)] = points[i % 3];
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

  void addParts(const TriangleToCut& cut, std::vector<Triangle>& triangles)
  {
    this->begin(cut, 0, 3);
    const Triangle& vertices = cut.triangle.vertices;
    const Triangle& there = cut.triangle.faces[0].vertices;
    const Id first = cornerAt(vertices, there[0]);
    const bool isTurned = vertices[(first + 1) % 3] != there[1];
    for (const Triangle& t : this->face->triangles)
    {
      const Id a = this->ownPoint(t[0]);
      const Id b = this->ownPoint(t[1]);
      const Id c = this->ownPoint(t[2]);
      triangles.push_back(isTurned ? Triangle{ a, c, b } : Triangle{ a, b, c });
    }
  }

  /// Cuts a triangle as the faces at its edges are.
  void addCut(const TriangleToCut& cut, std::vector<Triangle>& triangles)
  {
    const Triangle points = this->surface.cornersOf(cut.triangle.part);
    const Triangle vertices = this->surface.vertexOf(points);
    const auto positionOf = [&](Id point)
    {
      const Id corner = cornerAt(points, point);
      return corner < 3 ? this->unmeshed.vertex(vertices[corner]).position
                        : this->refined.pointAt(point).position;
    };
    std::array<std::vector<Id>, 3> splits; // on the edge from corner k to the next
    for (std::size_t k = 0; k < 3; ++k)
    {
      splits[k] = cut.splitsAt(k);
      if (!splits[k].empty())
      {
        this->begin(cut, k, 2);
        for (Id& point : splits[k])
        {
          point = this->ownPoint(point);
        }
        if (cut.triangle.faces[k].vertices[cut.edgeOfFace(k)] != cut.triangle.vertices[k])
        {
          std::reverse(splits[k].begin(), splits[k].end());
        }
      }
    }
    cutAtEdges(points, splits, positionOf, triangles);
  }
};

/// Whether all ranks have more triangles than they may. Copies do not count.
bool areTooMany(const PolyDataSurface& surface, const std::vector<TriangleToCut>& cuts,
  const RefinedMesh& refined, std::uint64_t maximumFaces)
{
  std::uint64_t total = refined.triangles.size();
  for (const TriangleToCut& cut : cuts)
  {
    total += surface.isCopy(cut.triangle.part) ? 0 : cut.numberOfParts();
  }
  return sumOverRanks(surface.exchange(), total).all > maximumFaces && maximumFaces > 0;
}

/// Counts the surface's cut points among the points of refinement: the first of these.
void takeCutPoints(
  const PolyDataSurface& surface, const std::vector<double>& vertexDistances, RefinedMesh& refined)
{
  std::vector<RefinedPoint> points;
  for (std::size_t i = 0; i < surface.cutPoints.size(); ++i)
  {
    const Id vertex = surface.vertexOf(surface.numberOfPoints + static_cast<Id>(i));
    const bool isInMesh = vertex < surface.mesh().numberOfVertices();
    points.push_back({ surface.cutPoints[i].parents, surface.cutPoints[i].weight,
      SurfacePoint::atVertex(vertex), isInMesh ? surface.mesh().point(vertex) : Vec3(),
      isInMesh ? vertexDistances[vertex] : Infinity });
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
  takeCutPoints(surface, vertexDistances, refined);
  const std::vector<RefinedMesh> faces = facesAtEdges(unmeshed, cornerPoints, refined);
  std::vector<TriangleToCut> cuts;
  for (const UnmeshedTriangle& triangle : unmeshed.ofThisRank())
  {
    cuts.push_back({ triangle, faces.data() + 3 * cuts.size() });
  }
  const bool stayWhole = areTooMany(surface, cuts, refined, maximumFaces);
  TriangleCutter cutter{ unmeshed, refined };
  std::vector<Triangle> triangles;
  std::vector<Id> parents;
  std::size_t next = 0;
  auto cut = cuts.begin();
  for (Id part = 0; part < surface.numberOfParts; ++part)
  {
    if (cut != cuts.end() && cut->triangle.part == part)
    {
      cutter.add(*cut++, stayWhole && !surface.isCopy(part), triangles);
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
