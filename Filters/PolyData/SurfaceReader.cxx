// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/SurfaceReader.h"

#include "PolyData/ArrayMemory.h"
#include "PolyData/PointMerger.h"
#include "PolyData/Triangulator.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

// Where the stages end, as fractions of the whole.
constexpr double PointsRead = 0.1;
constexpr double PointsMerged = 0.25;
constexpr double TrianglesRead = 0.4;

bool isFinite(const Vec3& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// The diagonal of the bounding box of the points that triangles use: others are not surface, and
/// may lie anywhere.
double diagonalOf(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  Vec3 low = points[triangles.front()[0]];
  Vec3 high = low;
  for (const Triangle& triangle : triangles)
  {
    for (const Id corner : triangle)
    {
      const Vec3& p = points[corner];
      for (std::size_t k = 0; k < 3; ++k)
      {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
  }
  return norm(high - low);
}

template <typename Visitor>
void forEachCell(vtkCellArray* cells, Visitor&& visit)
{
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    visit(size, ids);
  }
}

/// Reads the blocks of one surface, stage by stage.
class SurfaceReader
{
public:
  SurfaceReader(const std::vector<PolyDataBlock>& inputs, const ProgressCallback& callback)
    : inputs_(inputs)
    , callback_(callback)
    , progress_(callback)
    , blocks_(inputs.size())
  {
  }

  PolyDataSurface read(bool mergeCoincidentPoints)
  {
    const vtkIdType faces = this->requireFaces();
    this->progress_.nextUntil(PointsRead);
    this->readPoints();
    this->progress_.nextUntil(PointsMerged);
    if (mergeCoincidentPoints)
    {
      geodesic::mergeCoincidentPoints(this->vertices_, this->vertexOfPoint_, this->progress_);
    }
    this->progress_.nextUntil(TrianglesRead);
    this->readTriangles(faces);
    for (std::size_t i = 0; i < this->blocks_.size(); ++i)
    {
      this->keepTriangles(i);
    }
    this->nameVertices();
    const double diagonal = diagonalOf(this->vertices_, this->triangles_.corners);
    std::unique_ptr<TriangleMesh> mesh = this->makeMesh();
    return { std::move(mesh), std::move(this->vertexOfPoint_), std::move(this->blocks_), diagonal,
      this->report_ };
  }

private:
  vtkIdType requireFaces() const;
  void readPoints();
  void readPoints(const PolyDataBlock& input);
  void readTriangles(vtkIdType faces);
  void readTriangles(std::size_t block, const std::function<void()>& next);
  void keepTriangles(std::size_t block);
  void nameVertices();
  std::unique_ptr<TriangleMesh> makeMesh();

  const std::vector<PolyDataBlock>& inputs_;
  const ProgressCallback& callback_;
  LoopProgress progress_;
  std::vector<SurfaceBlock> blocks_;
  std::vector<Vec3> vertices_;
  std::vector<Id> vertexOfPoint_;
  TriangleList triangles_;
  /// Cells of more than three corners in each block.
  std::vector<vtkIdType> polygons_;
  PolyDataSurface::Report report_;
};

/// How many cells are faces.
///
/// \throws MeshError where there are none.
vtkIdType SurfaceReader::requireFaces() const
{
  vtkIdType faces = 0;
  for (const PolyDataBlock& input : this->inputs_)
  {
    faces += input.data->GetNumberOfPolys() + input.data->GetNumberOfStrips();
  }
  if (faces == 0)
  {
    throw MeshError("The surface (input port 0) has no faces. Connect a vtkPolyData with triangles "
                    "or polygons, for example by the Extract Surface filter.");
  }
  return faces;
}

void SurfaceReader::readPoints()
{
  vtkIdType count = 0;
  for (std::size_t i = 0; i < this->inputs_.size(); ++i)
  {
    const vtkIdType own = this->inputs_[i].data->GetNumberOfPoints();
    this->blocks_[i].firstPoint = static_cast<Id>(count);
    this->blocks_[i].numberOfPoints = static_cast<Id>(own);
    count += own;
    if (count >= static_cast<vtkIdType>(NoId))
    {
      throw MeshTooLarge("The surface (input port 0) has " + std::to_string(count) +
        " points, more than 32-bit ids can number. Decimate it or cut it into parts.");
    }
  }
  this->vertices_.reserve(static_cast<std::size_t>(count));
  for (const PolyDataBlock& input : this->inputs_)
  {
    this->readPoints(input);
  }
}

/// \throws MeshError where a coordinate is not finite.
void SurfaceReader::readPoints(const PolyDataBlock& input)
{
  vtkPoints* points = input.data->GetPoints();
  const vtkIdType count = input.data->GetNumberOfPoints();
  std::vector<vtkIdType> bad;
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->progress_.at(this->vertices_.size(), this->vertices_.capacity());
    Vec3& p = this->vertices_.emplace_back();
    points->GetPoint(i, p.data());
    if (!isFinite(p))
    {
      bad.push_back(i);
    }
  }
  if (!bad.empty())
  {
    throw MeshError(capitalized(input.name) +
      " has coordinates that are NaN or infinite, at point " + listIds(bad) +
      ". Remove or repair these points upstream.");
  }
}

void SurfaceReader::readTriangles(vtkIdType faces)
{
  vtkIdType polygons = 0;
  for (const PolyDataBlock& input : this->inputs_)
  {
    polygons += input.data->GetNumberOfPolys();
  }
  this->triangles_.corners.reserve(static_cast<std::size_t>(polygons));
  this->triangles_.cells.reserve(static_cast<std::size_t>(polygons));
  std::size_t done = 0;
  const auto next = [&]() { this->progress_.at(done++, static_cast<std::size_t>(faces)); };
  for (std::size_t i = 0; i < this->inputs_.size(); ++i)
  {
    this->blocks_[i].firstTriangle = static_cast<Id>(this->triangles_.corners.size());
    this->readTriangles(i, next);
  }
  if (this->triangles_.corners.empty())
  {
    throw MeshError("None of the " + std::to_string(faces) +
      " faces of the surface (input port 0) has three different corners. Connect a surface with "
      "triangles or polygons.");
  }
}

void SurfaceReader::readTriangles(std::size_t block, const std::function<void()>& next)
{
  const PolyDataBlock& input = this->inputs_[block];
  Triangulator triangulator(
    input, this->blocks_[block].firstPoint, this->vertexOfPoint_, this->triangles_);
  // vtkPolyData numbers its cells in the order vertices, lines, polygons, strips.
  vtkIdType cell = input.data->GetNumberOfVerts() + input.data->GetNumberOfLines();
  forEachCell(input.data->GetPolys(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      next();
      triangulator.addPolygon(cell++, size, ids);
    });
  forEachCell(input.data->GetStrips(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      next();
      triangulator.addStrip(cell++, size, ids);
    });
  this->polygons_.push_back(triangulator.polygons());
  this->report_.facesWithRepeatedPoint += triangulator.facesWithRepeatedPoint();
  this->report_.polygons += triangulator.polygons();
  this->report_.droppedVertexCells += input.data->GetNumberOfVerts();
  this->report_.droppedLineCells += input.data->GetNumberOfLines();
  this->report_.strips += input.data->GetNumberOfStrips();
}

/// Gives a block its triangles: the input's own cells where these are the same.
void SurfaceReader::keepTriangles(std::size_t index)
{
  vtkPolyData* input = this->inputs_[index].data;
  SurfaceBlock& block = this->blocks_[index];
  const std::size_t first = block.firstTriangle;
  const std::size_t last = index + 1 < this->blocks_.size() ? this->blocks_[index + 1].firstTriangle
                                                            : this->triangles_.corners.size();
  const auto count = static_cast<vtkIdType>(last - first);
  if (this->polygons_[index] == 0 && input->GetNumberOfStrips() == 0 &&
    count == input->GetNumberOfCells())
  {
    block.triangles = input->GetPolys();
    return;
  }
  constexpr vtkIdType idsATriangle = 4; // three points and an offset
  requireMemory(count + 1, idsATriangle * sizeof(vtkIdType));
  block.triangles = vtkSmartPointer<vtkCellArray>::New();
  block.triangles->AllocateExact(count, 3 * count);
  const auto own = [&block](Id point) { return static_cast<vtkIdType>(point - block.firstPoint); };
  for (std::size_t i = first; i < last; ++i)
  {
    const Triangle& t = this->triangles_.corners[i];
    block.triangles->InsertNextCell({ own(t[0]), own(t[1]), own(t[2]) });
  }
  const auto cells = this->triangles_.cells.begin();
  block.inputCells.assign(
    cells + static_cast<std::ptrdiff_t>(first), cells + static_cast<std::ptrdiff_t>(last));
}

/// From here on the corners of the triangles are vertices in place of points.
void SurfaceReader::nameVertices()
{
  this->triangles_.cells = {};
  if (this->vertexOfPoint_.empty())
  {
    return;
  }
  for (Triangle& triangle : this->triangles_.corners)
  {
    for (Id& corner : triangle)
    {
      corner = this->vertexOfPoint_[corner];
    }
  }
}

std::unique_ptr<TriangleMesh> SurfaceReader::makeMesh()
{
  return std::make_unique<TriangleMesh>(std::move(this->vertices_), this->triangles_.corners,
    [this](double fraction) {
      return !this->callback_ || this->callback_(TrianglesRead + (1.0 - TrianglesRead) * fraction);
    });
}

}

PolyDataSurface readSurface(const std::vector<PolyDataBlock>& blocks, bool mergeCoincidentPoints,
  const ProgressCallback& progress)
{
  return SurfaceReader(blocks, progress).read(mergeCoincidentPoints);
}

}
