// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/PolyDataSurface.h"

#include "PolyData/ArrayMemory.h"
#include "Errors.h"
#include "mesh/SurfaceSnap.h"
#include "Tolerance.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

namespace geodesic
{

namespace
{

/// Of the progress, where the triangles have been read.
constexpr double TrianglesRead = 0.4;

bool isFinite(const Vec3& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// \throws MeshError
std::vector<Vec3> readPoints(vtkPoints* points, const LoopProgress& progress)
{
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  if (count >= static_cast<vtkIdType>(NoId))
  {
    throw MeshTooLarge("The surface (input port 0) has " + std::to_string(count) +
      " points, more than 32-bit ids can number. Decimate it or cut it into parts.");
  }
  std::vector<Vec3> result(static_cast<std::size_t>(count));
  std::vector<vtkIdType> bad;
  for (vtkIdType i = 0; i < count; ++i)
  {
    progress.at(static_cast<std::size_t>(i), result.size());
    Vec3& p = result[static_cast<std::size_t>(i)];
    points->GetPoint(i, p.data());
    if (!isFinite(p))
    {
      bad.push_back(i);
    }
  }
  if (!bad.empty())
  {
    throw MeshError(
      "The surface (input port 0) has coordinates that are NaN or infinite, at point " +
      listIds(bad) + ". Remove or repair these points upstream.");
  }
  return result;
}

double diagonalOf(const std::vector<Vec3>& points)
{
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& p : points)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return norm(high - low);
}

std::uint64_t hashOf(const Vec3& p)
{
  std::uint64_t hash = 0;
  for (const double x : p)
  {
    const double normalized = x + 0.0; // -0 and 0 are one place
    std::uint64_t bits;
    std::memcpy(&bits, &normalized, sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Merges points that lie at exactly one place, keeping the order of the first ones. A hash table
/// rather than a point locator, whose buckets degenerate where most points crowd in a corner of the
/// bounding box.
///
/// \param points in: all points; out: one a place.
/// \param vertexOfPoint the place of each; left empty where no two points coincide.
void mergeCoincident(
  std::vector<Vec3>& points, std::vector<Id>& vertexOfPoint, const LoopProgress& progress)
{
  std::size_t capacity = 16;
  while (capacity < 2 * points.size())
  {
    capacity *= 2;
  }
  std::vector<Id> table(capacity, NoId);
  std::vector<Id> vertex(points.size());
  Id numberOfVertices = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    progress.at(i, points.size());
    std::size_t slot = hashOf(points[i]) & (capacity - 1);
    while (table[slot] != NoId && points[table[slot]] != points[i])
    {
      slot = (slot + 1) & (capacity - 1);
    }
    if (table[slot] == NoId)
    {
      table[slot] = numberOfVertices;
      points[numberOfVertices++] = points[i];
    }
    vertex[i] = table[slot];
  }
  if (numberOfVertices < points.size())
  {
    points.resize(numberOfVertices);
    vertexOfPoint = std::move(vertex);
  }
}

/// Collects the triangles of cells, without those that have two corners at one vertex.
class Triangulator
{
public:
  Triangulator(vtkPoints* points, const PolyDataSurface& surface, std::vector<Triangle>& corners,
    std::vector<vtkIdType>& cells)
    : points_(points)
    , surface_(surface)
    , corners_(corners)
    , cells_(cells)
  {
  }

  vtkIdType facesWithRepeatedPoint() const { return this->facesWithRepeatedPoint_; }
  vtkIdType polygons() const { return this->polygons_; }

  void addPolygon(vtkIdType cell, vtkIdType size, const vtkIdType* ids)
  {
    this->check(cell, size, ids);
    if (size == 3)
    {
      this->addTriangle(cell, ids[0], ids[1], ids[2]);
      return;
    }
    ++this->polygons_;
    this->outline_.clear();
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (this->surface_.vertexOf(ids[i]) != this->surface_.vertexOf(ids[(i + 1) % size]))
      {
        this->outline_.push_back(ids[i]);
      }
    }
    if (this->outline_.size() < 3)
    {
      ++this->facesWithRepeatedPoint_;
      return;
    }
    this->cutEars(cell);
  }

  void addStrip(vtkIdType cell, vtkIdType size, const vtkIdType* ids)
  {
    this->check(cell, size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2;
      this->addTriangle(cell, ids[i + odd], ids[i + 1 - odd], ids[i + 2]);
    }
  }

private:
  void check(vtkIdType cell, vtkIdType size, const vtkIdType* ids) const
  {
    const vtkIdType count = this->points_->GetNumberOfPoints();
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= count)
      {
        throw MeshError("Cell " + std::to_string(cell) +
          " of the surface (input port 0) names point " + std::to_string(ids[i]) +
          ", but there are only " + std::to_string(count) + " points. Repair the cells upstream.");
      }
    }
  }

