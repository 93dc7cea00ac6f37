// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/PolyDataSurface.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

PolyDataSurface::PolyDataSurface(SurfaceContents contents)
  : contents_(std::move(contents))
{
  const std::vector<TriangleRole>& roles = this->contents_.roles;
  for (Id i = 0; i < roles.size(); ++i)
  {
    if (roles[i] != TriangleRole::Copy)
    {
      (roles[i] == TriangleRole::Open ? this->openTriangles_ : this->barrierTriangles_)
        .push_back(i);
    }
  }
}

std::vector<RemoteVertex> PolyDataSurface::remoteVertices() const
{
  const MeshPartition& partition = this->partition();
  const auto own = [&](Id vertex)
  {
    return RemoteVertex{ partition.globalId(vertex), this->mesh().point(vertex),
      { partition.exchange().rank(), vertex } };
  };
  std::vector<RemoteVertex> vertices =
    this->contents_.remoteVertices.copies(RemoteVertex(), this->exchange(), own);
  for (std::size_t i = 0; i < this->contents_.barrierVertices.size(); ++i)
  {
    const MeshPartition& barriers = this->barriers()->surface();
    const Id vertex = this->contents_.barrierVertices[i];
    if (vertex >= this->mesh().numberOfVertices())
    {
      RemoteVertex& remote = vertices[vertex - this->mesh().numberOfVertices()];
      if (remote.globalId == NoId)
      {
        const auto onBarrier = static_cast<Id>(i);
        remote.globalId = partition.numberOfGlobalVertices() + barriers.globalId(onBarrier);
        remote.position = barriers.mesh().point(onBarrier);
      }
    }
  }
  return vertices;
}

MeshPartition PolyDataSurface::partitionWithBarriers(
  std::vector<Id>& globalIds, const ProgressCallback& progress) const
{
  std::vector<Triangle> triangles;
  for (Id i = 0; i < this->numberOfTriangles(); ++i)
  {
    if (!this->isCopy(i))
    {
      triangles.push_back(this->verticesAt(i));
    }
  }
  const std::vector<RemoteVertex> remote = this->remoteVertices();
  const Id inMesh = this->mesh().numberOfVertices();
  std::vector<Vec3> points;
  globalIds.clear();
  for (const Id vertex : numberUsedVertices(triangles, inMesh + remote.size()))
  {
    const bool isRemote = vertex >= inMesh;
    points.push_back(isRemote ? remote[vertex - inMesh].position : this->mesh().point(vertex));
    globalIds.push_back(
      isRemote ? remote[vertex - inMesh].globalId : this->partition().globalId(vertex));
  }
  const std::vector<std::uint64_t> keys(globalIds.begin(), globalIds.end());
  return { std::move(points), std::move(triangles), keys, this->exchange(), progress };
}

void PolyDataSurface::useCellsOf(const std::vector<PolyDataBlock>& inputs)
{
  for (std::size_t i = 0; i < this->contents_.blocks.size(); ++i)
  {
    if (this->contents_.blocks[i].areInputCells)
    {
      this->contents_.blocks[i].triangles = inputs[i].data->GetPolys();
    }
  }
}

Id PolyDataSurface::numberOfPoints() const
{
  const std::vector<SurfaceBlock>& blocks = this->blocks();
  return blocks.empty() ? 0 : blocks.back().firstPoint + blocks.back().numberOfPoints;
}

Id PolyDataSurface::numberOfTriangles() const
{
  const std::vector<SurfaceBlock>& blocks = this->blocks();
  return blocks.empty()
    ? 0
    : blocks.back().firstTriangle + static_cast<Id>(blocks.back().numberOfTriangles());
}

std::uint64_t PolyDataSurface::countTrianglesOfAllRanks() const
{
  const std::vector<TriangleRole>& roles = this->contents_.roles;
  const auto copies = std::count(roles.begin(), roles.end(), TriangleRole::Copy);
  return sumOverRanks(this->exchange(), this->numberOfTriangles() - static_cast<Id>(copies)).all;
}

Triangle PolyDataSurface::triangle(Id triangle) const
{
  const SurfaceBlock& block = this->contents_.blocks[this->blockOfTriangle(triangle)];
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  block.triangles->GetCellAtId(triangle - block.firstTriangle, size, points);
  const auto pointOf = [&block](vtkIdType id) { return block.firstPoint + static_cast<Id>(id); };
  return { pointOf(points[0]), pointOf(points[1]), pointOf(points[2]) };
}

// Empty blocks begin where the next one does: the last of those that begin there is meant.
std::size_t PolyDataSurface::blockOf(Id item, Id SurfaceBlock::*first) const
{
  const std::vector<SurfaceBlock>& blocks = this->blocks();
  const auto next = std::upper_bound(blocks.begin(), blocks.end(), item,
    [first](Id id, const SurfaceBlock& block) { return id < block.*first; });
  return static_cast<std::size_t>(next - blocks.begin()) - 1;
}

std::string PolyDataSurface::nameOfCell(Id triangle, const std::vector<PolyDataBlock>& inputs) const
{
  const std::size_t index = this->blockOfTriangle(triangle);
  const SurfaceBlock& block = this->blocks()[index];
  return "cell " + std::to_string(block.inputCell(triangle - block.firstTriangle)) + " of " +
    inputs[index].name;
}

std::vector<Id> numberUsedVertices(std::vector<Triangle>& triangles, std::size_t numberOfVertices)
{
  std::vector<Id> numbers(triangles.empty() ? 0 : numberOfVertices, NoId);
  for (const Triangle& triangle : triangles)
  {
    for (const Id vertex : triangle)
    {
      numbers[vertex] = 0;
    }
  }
  std::vector<Id> used;
  for (Id vertex = 0; vertex < numbers.size(); ++vertex)
  {
    if (numbers[vertex] != NoId)
    {
      numbers[vertex] = static_cast<Id>(used.size());
      used.push_back(vertex);
    }
  }
  for (Triangle& triangle : triangles)
  {
    for (Id& vertex : triangle)
    {
      vertex = numbers[vertex];
    }
  }
  return used;
}

}
