// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/TriangleReader.h"

#include "PolyData/Memory.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#include <algorithm>

namespace geodesic
{

namespace
{

constexpr int Duplicate = vtkDataSetAttributes::DUPLICATECELL;
constexpr int Hidden = vtkDataSetAttributes::HIDDENCELL;

/// The ghost array of a vtkPolyData; null if it marks no cell as a duplicate or hidden.
vtkUnsignedCharArray* ghostArray(vtkPolyData* data)
{
  auto* flags = vtkUnsignedCharArray::SafeDownCast(
    data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!flags || flags->GetNumberOfComponents() != 1 ||
    flags->GetNumberOfTuples() < data->GetNumberOfCells())
  {
    return nullptr;
  }
  const unsigned char* begin = flags->GetPointer(0);
  const auto isMarked = [](unsigned char flag) { return (flag & (Duplicate | Hidden)) != 0; };
  return std::any_of(begin, begin + data->GetNumberOfCells(), isMarked) ? flags : nullptr;
}

/// Collects the triangles of one block's cells.
class BlockReader
{
public:
  /// \param firstPoint the number of the block's point 0 among those of all blocks.
  /// \param triangles to which triangles are added.
  BlockReader(const PolyDataBlock& block, Id firstPoint, const VertexOfPoint& vertexOf,
    TriangleList& triangles, SurfaceReport& report)
    : block_(block)
    , ghosts_(ghostArray(block.data))
    , firstPoint_(firstPoint)
    , vertexOf_(vertexOf)
    , triangles_(triangles)
    , report_(report)
  {
  }

  /// \param cellsRead of numberOfFaces, for the progress.
  /// \returns whether all cells are triangles.
  bool read(const ParallelFor& parallelFor, const LoopProgress& progress, vtkIdType numberOfFaces,
    std::size_t& cellsRead)
  {
    const auto count = static_cast<std::size_t>(numberOfFaces);
    const double done =
      static_cast<double>(cellsRead) / static_cast<double>(std::max<std::size_t>(count, 1));
    if (!this->ghosts_ &&
      this->block_.data->GetNumberOfPolys() == this->block_.data->GetNumberOfCells())
    {
      progress.between(done, 1.0).at(0, 1);
      if (this->readPlainTriangles(parallelFor))
      {
        cellsRead += static_cast<std::size_t>(this->block_.data->GetNumberOfPolys());
        return true;
      }
    }
    this->report_.droppedVertexCells += this->countUnmarked(this->block_.data->GetNumberOfVerts());
    this->report_.droppedLineCells += this->countUnmarked(this->block_.data->GetNumberOfLines());
    const auto readAll = [&](vtkCellArray* cells, auto add)
    {
      forEachCell(cells,
        [&](vtkIdType size, const vtkIdType* ids)
        {
          progress.at(cellsRead++, count);
          if (!this->isMarked(Hidden))
          {
            requirePoints<MeshError>(this->block_, this->cell_, size, ids);
            (this->*add)(size, ids);
          }
          ++this->cell_;
        });
    };
    readAll(this->block_.data->GetPolys(), &BlockReader::addPolygon);
    readAll(this->block_.data->GetStrips(), &BlockReader::addStrip);
    return !this->hasOtherCells_;
  }

private:
  /// Whether the ghost array marks the current cell.
  bool isMarked(int mark) const
  {
    return this->ghosts_ && (this->ghosts_->GetValue(this->cell_) & mark) != 0;
  }
  /// Of the next cells how many are neither duplicates nor hidden.
  vtkIdType countUnmarked(vtkIdType cells)
  {
    vtkIdType unmarked = 0;
    for (const vtkIdType end = this->cell_ + cells; this->cell_ < end; ++this->cell_)
    {
      unmarked += this->isMarked(Duplicate | Hidden) ? 0 : 1;
    }
    return unmarked;
  }

  Id pointOf(vtkIdType id) const { return this->firstPoint_ + static_cast<Id>(id); }
  Triangle pointsOf(vtkIdType a, vtkIdType b, vtkIdType c) const
  {
    return { this->pointOf(a), this->pointOf(b), this->pointOf(c) };
  }