  void addTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const Id va = this->surface_.vertexOf(a);
    const Id vb = this->surface_.vertexOf(b);
    const Id vc = this->surface_.vertexOf(c);
    if (va == vb || vb == vc || vc == va)
    {
      ++this->facesWithRepeatedPoint_;
      return;
    }
    this->corners_.push_back({ static_cast<Id>(a), static_cast<Id>(b), static_cast<Id>(c) });
    this->cells_.push_back(cell);
  }

  void cutEars(vtkIdType cell)
  {
    const auto size = static_cast<vtkIdType>(this->outline_.size());
    this->polygon_->Initialize(static_cast<int>(size), this->outline_.data(), this->points_);
    this->polygon_->Triangulate(this->ears_);
    const vtkIdType corners = this->ears_->GetNumberOfIds();
    if (corners != 3 * (size - 2))
    {
      this->addFan(cell); // no area or an outline that crosses itself: any triangles conduct
      return;
    }
    for (vtkIdType i = 0; i < corners; i += 3)
    {
      this->addTriangle(cell, this->corner(i), this->corner(i + 1), this->corner(i + 2));
    }
  }

  vtkIdType corner(vtkIdType i) const
  {
    return this->outline_[static_cast<std::size_t>(this->ears_->GetId(i))];
  }

  void addFan(vtkIdType cell)
  {
    for (std::size_t i = 1; i + 1 < this->outline_.size(); ++i)
    {
      this->addTriangle(cell, this->outline_[0], this->outline_[i], this->outline_[i + 1]);
    }
  }

  vtkPoints* points_;
  const PolyDataSurface& surface_;
  std::vector<Triangle>& corners_;
  std::vector<vtkIdType>& cells_;
  vtkIdType facesWithRepeatedPoint_ = 0;
  vtkIdType polygons_ = 0;
  std::vector<vtkIdType> outline_;
  vtkNew<vtkPolygon> polygon_;
  vtkNew<vtkIdList> ears_;
};

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

PolyDataSurface::PolyDataSurface(
  vtkPolyData* input, bool mergeCoincidentPoints, const ProgressCallback& callback)
  : points_(input->GetPoints())
{
  if (input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    throw MeshError(
      "The surface (input port 0) has no faces. Connect a vtkPolyData with triangles or "
      "polygons, for example by the Extract Surface filter.");
  }
  LoopProgress progress(callback);
  progress.nextUntil(0.1);
  std::vector<Vec3> vertices = readPoints(this->points_, progress);
  progress.nextUntil(0.25);
  if (mergeCoincidentPoints)
  {
    mergeCoincident(vertices, this->vertexOfPoint_, progress);
  }

  std::vector<Triangle> triangles;
  progress.nextUntil(TrianglesRead);
  this->readTriangles(input, triangles, progress);
  if (triangles.empty())
  {
    throw MeshError("None of the " +
      std::to_string(input->GetNumberOfPolys() + input->GetNumberOfStrips()) +
      " faces of the surface (input port 0) has three different corners. Connect a surface with "
      "triangles or polygons.");
  }
  this->keepTriangles(input, triangles);
  this->diagonal_ = diagonalOf(vertices);

  if (!this->vertexOfPoint_.empty())
  {
    this->pointOfVertex_.resize(vertices.size());
    for (std::size_t i = this->vertexOfPoint_.size(); i-- > 0;)
    {
      this->pointOfVertex_[this->vertexOfPoint_[i]] = static_cast<vtkIdType>(i);
    }
    for (Triangle& triangle : triangles)
    {
      for (Id& corner : triangle)
      {
        corner = this->vertexOfPoint_[corner];
      }
    }
  }
  this->mesh_ = std::make_unique<TriangleMesh>(std::move(vertices), triangles,
    [&callback](double fraction)
    { return !callback || callback(TrianglesRead + (1.0 - TrianglesRead) * fraction); });
  this->locator_ = std::make_unique<PolylineLocator>(*this->mesh_);
}

