// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/PolyDataSurface.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

vtkIdType SurfaceBlock::numberOfTriangles() const
{
  return this->triangles->GetNumberOfCells();
}

PolyDataSurface::PolyDataSurface(std::vector<Id> vertexOfPoint, std::vector<SurfaceBlock> blocks,
  std::vector<TriangleRole> roles, const PowerOfTwoScale& scale, double diagonal,
  const Report& report)
  : vertexOfPoint_(std::move(vertexOfPoint))
  , blocks_(std::move(blocks))
  , roles_(std::move(roles))
  , scale_(scale)
  , diagonal_(diagonal)
  , report_(report)
{
  this->sortRoles();
}

PolyDataSurface::PolyDataSurface(std::unique_ptr<TriangleMesh> mesh,
  std::unique_ptr<BarrierFaces> barriers, std::vector<Id> vertexOfPoint,
  std::vector<SurfaceBlock> blocks, std::vector<TriangleRole> roles, const PowerOfTwoScale& scale,
  double diagonal, const Report& report)
  : PolyDataSurface(
      std::move(vertexOfPoint), std::move(blocks), std::move(roles), scale, diagonal, report)
{
  this->mesh_ = std::move(mesh);
  this->partition_ = std::make_unique<MeshPartition>(*this->mesh_);
  this->barriers_ = std::move(barriers);
}

PolyDataSurface::PolyDataSurface(std::unique_ptr<MeshPartition> part,
  std::unique_ptr<BarriersOnRanks> barriers, RemoteVertices borrowed, std::vector<Id> vertexOfPoint,
  std::vector<SurfaceBlock> blocks, std::vector<TriangleRole> roles, const PowerOfTwoScale& scale,
  double diagonal, const Report& report)
  : PolyDataSurface(
      std::move(vertexOfPoint), std::move(blocks), std::move(roles), scale, diagonal, report)
{
  this->partition_ = std::move(part);
  this->borrowed_ = std::move(borrowed);
  this->barriersOnRanks_ = std::move(barriers);
}

void PolyDataSurface::Report::add(const Report& other)
{
  for (vtkIdType Report::*count : { &Report::polygons, &Report::strips, &Report::droppedVertexCells,
         &Report::droppedLineCells, &Report::facesWithRepeatedPoint, &Report::joinedSeamPoints,
         &Report::duplicateFaces, &Report::zeroAreaFaces, &Report::isolatedPoints, &Report::edges })
  {
    this->*count += other.*count;
  }
}

void PolyDataSurface::sortRoles()
{
  for (Id i = 0; i < this->roles_.size(); ++i)
  {
    switch (this->roles_[i])
    {
      case TriangleRole::Open:
        this->openTriangles_.push_back(i);
        break;
      case TriangleRole::Barrier:
        this->barrierTriangles_.push_back(i);
        break;
      case TriangleRole::Copy:
        ++this->numberOfCopies_;
        break;
    }
  }
}

std::unique_ptr<TriangleMesh> PolyDataSurface::meshWithBarriers(
  const ProgressCallback& progress) const
{
  std::vector<Vec3> points;
  points.reserve(this->mesh().numberOfVertices());
  for (Id vertex = 0; vertex < this->mesh().numberOfVertices(); ++vertex)
  {
    points.push_back(this->mesh().point(vertex));
  }
  std::vector<Triangle> triangles;
  triangles.reserve(this->numberOfOwnTriangles());
  for (Id i = 0; i < this->numberOfTriangles(); ++i)
  {
    if (!this->isCopy(i))
    {
      triangles.push_back(this->verticesOf(this->triangle(i)));
    }
  }
  return std::make_unique<TriangleMesh>(std::move(points), triangles, progress);
}

