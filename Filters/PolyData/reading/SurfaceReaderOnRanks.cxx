// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SurfaceReaderOnRanks.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

/// A global id and a vertex for each point; empty if points of any rank have no global ids.
std::vector<KeyedVertex> globalIds(const std::vector<PolyDataBlock>& inputs,
  const std::vector<SurfaceBlock>& blocks, const VertexOfPoint& vertexOf, Exchange& exchange)
{
  std::vector<KeyedVertex> ids;
  bool isComplete = true;
  for (std::size_t block = 0; block < blocks.size() && isComplete; ++block)
  {
    vtkPolyData* data = inputs[block].data;
    vtkDataArray* array = data->GetPointData()->GetGlobalIds();
    if (!array)
    {
      array = data->GetPointData()->GetArray("GlobalPointIds");
    }
    const vtkIdType count = data->GetNumberOfPoints();
    isComplete = count == 0 || (array && array->GetNumberOfTuples() >= count);
    for (vtkIdType i = 0; i < count && isComplete; ++i)
    {
      ids.push_back({ { array->GetComponent(i, 0), 0.0, 0.0, 1.0 },
        vertexOf(blocks[block].firstPoint + static_cast<Id>(i)) });
    }
  }
  if (exchange.isTrueAnywhere(!isComplete))
  {
    ids.clear();
  }
  return ids;
}

} // anonymous namespace

void joinRanks(const std::vector<PolyDataBlock>& inputs, const std::vector<SurfaceBlock>& blocks,
  bool byPlace, Exchange& exchange, PieceVertices& vertices)
{
  if (exchange.numberOfRanks() == 1)
  {
    return;
  }
  vertices.labels = joinSameVertices(
    vertices.positions, byPlace, globalIds(inputs, blocks, vertices.of, exchange), exchange);
  vertices.joinSameLabels();
}

std::vector<Id> keepUsedVertices(std::vector<Triangle>& faces, const Exchange& exchange,
  PieceVertices& vertices, std::vector<std::uint64_t>& keys)
{
  if (exchange.numberOfRanks() == 1)
  {
    return {};
  }
  std::vector<Id> numbers(vertices.positions.size(), NoId);
  const std::vector<Id> used = numberUsedVertices(faces, numbers.size());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    numbers[used[i]] = static_cast<Id>(i);
  }
  std::vector<Vec3> points;
  vertices.copy(used, points, keys);
  vertices.positions = std::move(points);
  return numbers;
}

Box boxOfRanks(const Box& own, Exchange& exchange)
{
  Box whole;
  for (const Box& box : valuesOfRanks(exchange, own))
  {
    whole.add(box);
  }
  return whole;
}

SurfaceReport reportOfRanks(SurfaceReport own, const MeshPartition& partition)
{
  const TriangleMesh& mesh = partition.mesh();
  if (!partition.isDistributed())
  {
    own.edges = mesh.numberOfEdges();
    return own;
  }
  // An edge counts on the rank that owns its first face.
  const Id end = TriangleMesh::halfedgeOf(partition.endOfOwnFaces(), 0);
  for (Id halfedge = TriangleMesh::halfedgeOf(partition.firstOwnFace(), 0); halfedge < end;
       ++halfedge)
  {
    own.edges += mesh.edgeOf(halfedge) == halfedge ? 1 : 0;
  }
  SurfaceReport all;
  for (const SurfaceReport& report : valuesOfRanks(partition.exchange(), own))
  {
    all.droppedVertexCells += report.droppedVertexCells;
    all.droppedLineCells += report.droppedLineCells;
    all.facesWithRepeatedPoint += report.facesWithRepeatedPoint;
    all.crossingOutlines += report.crossingOutlines;
    all.joinedSeamPoints += report.joinedSeamPoints;
    all.crackEdges += report.crackEdges;
    all.crackWidth = std::max(all.crackWidth, report.crackWidth);
    all.edges += report.edges;
  }
  return all;
}

}
