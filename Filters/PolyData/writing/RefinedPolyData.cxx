// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/RefinedPolyData.h"

#include <utility>

namespace geodesic
{

std::vector<Triangle> cornerPointsOf(const PolyDataSurface& surface)
{
  std::vector<Triangle> points;
  if (surface.arePointsVertices())
  {
    return points;
  }
  const MeshPartition& partition = surface.partition();
  points.assign(surface.mesh().numberOfFaces(), { NoId, NoId, NoId });
  for (Id face = partition.firstOwnFace(); face < partition.endOfOwnFaces(); ++face)
  {
    points[face] = surface.triangle(surface.triangleOf(face));
  }
  return points;
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
