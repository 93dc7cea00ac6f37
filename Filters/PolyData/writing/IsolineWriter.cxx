// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/IsolineWriter.h"

#include "PolyData/Memory.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace geodesic
{

namespace
{

constexpr const char* ArrayName = "GeodesicDistance";

class Writer
{
public:
  explicit Writer(const PowerOfTwoScale& scale)
    : scale_(scale)
  {
    this->points_->SetDataTypeToDouble();
    this->atPoints_->SetName(ArrayName);
    this->atCells_->SetName(ArrayName);
  }

  vtkIdType addPoint(const TriangleMesh& mesh, const SurfacePoint& point, double value)
  {
    this->atPoints_->InsertNextValue(value);
    return this->points_->InsertNextPoint(this->scale_.toUser(position(mesh, point)).data());
  }

  /// Of the source, the points or the polylines. Vertices come before lines in the order of the
  /// cells.
  void addCurves(const WrittenCurves& sources, bool arePoints)
  {
    for (const SourceCurve& curve : sources.curves)
    {
      const std::size_t size = curve.points.size();
      if ((size == 1) == arePoints)
      {
        vtkCellArray* cells = arePoints ? this->vertices_ : this->lines_;
        this->beginCell(cells, size, 0.0);
        const vtkIdType first = this->points_->GetNumberOfPoints();
        for (std::size_t i = 0; i < size; ++i)
        {
          const bool isFirstAgain = i > 0 && i + 1 == size && curve.isClosed();
          cells->InsertCellPoint(
            isFirstAgain ? first : this->addPoint(sources.mesh, curve.points[i], 0.0));
        }
      }
    }
  }

  void addIsolines(const WrittenIsolines& written, const LoopProgress& progress)
  {
    const Isolines& isolines = written.isolines;
    std::vector<vtkIdType> numbers(isolines.points.size(), -1);
    for (std::size_t i = 0; i < isolines.lines.size(); ++i)
    {
      progress.at(i, isolines.lines.size());
      const Isoline& line = isolines.lines[i];
      this->beginCell(this->lines_, line.points.size(), written.values[line.value]);
      for (const Id point : line.points)
      {
        if (numbers[point] < 0)
        {
          numbers[point] =
            this->addPoint(written.mesh, isolines.points[point], written.values[line.value]);
        }
        this->lines_->InsertCellPoint(numbers[point]);
      }
    }
  }

  void finish(vtkPolyData* output)
  {
    output->SetPoints(this->points_);
    output->SetVerts(this->vertices_);
    output->SetLines(this->lines_);
    output->GetPointData()->SetScalars(this->atPoints_);
    output->GetCellData()->SetScalars(this->atCells_);
  }

private:
  void beginCell(vtkCellArray* cells, std::size_t points, double value)
  {
    cells->InsertNextCell(static_cast<int>(points));
    this->atCells_->InsertNextValue(value);
  }

  const PowerOfTwoScale& scale_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> vertices_;
  vtkNew<vtkCellArray> lines_;
  vtkNew<vtkDoubleArray> atPoints_;
  vtkNew<vtkDoubleArray> atCells_;
};

}

void writeIsolines(const WrittenIsolines& lines, const WrittenCurves& atZero,
  const PowerOfTwoScale& scale, vtkPolyData* output, const ProgressCallback& callback)
{
  std::size_t size = lines.isolines.points.size();
  for (const SourceCurve& curve : atZero.curves)
  {
    size += curve.points.size();
  }
  // A point with its value, its id and an offset, twice while an array grows to twice its size.
  requireMemory(static_cast<vtkIdType>(size), 4 * (4 * sizeof(double) + 2 * sizeof(vtkIdType)));
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  Writer writer(scale);
  writer.addCurves(atZero, true);
  writer.addCurves(atZero, false);
  writer.addIsolines(lines, progress);
  writer.finish(output);
}

void addEmptyIsolineArrays(vtkPolyData* output)
{
  Writer(PowerOfTwoScale()).finish(output);
}

}
