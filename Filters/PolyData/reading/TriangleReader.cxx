// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/TriangleReader.h"

#include "PolyData/Memory.h"
#include "mesh/PolygonTriangles.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace geodesic
{

namespace
{

constexpr int Duplicate = vtkDataSetAttributes::DUPLICATECELL;
constexpr int Hidden = vtkDataSetAttributes::HIDDENCELL;

/// The ghost array of the cells of an input; null if it marks none as a duplicate or hidden.
vtkUnsignedCharArray* ghostArray(const PolyDataBlock& block)
{
  auto* flags = vtkUnsignedCharArray::SafeDownCast(
    block.data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const vtkIdType cells = block.countInputCells();
  if (!flags || flags->GetNumberOfComponents() != 1 || flags->GetNumberOfTuples() < cells)
  {
    return nullptr;
  }
  const unsigned char* begin = flags->GetPointer(0);
  const auto isMarked = [](unsigned char flag) { return (flag & (Duplicate | Hidden)) != 0; };
  return std::any_of(begin, begin + cells, isMarked) ? flags : nullptr;
}

/// Collects the triangles of one block's cells.
struct TriangleBlockReader
{
  const PolyDataBlock& block;
  const std::size_t indexOfBlock;
  /// The number of the block's point 0 among those of all blocks.
  const Id firstPoint;
  const VertexOfPoint& vertexOf;
  /// To which triangles are added.
  TriangleList& triangles;
  SurfaceReport& report;
  vtkUnsignedCharArray* const ghosts = ghostArray(block);
  /// The current cell: vtkPolyData numbers vertices, lines, polygons and strips, in this order.
  vtkIdType cell = 0;
  bool hasOtherCells = false;
  /// The vertices of the current polygon, without repetitions.
  std::vector<vtkIdType> outline{};
  /// Where they are.
  std::vector<Vec3> places{};

  /// \param cellsRead of numberOfFaces, so far.
  /// \returns whether all cells are triangles of the input.
  bool read(const Job& job, vtkIdType numberOfFaces, std::size_t& cellsRead)
  {
    const auto count = static_cast<std::size_t>(numberOfFaces);
    const double done =
      static_cast<double>(cellsRead) / static_cast<double>(std::max<std::size_t>(count, 1));
    if (!this->ghosts && this->block.inputCells.empty() &&
      this->block.data->GetNumberOfPolys() == this->block.data->GetNumberOfCells())
    {
      if (this->readPlainTriangles(job.part(done, 1.0)))
      {
        cellsRead += static_cast<std::size_t>(this->block.data->GetNumberOfPolys());
        return true;
      }
    }
    this->report.droppedVertexCells += this->countUnmarked(this->block.data->GetNumberOfVerts());
    this->report.droppedLineCells += this->countUnmarked(this->block.data->GetNumberOfLines());
    const auto readAll = [&](vtkCellArray* cells, auto add)
    {
      forEachCell(cells,
        [&](vtkIdType size, const vtkIdType* ids)
        {
          job.reachItem(cellsRead++, count);
          if (!this->isMarked(Hidden))
          {
            requirePoints(this->block, this->inputCell(), size, ids);
            (this->*add)(size, ids);
          }
          ++this->cell;
        });
    };
    readAll(this->block.data->GetPolys(), &TriangleBlockReader::addPolygon);
    readAll(this->block.data->GetStrips(), &TriangleBlockReader::addStrip);
    return !this->hasOtherCells && this->block.inputCells.empty();
  }

  /// The number in the input of the current cell.
  vtkIdType inputCell() const { return this->block.inputCell(this->cell); }
  /// Whether the ghost array marks the current cell.
  bool isMarked(int mark) const
  {
    return this->ghosts && (this->ghosts->GetValue(this->inputCell()) & mark) != 0;
  }
  /// How many of the next cells are neither duplicates nor hidden.
  vtkIdType countUnmarked(vtkIdType cells)
  {
    vtkIdType unmarked = 0;
    for (const vtkIdType end = this->cell + cells; this->cell < end; ++this->cell)
    {
      unmarked += this->isMarked(Duplicate | Hidden) ? 0 : 1;
    }
    return unmarked;
  }

  Id pointOf(vtkIdType id) const { return this->firstPoint + static_cast<Id>(id); }
  Triangle pointsOf(vtkIdType a, vtkIdType b, vtkIdType c) const
  {
    return { this->pointOf(a), this->pointOf(b), this->pointOf(c) };
  }

  /// Reads a block whose cells are all triangles with three vertices. \returns whether it is one.
  bool readPlainTriangles(const Job& job)
  {
    std::vector<Triangle>& corners = this->triangles.corners;
    std::vector<vtkIdType>& cells = this->triangles.cells;
    const std::size_t before = corners.size();
    const auto count = static_cast<std::size_t>(this->block.data->GetNumberOfPolys());
    corners.resize(before + count);
    cells.resize(before + count);
    const auto exists = [end = this->block.data->GetNumberOfPoints()](vtkIdType id)
    { return id >= 0 && id < end; };
    const auto readRange = [&](std::size_t begin, std::size_t end)
    {
      const auto at = vtk::TakeSmartPointer(this->block.data->GetPolys()->NewIterator());
      at->GoToCell(static_cast<vtkIdType>(begin));
      for (std::size_t i = begin; i < end; ++i, at->GoToNextCell())
      {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        at->GetCurrentCell(size, ids);
        if (size != 3 || !std::all_of(ids, ids + 3, exists))
        {
          return 0;
        }
        corners[before + i] = this->pointsOf(ids[0], ids[1], ids[2]);
        cells[before + i] = static_cast<vtkIdType>(i);
        if (!hasThreeVertices(this->vertexOf(corners[before + i])))
        {
          return 0;
        }
      }
      return 1;
    };
    const std::vector<int> arePlain = job.resultsOfRanges(count, readRange);
    const bool areAllPlain = std::find(arePlain.begin(), arePlain.end(), 0) == arePlain.end();
    corners.resize(areAllPlain ? before + count : before);
    cells.resize(corners.size());
    this->triangles.isDuplicate.resize(corners.size(), false);
    return areAllPlain;
  }

  void addPolygon(vtkIdType size, const vtkIdType* ids)
  {
    if (size == 3)
    {
      this->addTriangle(ids[0], ids[1], ids[2]);
      return;
    }
    this->hasOtherCells = true;
    this->outline.clear();
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType next = ids[(i + 1) % size];
      if (this->vertexOf(this->pointOf(ids[i])) != this->vertexOf(this->pointOf(next)))
      {
        this->outline.push_back(ids[i]);
      }
    }
    if (this->outline.size() < 3)
    {
      this->leaveOut();
      return;
    }
    this->cutOutline();
  }

  void addStrip(vtkIdType size, const vtkIdType* ids)
  {
    this->hasOtherCells = true;
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2;
      this->addTriangle(ids[i + odd], ids[i + 1 - odd], ids[i + 2]);
    }
  }

  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const Triangle points = this->pointsOf(a, b, c);
    if (!hasThreeVertices(this->vertexOf(points)))
    {
      this->leaveOut();
      return;
    }
    this->appendTriangle(points);
  }
  void appendTriangle(const Triangle& points)
  {
    this->triangles.corners.push_back(points);
    this->triangles.cells.push_back(this->inputCell());
    this->triangles.isDuplicate.push_back(this->isMarked(Duplicate));
  }

  void leaveOut() { this->report.facesWithRepeatedPoint += this->isMarked(Duplicate) ? 0 : 1; }

  void cutOutline()
  {
    this->places.resize(this->outline.size());
    for (std::size_t i = 0; i < this->outline.size(); ++i)
    {
      this->block.data->GetPoint(this->outline[i], this->places[i].data());
    }
    const PolygonTriangles cut = triangulatePolygon(this->places);
    const std::size_t before = this->triangles.corners.size();
    for (const Triangle& t : cut.triangles)
    {
      const Triangle points =
        this->pointsOf(this->outline[t[0]], this->outline[t[1]], this->outline[t[2]]);
      if (hasThreeVertices(this->vertexOf(points)))
      {
        this->appendTriangle(points);
      }
    }
    if (this->triangles.corners.size() == before)
    {
      this->leaveOut();
    }
    else if (cut.crossesItself && !this->isMarked(Duplicate))
    {
      this->report.addCrossingOutline(this->indexOfBlock, this->inputCell());
    }
  }
};

} // anonymous namespace

TriangleList readTriangles(const std::vector<PolyDataBlock>& inputs, const VertexOfPoint& vertexOf,
  vtkIdType numberOfFaces, const Job& job, std::vector<SurfaceBlock>& blocks, SurfaceReport& report)
{
  TriangleList triangles;
  triangles.corners.reserve(static_cast<std::size_t>(numberOfFaces));
  triangles.cells.reserve(static_cast<std::size_t>(numberOfFaces));
  std::size_t cellsRead = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    triangles.firstOfBlock.push_back(triangles.corners.size());
    blocks[i].firstTriangle = static_cast<Id>(triangles.corners.size());
    TriangleBlockReader reader{ inputs[i], i, blocks[i].firstPoint, vertexOf, triangles, report };
    blocks[i].areInputCells = reader.read(job, numberOfFaces, cellsRead);
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
