// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/PolyDataSource.h"

#include "PolyData/ArrayMemory.h"
#include "Errors.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <string>

namespace geodesic
{

namespace
{

/// The points of one curve of the source.
struct Chain
{
  std::vector<vtkIdType> points;
  bool closed = false;
  std::string name;
};

/// Takes the curves out of the cells.
class ChainReader
{
public:
  explicit ChainReader(vtkPolyData* source)
    : numberOfPoints_(source->GetNumberOfPoints())
  {
    this->read(source->GetVerts(), &ChainReader::addVertices);
    this->read(source->GetLines(), &ChainReader::addLine);
    this->read(source->GetPolys(), &ChainReader::addPolygon);
    this->read(source->GetStrips(), &ChainReader::addStrip);
    if (source->GetNumberOfCells() == 0)
    {
      for (vtkIdType i = 0; i < this->numberOfPoints_; ++i)
      {
        this->addPoint(i);
      }
    }
  }

  std::vector<Chain>&& take() { return std::move(this->chains_); }

private:
  using Adder = void (ChainReader::*)(vtkIdType, const vtkIdType*);

  void read(vtkCellArray* cells, Adder add)
  {
    const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(size, ids);
      this->check(size, ids);
      if (size > 0)
      {
        (this->*add)(size, ids);
      }
      ++this->cell_;
    }
  }

  void check(vtkIdType size, const vtkIdType* ids) const
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= this->numberOfPoints_)
      {
        throw SourceError("Cell " + std::to_string(this->cell_) +
          " of the source (input port 1) names point " + std::to_string(ids[i]) +
          ", but there are only " + std::to_string(this->numberOfPoints_) +
          " points. Repair the cells upstream.");
      }
    }
  }

  void addPoint(vtkIdType point)
  {
    this->chains_.push_back(
      { { point }, false, "point " + std::to_string(point) + " of the source" });
  }

  void addVertices(vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->addPoint(ids[i]);
    }
  }

  void addChain(std::vector<vtkIdType> points, bool closed)
  {
    const bool isClosed = closed && points.size() > 2;
    this->chains_.push_back(
      { std::move(points), isClosed, "cell " + std::to_string(this->cell_) + " of the source" });
  }

  void addLine(vtkIdType size, const vtkIdType* ids)
  {
    const bool closed = size > 3 && ids[0] == ids[size - 1];
    this->addChain({ ids, ids + (closed ? size - 1 : size) }, closed);
  }

  void addPolygon(vtkIdType size, const vtkIdType* ids)
  {
    this->addChain({ ids, ids + size }, true);
  }

  /// The outline runs along the even points and back along the odd ones.
  void addStrip(vtkIdType size, const vtkIdType* ids)
  {
    std::vector<vtkIdType> outline;
    for (vtkIdType i = 0; i < size; i += 2)
    {
      outline.push_back(ids[i]);
    }
    for (vtkIdType i = size - 1 - size % 2; i > 0; i -= 2)
    {
      outline.push_back(ids[i]);
    }
    this->addChain(std::move(outline), true);
  }

  vtkIdType numberOfPoints_;
  vtkIdType cell_ = 0;
  std::vector<Chain> chains_;
};

std::vector<char> usedPoints(const std::vector<Chain>& chains, vtkIdType numberOfPoints)
{
  std::vector<char> used(static_cast<std::size_t>(numberOfPoints), 0);
  for (const Chain& chain : chains)
  {
    for (const vtkIdType point : chain.points)
    {
      used[static_cast<std::size_t>(point)] = 1;
    }
  }
  return used;
}

/// \throws SourceError
void requireFinite(vtkPoints* points, const std::vector<char>& used)
{
  std::vector<vtkIdType> bad;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    const double* p = points->GetPoint(static_cast<vtkIdType>(i));
    if (used[i] && !(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
    {
      bad.push_back(static_cast<vtkIdType>(i));
    }
  }
  if (!bad.empty())
  {
    throw SourceError(
      "The source (input port 1) has coordinates that are NaN or infinite, at point " +
      listIds(bad) + ". Remove or repair these points upstream.");
  }
}

}

std::vector<LocatedPolyline> readSource(
  vtkPolyData* source, PolyDataSurface& surface, const ProgressCallback& progress)
{
  std::vector<Chain> chains = ChainReader(source).take();
  if (chains.empty())
  {
    throw SourceError("The source (input port 1) is empty: it has no points that a line or vertex "
                      "uses. Connect a curve with at least one point, or choose the surface's "
                      "boundary as the source.");
  }
  vtkPoints* points = source->GetPoints();
  const std::vector<char> used = usedPoints(chains, source->GetNumberOfPoints());
  requireFinite(points, used);

  std::vector<LocatedPolyline> result;
  result.reserve(chains.size());
  for (Chain& chain : chains)
  {
    LocatedPolyline line;
    line.closed = chain.closed;
    line.name = std::move(chain.name);
    for (const vtkIdType point : chain.points)
    {
      Vec3 p;
      points->GetPoint(point, p.data());
      line.points.push_back(p);
    }
    result.push_back(std::move(line));
  }
  surface.locator().locate(result, snapOptionsFor(source).coordinatePrecision, progress);
  return result;
}

SnapOptions snapOptionsFor(vtkPolyData* source)
{
  SnapOptions options;
  if (source->GetPoints()->GetDataType() == VTK_FLOAT)
  {
    options.coordinatePrecision = FLT_EPSILON;
  }
  return options;
}

void writeCurves(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& curves, vtkPolyData* output)
{
  vtkIdType size = 0;
  for (const SourceCurve& curve : curves)
  {
    size += static_cast<vtkIdType>(curve.points.size());
  }
  // A point, its id and an offset, twice while an array grows to twice its size.
  requireMemory(size, 4 * (3 * sizeof(double) + 2 * sizeof(vtkIdType)));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  for (const SourceCurve& curve : curves)
  {
    const bool closed = curve.isClosed();
    const auto count = static_cast<vtkIdType>(curve.points.size());
    const vtkIdType first = points->GetNumberOfPoints();
    vtkCellArray* cells = count > 1 ? lines : vertices;
    cells->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const bool isFirstAgain = closed && i > 0 && i + 1 == count;
      cells->InsertCellPoint(isFirstAgain
          ? first
          : points->InsertNextPoint(
              position(mesh, curve.points[static_cast<std::size_t>(i)]).data()));
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->SetLines(lines);
}

}