PieceVertices PolyDataSurface::pieceVertices() const
{
  PieceVertices vertices;
  const TriangleMesh& mesh = this->partition_->mesh();
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    vertices.numbers.push_back(this->partition_->globalId(vertex));
    vertices.positions.push_back(mesh.point(vertex));
  }
  this->completeValues(NoId, vertices.numbers);
  this->completeValues(Vec3{}, vertices.positions);
  if (this->barriersOnRanks_)
  {
    const MeshPartition& barriers = this->barriersOnRanks_->part();
    for (Id i = 0; i < barriers.numberOfOwnVertices(); ++i)
    {
      const Id vertex = this->barriersOnRanks_->vertices()[i];
      if (vertices.numbers[vertex] == NoId)
      {
        vertices.numbers[vertex] =
          this->partition_->numberOfGlobalVertices() + barriers.globalId(i);
        vertices.positions[vertex] = barriers.mesh().point(i);
      }
    }
  }
  return vertices;
}

std::unique_ptr<MeshPartition> PolyDataSurface::partWithBarriers(
  std::vector<Id>& numbers, const ProgressCallback& progress) const
{
  const PieceVertices all = this->pieceVertices();
  std::vector<Id> own(all.numbers.size(), NoId);
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  numbers.clear();
  for (Id i = 0; i < this->numberOfTriangles(); ++i)
  {
    if (this->isCopy(i))
    {
      continue;
    }
    Triangle triangle = this->verticesOf(this->triangle(i));
    for (Id& vertex : triangle)
    {
      if (own[vertex] == NoId)
      {
        own[vertex] = static_cast<Id>(points.size());
        points.push_back(all.positions[vertex]);
        numbers.push_back(all.numbers[vertex]);
      }
      vertex = own[vertex];
    }
    triangles.push_back(triangle);
  }
  const std::vector<std::uint64_t> keys(numbers.begin(), numbers.end());
  return std::make_unique<MeshPartition>(
    std::move(points), std::move(triangles), keys, this->partition_->exchange(), progress);
}

void PolyDataSurface::useCellsOf(const std::vector<PolyDataBlock>& inputs)
{
  for (std::size_t i = 0; i < this->blocks_.size(); ++i)
  {
    if (this->blocks_[i].areInputCells)
    {
      this->blocks_[i].triangles = inputs[i].data->GetPolys();
    }
  }
}

Id PolyDataSurface::numberOfPoints() const
{
  return this->blocks_.empty()
    ? 0
    : this->blocks_.back().firstPoint + this->blocks_.back().numberOfPoints;
}

Id PolyDataSurface::numberOfTriangles() const
{
  return this->blocks_.empty() ? 0
                               : this->blocks_.back().firstTriangle +
      static_cast<Id>(this->blocks_.back().numberOfTriangles());
}

Triangle PolyDataSurface::triangle(Id triangle) const
{
  const SurfaceBlock& block = this->blocks_[this->blockOfTriangle(triangle)];
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  block.triangles->GetCellAtId(triangle - block.firstTriangle, size, points);
  const auto pointOf = [&block](vtkIdType id) { return block.firstPoint + static_cast<Id>(id); };
  return { pointOf(points[0]), pointOf(points[1]), pointOf(points[2]) };
}

// Empty blocks begin where the next one does: the last of those that begin there is meant.
std::size_t PolyDataSurface::blockOfPoint(Id point) const
{
  const auto next = std::upper_bound(this->blocks_.begin(), this->blocks_.end(), point,
    [](Id id, const SurfaceBlock& block) { return id < block.firstPoint; });
  return static_cast<std::size_t>(next - this->blocks_.begin()) - 1;
}

std::size_t PolyDataSurface::blockOfTriangle(Id triangle) const
{
  const auto next = std::upper_bound(this->blocks_.begin(), this->blocks_.end(), triangle,
    [](Id id, const SurfaceBlock& block) { return id < block.firstTriangle; });
  return static_cast<std::size_t>(next - this->blocks_.begin()) - 1;
}

std::string listIds(const std::vector<vtkIdType>& ids)
{
  const std::size_t shown = std::min<std::size_t>(ids.size(), 5);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i)
  {
    text += (i == 0 ? "" : ", ") + std::to_string(ids[i]);
  }
  if (ids.size() > shown)
  {
    text += " and " + std::to_string(ids.size() - shown) + " more";
  }
  return text;
}

}