  /// Reads a block whose cells are all triangles with three vertices. \returns whether it is one.
  bool readPlainTriangles(const ParallelFor& parallelFor)
  {
    TriangleList& triangles = this->triangles_;
    const std::size_t before = triangles.corners.size();
    const auto count = static_cast<std::size_t>(this->block_.data->GetNumberOfPolys());
    triangles.corners.resize(before + count);
    triangles.cells.resize(before + count);
    const auto exists = [end = this->block_.data->GetNumberOfPoints()](vtkIdType id)
    { return id >= 0 && id < end; };
    const auto readRange = [&](std::size_t begin, std::size_t end)
    {
      const auto cells = vtk::TakeSmartPointer(this->block_.data->GetPolys()->NewIterator());
      cells->GoToCell(static_cast<vtkIdType>(begin));
      for (std::size_t i = begin; i < end; ++i, cells->GoToNextCell())
      {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCurrentCell(size, ids);
        if (size != 3 || !std::all_of(ids, ids + 3, exists))
        {
          return 0;
        }
        triangles.corners[before + i] = this->pointsOf(ids[0], ids[1], ids[2]);
        triangles.cells[before + i] = static_cast<vtkIdType>(i);
        if (!hasThreeVertices(this->vertexOf_(triangles.corners[before + i])))
        {
          return 0;
        }
      }
      return 1;
    };
    const std::vector<int> arePlain = resultsOfRanges(parallelFor, count, readRange);
    const bool areAllPlain = std::find(arePlain.begin(), arePlain.end(), 0) == arePlain.end();
    triangles.corners.resize(areAllPlain ? before + count : before);
    triangles.cells.resize(triangles.corners.size());
    triangles.isDuplicate.resize(triangles.corners.size(), false);
    return areAllPlain;
  }

  void addPolygon(vtkIdType size, const vtkIdType* ids)
  {
    if (size == 3)
    {
      this->addTriangle(ids[0], ids[1], ids[2]);
      return;
    }
    this->hasOtherCells_ = true;
    this->outline_.clear();
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType next = ids[(i + 1) % size];
      if (this->vertexOf_(this->pointOf(ids[i])) != this->vertexOf_(this->pointOf(next)))
      {
        this->outline_.push_back(ids[i]);
      }
    }
    if (this->outline_.size() < 3)
    {
      this->leaveOut();
      return;
    }
    this->cutEars();
  }

  void addStrip(vtkIdType size, const vtkIdType* ids)
  {
    this->hasOtherCells_ = true;
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2;
      this->addTriangle(ids[i + odd], ids[i + 1 - odd], ids[i + 2]);
    }
  }

  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const Triangle points = this->pointsOf(a, b, c);
    if (!hasThreeVertices(this->vertexOf_(points)))
    {
      this->leaveOut();
      return;
    }
    this->triangles_.corners.push_back(points);
    this->triangles_.cells.push_back(this->cell_);
    this->triangles_.isDuplicate.push_back(this->isMarked(Duplicate));
  }

  void leaveOut() { this->report_.facesWithRepeatedPoint += this->isMarked(Duplicate) ? 0 : 1; }

  void cutEars()
  {
    const std::vector<vtkIdType>& outline = this->outline_;
    const auto size = static_cast<vtkIdType>(outline.size());
    this->polygon_->Initialize(
      static_cast<int>(size), outline.data(), this->block_.data->GetPoints());
#if VTK_VERSION_NUMBER >= 90300000000ULL
    this->polygon_->TriangulateLocalIds(0, this->ears_);
#else
    this->polygon_->Triangulate(this->ears_);
#endif
    if (this->ears_->GetNumberOfIds() != 3 * (size - 2))
    {
      // No area or an outline that crosses itself: any triangles conduct.
      for (std::size_t i = 1; i + 1 < outline.size(); ++i)
      {
        this->addTriangle(outline[0], outline[i], outline[i + 1]);
      }
      return;
    }
    const auto corner = [&](vtkIdType i)
    { return outline[static_cast<std::size_t>(this->ears_->GetId(i))]; };
    for (vtkIdType i = 0; i < 3 * (size - 2); i += 3)
    {
      this->addTriangle(corner(i), corner(i + 1), corner(i + 2));
    }
  }

  const PolyDataBlock& block_;
  vtkUnsignedCharArray* ghosts_;
  Id firstPoint_;
  const VertexOfPoint& vertexOf_;
  TriangleList& triangles_;
  SurfaceReport& report_;
  /// The current cell: vtkPolyData numbers vertices, lines, polygons and strips, in this order.
  vtkIdType cell_ = 0;
  bool hasOtherCells_ = false;
  /// Of a polygon, without repeated vertices.
  std::vector<vtkIdType> outline_;
  vtkNew<vtkPolygon> polygon_;
  vtkNew<vtkIdList> ears_;
};

} // anonymous namespace

TriangleList readTriangles(const std::vector<PolyDataBlock>& inputs, const VertexOfPoint& vertexOf,
  vtkIdType numberOfFaces, const LoopProgress& progress, const ParallelFor& parallelFor,
  std::vector<SurfaceBlock>& blocks, SurfaceReport& report)
{
  TriangleList triangles;
  triangles.corners.reserve(static_cast<std::size_t>(numberOfFaces));
  triangles.cells.reserve(static_cast<std::size_t>(numberOfFaces));
  std::size_t cellsRead = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    triangles.firstOfBlock.push_back(triangles.corners.size());
    blocks[i].firstTriangle = static_cast<Id>(triangles.corners.size());
    BlockReader reader(inputs[i], blocks[i].firstPoint, vertexOf, triangles, report);
    blocks[i].areInputCells = reader.read(parallelFor, progress, numberOfFaces, cellsRead);
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