void PolyDataSurface::readTriangles(
  vtkPolyData* input, std::vector<Triangle>& corners, const LoopProgress& progress)
{
  // vtkPolyData numbers its cells in the order vertices, lines, polygons, strips.
  this->report_.droppedVertexCells = input->GetNumberOfVerts();
  this->report_.droppedLineCells = input->GetNumberOfLines();
  this->report_.strips = input->GetNumberOfStrips();
  const vtkIdType first = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const auto count = static_cast<std::size_t>(input->GetNumberOfCells() - first);
  vtkIdType cell = first;
  const auto next = [&]()
  {
    progress.at(static_cast<std::size_t>(cell - first), count);
    return cell++;
  };

  corners.reserve(static_cast<std::size_t>(input->GetNumberOfPolys()));
  this->inputCells_.reserve(static_cast<std::size_t>(input->GetNumberOfPolys()));
  Triangulator triangulator(this->points_, *this, corners, this->inputCells_);
  forEachCell(input->GetPolys(),
    [&](vtkIdType size, const vtkIdType* ids) { triangulator.addPolygon(next(), size, ids); });
  forEachCell(input->GetStrips(),
    [&](vtkIdType size, const vtkIdType* ids) { triangulator.addStrip(next(), size, ids); });
  this->report_.facesWithRepeatedPoint = triangulator.facesWithRepeatedPoint();
  this->report_.polygons = triangulator.polygons();
}

void PolyDataSurface::keepTriangles(vtkPolyData* input, const std::vector<Triangle>& corners)
{
  const bool areInputCells = this->report_.polygons == 0 && this->report_.strips == 0 &&
    static_cast<vtkIdType>(corners.size()) == input->GetNumberOfCells();
  if (areInputCells)
  {
    this->triangles_ = input->GetPolys();
    this->inputCells_ = {};
    return;
  }
  constexpr vtkIdType idsATriangle = 4; // three points and an offset
  requireMemory(static_cast<vtkIdType>(corners.size()) + 1, idsATriangle * sizeof(vtkIdType));
  this->triangles_ = vtkSmartPointer<vtkCellArray>::New();
  this->triangles_->AllocateExact(
    static_cast<vtkIdType>(corners.size()), 3 * static_cast<vtkIdType>(corners.size()));
  for (const Triangle& triangle : corners)
  {
    this->triangles_->InsertNextCell({ static_cast<vtkIdType>(triangle[0]),
      static_cast<vtkIdType>(triangle[1]), static_cast<vtkIdType>(triangle[2]) });
  }
}

vtkIdType PolyDataSurface::numberOfPoints() const
{
  return this->points_->GetNumberOfPoints();
}

vtkIdType PolyDataSurface::numberOfTriangles() const
{
  return this->triangles_->GetNumberOfCells();
}

Triangle PolyDataSurface::triangle(Id triangle) const
{
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  this->triangles_->GetCellAtId(triangle, size, points);
  return { static_cast<Id>(points[0]), static_cast<Id>(points[1]), static_cast<Id>(points[2]) };
}

void PolyDataSurface::copyTo(
  vtkPolyData* input, vtkPolyData* output, const ProgressCallback& callback) const
{
  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->SetPolys(this->triangles_);
  if (this->inputCells_.empty())
  {
    output->GetCellData()->PassData(input->GetCellData());
    return;
  }
  vtkCellData* from = input->GetCellData();
  vtkCellData* to = output->GetCellData();
  const auto count = static_cast<vtkIdType>(this->inputCells_.size());
  requireMemory(count, bytesATuple(from));
  to->CopyGlobalIdsOff(); // the triangles of one polygon would share one
  to->CopyAllocate(from, count);
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    progress.at(static_cast<std::size_t>(i), this->inputCells_.size());
    to->CopyData(from, this->inputCells_[static_cast<std::size_t>(i)], i);
  }
}

}
