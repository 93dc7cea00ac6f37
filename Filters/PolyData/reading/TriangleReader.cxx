// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/TriangleReader.h"

#include "PolyData/CellLoop.h"
#include "PolyData/Memory.h"
#include "PolyData/reading/GhostCells.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace geodesic
{

namespace
{

class TriangleReader
{
public:
  /// \param numberOfCells of all blocks.
  TriangleReader(const VertexOfPoint& vertexOf, const ParallelFor& parallelFor,
    vtkIdType numberOfCells, const LoopProgress& progress, TriangleList& triangles,
    SurfaceReport& report)
    : vertexOf_(vertexOf)
    , parallelFor_(parallelFor)
    , numberOfCells_(static_cast<std::size_t>(numberOfCells))
    , progress_(progress)
    , triangles_(triangles)
    , report_(report)
  {
  }

  void read(const PolyDataBlock& input, SurfaceBlock& block)
  {
    block.firstTriangle = static_cast<Id>(this->triangles_.corners.size());
    block.areInputCells = this->readPlainTriangles(input.data, block.firstPoint);
    if (!block.areInputCells)
    {
      block.areInputCells = this->readCells(input, block.firstPoint);
    }
  }

private:
  bool readPlainTriangles(vtkPolyData* data, Id firstPoint);
  bool readPlainRange(vtkPolyData* data, Id firstPoint, std::size_t firstTriangle,
    std::size_t begin, std::size_t end);
  bool readCells(const PolyDataBlock& input, Id firstPoint);

  const VertexOfPoint& vertexOf_;
  const ParallelFor& parallelFor_;
  std::size_t numberOfCells_;
  const LoopProgress& progress_;
  /// The number of cells that have been read.
  std::size_t done_ = 0;
  TriangleList& triangles_;
  SurfaceReport& report_;
};

/// Reads a block whose cells are all triangles with three vertices. \returns whether it is one.
bool TriangleReader::readPlainTriangles(vtkPolyData* data, Id firstPoint)
{
  const vtkIdType count = data->GetNumberOfPolys();
  if (count != data->GetNumberOfCells() || GhostCells(data).areAny())
  {
    return false;
  }
  TriangleList& triangles = this->triangles_;
  const std::size_t before = triangles.corners.size();
  const std::size_t after = before + static_cast<std::size_t>(count);
  triangles.corners.resize(after);
  triangles.cells.resize(after);
  const double done = static_cast<double>(this->done_) /
    static_cast<double>(std::max<std::size_t>(this->numberOfCells_, 1));
  this->progress_.between(done, 1.0).at(0, 1);
  const std::vector<int> arePlain = resultsOfRanges(this->parallelFor_, after - before,
    [&](std::size_t begin, std::size_t end)
    { return this->readPlainRange(data, firstPoint, before, begin, end) ? 1 : 0; });
  if (std::find(arePlain.begin(), arePlain.end(), 0) != arePlain.end())
  {
    triangles.corners.resize(before);
    triangles.cells.resize(before);
    return false;
  }
  triangles.isDuplicate.resize(after, false);
  this->done_ += after - before;
  return true;
}

/// The same for a range of the cells.
bool TriangleReader::readPlainRange(
  vtkPolyData* data, Id firstPoint, std::size_t firstTriangle, std::size_t begin, std::size_t end)
{
  const auto numberOfPoints = data->GetNumberOfPoints();
  const auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator()); // one a thread
  cells->GoToCell(static_cast<vtkIdType>(begin));
  for (std::size_t i = begin; i < end; ++i, cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    const auto exists = [=](vtkIdType id) { return id >= 0 && id < numberOfPoints; };
    if (size != 3 || !std::all_of(ids, ids + 3, exists))
    {
      return false;
    }
    const auto pointOf = [=](vtkIdType id) { return firstPoint + static_cast<Id>(id); };
    const Triangle triangle = { pointOf(ids[0]), pointOf(ids[1]), pointOf(ids[2]) };
    if (!hasThreeVertices(this->vertexOf_(triangle)))
    {
      return false;
    }
    this->triangles_.corners[firstTriangle + i] = triangle;
    this->triangles_.cells[firstTriangle + i] = static_cast<vtkIdType>(i);
  }
  return true;
}

/// Reads a block of any cells. \returns whether all of these are triangles.
bool TriangleReader::readCells(const PolyDataBlock& input, Id firstPoint)
{
  const GhostCells ghosts(input.data);
  Triangulator triangulator(input, firstPoint, this->vertexOf_, this->triangles_);
  this->report_.droppedVertexCells += ghosts.countOwn(0, input.data->GetNumberOfVerts());
  // vtkPolyData numbers its cells in the order vertices, lines, polygons, strips.
  vtkIdType cell = input.data->GetNumberOfVerts();
  this->report_.droppedLineCells += ghosts.countOwn(cell, cell + input.data->GetNumberOfLines());
  cell += input.data->GetNumberOfLines();
  const auto read = [&](vtkCellArray* cells, auto add)
  {
    forEachCell(cells,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        this->progress_.at(this->done_++, this->numberOfCells_);
        if (!ghosts.isHidden(cell))
        {
          (triangulator.*add)({ cell, ghosts.isDuplicate(cell) }, size, ids);
        }
        ++cell;
      });
  };
  read(input.data->GetPolys(), &Triangulator::addPolygon);
  read(input.data->GetStrips(), &Triangulator::addStrip);
  this->report_.facesWithRepeatedPoint += triangulator.facesWithRepeatedPoint();
  return !triangulator.hasOtherCells();
}

} // anonymous namespace

