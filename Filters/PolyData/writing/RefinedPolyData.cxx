// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/RefinedPolyData.h"

#include "PolyData/writing/BarrierClosure.h"
#include "PolyData/writing/TrianglePoints.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

/// Gives a triangle the parts of the face on the same vertices.
class FaceParts
{
public:
  FaceParts(const PolyDataSurface& surface, TrianglePoints& points)
    : surface_(surface)
    , points_(points)
  {
  }

  /// The face of the mesh on the triangle's vertices; NoId where there is none, as in a barrier.
  Id faceLike(const Triangle& triangle) const
  {
    const TriangleMesh& mesh = this->surface_.mesh();
    Triangle wanted = this->surface_.verticesOf(triangle);
    std::sort(wanted.begin(), wanted.end());
    for (const Id corner : mesh.cornersAt(wanted[0]))
    {
      Triangle there = mesh.triangle(TriangleMesh::faceOf(corner));
      std::sort(there.begin(), there.end());
      if (there == wanted)
      {
        return TriangleMesh::faceOf(corner);
      }
    }
    return NoId;
  }

  void begin(Id face, const Triangle& triangle)
  {
    this->points_.begin(triangle);
    const Triangle& own = this->points_.vertices();
    const Triangle& vertices = this->surface_.mesh().triangle(face);
    const std::size_t first = vertices[0] == own[0] ? 0 : vertices[0] == own[1] ? 1 : 2;
    this->flipped_ = vertices[1] != own[(first + 1) % 3];
  }

  Triangle partLike(const Triangle& part)
  {
    Triangle result;
    for (std::size_t k = 0; k < 3; ++k)
    {
      result[k] = this->points_.like(part[k]);
    }
    if (this->flipped_)
    {
      std::swap(result[1], result[2]);
    }
    return result;
  }

private:
  const PolyDataSurface& surface_;
  TrianglePoints& points_;
  bool flipped_ = false;
};

/// Where the parts of each face begin among the refined triangles.
std::vector<Id> firstParts(const std::vector<Id>& faces, Id numberOfFaces)
{
  std::vector<Id> first(static_cast<std::size_t>(numberOfFaces) + 1, 0);
  for (const Id face : faces)
  {
    ++first[face + 1];
  }
  for (Id face = 0; face < numberOfFaces; ++face)
  {
    first[face + 1] += first[face];
  }
  return first;
}

/// The mesh's face for each triangle of the surface; for a duplicate that of the first one, for a
/// barrier NoId.
std::vector<Id> facesOfTriangles(const PolyDataSurface& surface, const FaceParts& parts)
{
  const TriangleMesh& mesh = surface.mesh();
  std::vector<Id> faces(surface.numberOfTriangles(), NoId);
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    faces[surface.triangleOf(face)] = face;
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    faces[i] = faces[i] == NoId ? parts.faceLike(surface.triangle(static_cast<Id>(i))) : faces[i];
  }
  return faces;
}

}

void addOtherTriangles(
  const PolyDataSurface& surface, std::uint64_t maximumFaces, RefinedMesh& refined)
{
  const TriangleMesh& mesh = surface.mesh();
  if (surface.numberOfTriangles() == mesh.numberOfFaces())
  {
    for (Id& face : refined.faces)
    {
      face = surface.triangleOf(face);
    }
    return;
  }
  TrianglePoints points(surface, refined);
  FaceParts parts(surface, points);
  BarrierClosure barriers(surface, refined, points);
  const std::vector<Id> faces = facesOfTriangles(surface, parts);
  const std::vector<Id> first = firstParts(refined.faces, mesh.numberOfFaces());
  std::uint64_t total = 0;
  for (Id i = 0; i < faces.size(); ++i)
  {
    const Id count = faces[i] == NoId ? barriers.count(surface.triangle(i))
                                      : first[faces[i] + 1] - first[faces[i]];
    total += surface.isCopy(i) ? 0 : count;
  }
  const bool whole = maximumFaces > 0 && total > maximumFaces;

  std::vector<Triangle> triangles;
  std::vector<Id> parents;
  for (Id i = 0; i < faces.size(); ++i)
  {
    const Id face = faces[i];
    if (face == NoId)
    {
      barriers.close(surface.triangle(i), triangles);
      parents.resize(triangles.size(), i);
      continue;
    }
    const bool isDuplicate = surface.triangleOf(face) != i;
    const Triangle own = surface.triangle(i);
    const bool staysWhole = whole && !surface.isCopy(i);
    if (isDuplicate && (staysWhole || first[face + 1] - first[face] == 1))
    {
      triangles.push_back(own);
      parents.push_back(i);
      continue;
    }
    if (isDuplicate)
    {
      parts.begin(face, own);
    }
    for (Id part = first[face]; part < first[face + 1]; ++part)
    {
      const Triangle& like = refined.triangles[part];
      triangles.push_back(isDuplicate ? parts.partLike(like) : like);
      parents.push_back(i);
    }
  }
  refined.triangles = std::move(triangles);
  refined.faces = std::move(parents);
}

std::vector<std::size_t> blocksOfNewPoints(
  const PolyDataSurface& surface, const RefinedMesh& refined)
{
  std::vector<std::size_t> blocks;
  blocks.reserve(refined.points.size());
  for (const RefinedPoint& point : refined.points)
  {
    const Id parent = point.parents[0];
    blocks.push_back(parent < refined.numberOfInputPoints
        ? surface.blockOfPoint(parent)
        : blocks[parent - refined.numberOfInputPoints]);
  }
  return blocks;
}

std::vector<RefinedMesh> partsByBlock(const PolyDataSurface& surface, RefinedMesh refined)
{
  std::vector<RefinedMesh> parts;
  if (surface.blocks().size() == 1)
  {
    parts.push_back(std::move(refined));
    return parts;
  }
  parts.resize(surface.blocks().size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    parts[i].numberOfInputPoints = surface.blocks()[i].numberOfPoints;
  }
  const std::vector<std::size_t> blocks = blocksOfNewPoints(surface, refined);
  // For each new point its number in its block, of which it needs those of its parents.
  std::vector<Id> numbers;
  numbers.reserve(refined.points.size());
  const auto numberOf = [&](Id point, const SurfaceBlock& block)
  {
    return point < refined.numberOfInputPoints ? point - block.firstPoint
                                               : numbers[point - refined.numberOfInputPoints];
  };
  for (RefinedPoint& point : refined.points)
  {
    const std::size_t index = blocks[numbers.size()];
    RefinedMesh& part = parts[index];
    for (Id& parent : point.parents)
    {
      parent = numberOf(parent, surface.blocks()[index]);
    }
    numbers.push_back(part.numberOfInputPoints + static_cast<Id>(part.points.size()));
    part.points.push_back(point);
  }
  refined.points = {};
  for (std::size_t i = 0; i < refined.triangles.size(); ++i)
  {
    const std::size_t index = surface.blockOfTriangle(refined.faces[i]);
    const SurfaceBlock& block = surface.blocks()[index];
    Triangle triangle = refined.triangles[i];
    for (Id& corner : triangle)
    {
      corner = numberOf(corner, block);
    }
    parts[index].triangles.push_back(triangle);
    parts[index].faces.push_back(refined.faces[i] - block.firstTriangle);
  }
  return parts;
}

}
