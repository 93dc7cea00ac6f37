// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/PolyDataSurface.h"

#include "Questions.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace geodesic
{

void SurfaceReport::addRanks(const MeshPartition& partition)
{
  // An edge counts on the rank that owns its first face.
  const Id end = TriangleMesh::halfedgeOf(partition.endOfOwnFaces(), 0);
  for (Id h = TriangleMesh::halfedgeOf(partition.firstOwnFace(), 0); h < end; ++h)
  {
    this->edges += partition.mesh().edgeOf(h) == h ? 1 : 0;
  }
  const std::vector<SurfaceReport> reports = valuesOfRanks(partition.exchange(), *this);
  this->cellOfFirstCrossing = reports.size() > 1 ? -1 : this->cellOfFirstCrossing;
  using Report = SurfaceReport;
  for (vtkIdType Report::*count :
    { &Report::droppedVertexCells, &Report::droppedLineCells, &Report::facesWithRepeatedPoint,
      &Report::crossingOutlines, &Report::joinedSeamPoints, &Report::crackEdges, &Report::edges })
  {
    this->*count = std::accumulate(reports.begin(), reports.end(), vtkIdType(0),
      [count](vtkIdType sum, const Report& report) { return sum + report.*count; });
  }
  for (const Report& report : reports)
  {
    this->crackWidth = std::max(this->crackWidth, report.crackWidth);
  }
}

std::vector<GlobalVertex> PolyDataSurface::remoteVertices() const
{
  std::vector<GlobalVertex> vertices = this->valuesElsewhere.copies(
    GlobalVertex(), this->exchange(), [this](Id vertex) { return this->vertexOfMesh(vertex); });
  const Id inMesh = this->mesh().numberOfVertices();
  for (Id i = 0; i < this->barrierVertices.size(); ++i)
  {
    const Id vertex = this->barrierVertices[i];
    if (vertex >= inMesh && vertices[vertex - inMesh].globalId == GlobalId{ NoId })
    {
      const MeshPartition& onBarriers = this->barriers->surface();
      vertices[vertex - inMesh] = { GlobalId{ this->partition.numberOfGlobalVertices() +
                                      static_cast<Id>(onBarriers.globalId(i)) },
        onBarriers.mesh().point(i) };
    }
  }
  return vertices;
}

const TriangleMesh& PolyDataSurface::noMesh()
{
  static const TriangleMesh none;
  return none;
}

void PolyDataSurface::useBlocks(const std::vector<PolyDataBlock>& inputs)
{
  for (std::size_t i = 0; i < this->blocks.size(); ++i)
  {
    SurfaceBlock& block = this->blocks[i];
    block.name = inputs[i].name;
    block.numberOfInputCells = inputs[i].countInputCells();
    block.triangles = block.areInputCells ? inputs[i].data->GetPolys() : block.triangles.Get();
  }
}

std::uint64_t PolyDataSurface::countPartsOfAllRanks() const
{
  const auto copies = std::count(this->roles.begin(), this->roles.end(), TriangleRole::Copy);
  return sumOverRanks(this->exchange(), this->numberOfParts - static_cast<Id>(copies)).all;
}

Triangle pointsOfTriangle(const std::vector<SurfaceBlock>& blocks, Id triangle)
{
  const SurfaceBlock& block = blocks[blockOf(blocks, triangle, &SurfaceBlock::firstTriangle)];
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  block.triangles->GetCellAtId(triangle - block.firstTriangle, size, points);
  const auto pointOf = [&block](vtkIdType id) { return block.firstPoint + static_cast<Id>(id); };
  return { pointOf(points[0]), pointOf(points[1]), pointOf(points[2]) };
}

// Empty blocks begin where the next one does: the last of those that begin there is meant.
std::size_t blockOf(const std::vector<SurfaceBlock>& blocks, Id item, Id SurfaceBlock::*first)
{
  const auto next = std::upper_bound(blocks.begin(), blocks.end(), item,
    [first](Id id, const SurfaceBlock& block) { return id < block.*first; });
  return static_cast<std::size_t>(next - blocks.begin()) - 1;
}

std::string PolyDataSurface::nameOfCell(Id triangle) const
{
  const auto [block, cell] = this->inputCellOf(triangle);
  return this->blocks[block].name.part("cell", cell).text();
}

std::vector<vtkIdType> PolyDataSurface::inputCellsOf(const std::vector<RankAddress>& faces) const
{
  std::vector<vtkIdType> firstCells = { 0 };
  for (const SurfaceBlock& block : this->blocks)
  {
    firstCells.push_back(firstCells.back() + block.numberOfInputCells);
  }
  const auto before = static_cast<vtkIdType>(
    sumOverRanks(this->exchange(), static_cast<std::uint64_t>(firstCells.back())).before);
  const auto cellOf = [&](Id face)
  {
    const auto [block, cell] = this->inputCellOf(this->triangleOf(face));
    return before + firstCells[block] + cell;
  };
  std::vector<vtkIdType> cells(faces.size());
  Questions questions(this->exchange());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (faces[i].rank == this->exchange().rank())
    {
      cells[i] = cellOf(faces[i].id); // nearly all
    }
    else
    {
      questions.ask(faces[i].rank, i, faces[i].id);
    }
  }
  questions.exchangeAnswers([&cellOf](MessageReader& question, Message& answer)
    { put(answer, cellOf(question.get<Id>())); },
    [&cells](std::size_t i, MessageReader& answer) { cells[i] = answer.get<vtkIdType>(); });
  return cells;
}

std::array<std::uint64_t, 2> endsOf(const FaceEdge& edge)
{
  return { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) };
}

std::vector<FaceEdge> edgesOfOneFace(const std::vector<FaceEdge>& edges)
{
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return endsOf(edges[a]) < endsOf(edges[b]); });
  std::vector<std::size_t> single;
  for (auto first = order.begin(); first != order.end();)
  {
    const FaceEdge& edge = edges[*first];
    const auto end = std::find_if(
      first, order.end(), [&](std::size_t i) { return endsOf(edges[i]) != endsOf(edge); });
    if (std::all_of(first, end, [&](std::size_t i) { return edges[i][2] == edge[2]; }))
    {
      single.push_back(*first);
    }
    first = end;
  }
  std::sort(single.begin(), single.end());
  std::vector<FaceEdge> found;
  for (const std::size_t i : single)
  {
    found.push_back(edges[i]);
  }
  return found;
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