TriangleList readTriangles(const std::vector<PolyDataBlock>& inputs, const VertexOfPoint& vertexOf,
  vtkIdType numberOfFaces, const LoopProgress& progress, const ParallelFor& parallelFor,
  std::vector<SurfaceBlock>& blocks, SurfaceReport& report)
{
  vtkIdType polygons = 0;
  for (const PolyDataBlock& input : inputs)
  {
    polygons += input.data->GetNumberOfPolys();
  }
  TriangleList triangles;
  triangles.corners.reserve(static_cast<std::size_t>(polygons));
  triangles.cells.reserve(static_cast<std::size_t>(polygons));
  TriangleReader reader(vertexOf, parallelFor, numberOfFaces, progress, triangles, report);
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    triangles.firstOfBlock.push_back(triangles.corners.size());
    reader.read(inputs[i], blocks[i]);
  }
  triangles.firstOfBlock.push_back(triangles.corners.size());
  return triangles;
}

void keepTriangles(const std::vector<PolyDataBlock>& inputs, const TriangleList& triangles,
  std::vector<SurfaceBlock>& blocks)
{
  for (std::size_t index = 0; index < blocks.size(); ++index)
  {
    SurfaceBlock& block = blocks[index];
    const std::size_t first = triangles.firstOfBlock[index];
    const std::size_t last = triangles.firstOfBlock[index + 1];
    const auto count = static_cast<vtkIdType>(last - first);
    block.areInputCells = block.areInputCells && count == inputs[index].data->GetNumberOfCells();
    if (block.areInputCells)
    {
      block.triangles = inputs[index].data->GetPolys();
      continue;
    }
    constexpr vtkIdType idsATriangle = 4; // three points and an offset
    requireMemory(count + 1, idsATriangle * sizeof(vtkIdType));
    block.triangles = vtkSmartPointer<vtkCellArray>::New();
    block.triangles->AllocateExact(count, 3 * count);
    const auto own = [&block](Id point)
    { return static_cast<vtkIdType>(point - block.firstPoint); };
    for (std::size_t i = first; i < last; ++i)
    {
      const Triangle& t = triangles.corners[i];
      block.triangles->InsertNextCell({ own(t[0]), own(t[1]), own(t[2]) });
    }
    const auto cells = triangles.cells.begin();
    block.inputCells.assign(
      cells + static_cast<std::ptrdiff_t>(first), cells + static_cast<std::ptrdiff_t>(last));
  }
}

}
