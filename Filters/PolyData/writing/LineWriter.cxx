// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/LineWriter.h"

#include "PolyData/Memory.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace geodesic
{

namespace
{

constexpr const char* ArrayName = "GeodesicDistance";

/// The outputs of writeIsolines().
class IsolineWriter
{
public:
  explicit IsolineWriter(const PowerOfTwoScale& scale)
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

constexpr const char* TooLong =
  "Paths on the surface (input port 0) are longer than numbers can be. Scale the surface, the "
  "source and the targets upstream.";

template <typename Array>
vtkNew<Array> makeArray(const char* name, vtkIdType tuples)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// Adds a cell array with one value a path.
template <typename Array, typename ValueOf>
void addArray(const char* name, const std::vector<PathOfTarget>& paths, const ValueOf& valueOf,
  vtkPolyData* output)
{
  const auto array = makeArray<Array>(name, static_cast<vtkIdType>(paths.size()));
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), valueOf(paths[i]));
  }
  output->GetCellData()->AddArray(array);
}

/// Fills the points and lines of the output, and what is left of a path at its points.
///
/// \returns the lengths of the paths, as an array.
vtkNew<vtkDoubleArray> writeLines(const PowerOfTwoScale& scale,
  const std::vector<PathOfTarget>& paths, vtkIdType size, vtkPolyData* output,
  const LoopProgress& progress)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(size);
  const auto left = makeArray<vtkDoubleArray>(ArrayName, size);
  auto lengths = makeArray<vtkDoubleArray>(ArrayName, static_cast<vtkIdType>(paths.size()));
  vtkNew<vtkCellArray> lines;
  lines->AllocateExact(static_cast<vtkIdType>(paths.size()), size);
  vtkIdType point = 0;
  for (std::size_t path = 0; path < paths.size(); ++path)
  {
    const std::vector<Vec3>& places = paths[path].points;
    lines->InsertNextCell(static_cast<int>(places.size()));
    for (const Vec3& place : places)
    {
      points->SetPoint(point, scale.toUser(place).data());
      lines->InsertCellPoint(point++);
    }
    double length = 0.0;
    for (std::size_t i = places.size(); i-- > 0;)
    {
      progress.at(static_cast<std::size_t>(point) - i - 1, static_cast<std::size_t>(size));
      length += i + 1 < places.size() ? norm(places[i + 1] - places[i]) : 0.0;
      left->SetValue(
        point - static_cast<vtkIdType>(places.size() - i), scale.resultToUser(length, TooLong));
    }
    lengths->SetValue(static_cast<vtkIdType>(path), scale.resultToUser(length, TooLong));
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->SetScalars(left);
  return lengths;
}

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
  IsolineWriter writer(scale);
  writer.addCurves(atZero, true);
  writer.addCurves(atZero, false);
  writer.addIsolines(lines, progress);
  writer.finish(output);
}

void addEmptyIsolineArrays(vtkPolyData* output)
{
  IsolineWriter(PowerOfTwoScale()).finish(output);
}

void writePaths(const PowerOfTwoScale& scale, const std::vector<PathOfTarget>& paths,
  const PathEndChoice& choice, vtkPolyData* output, const ProgressCallback& callback)
{
  vtkIdType size = 0;
  for (const PathOfTarget& path : paths)
  {
    size += static_cast<vtkIdType>(path.points.size());
  }
  // A point, what is left and its id; a path's offset and six arrays.
  requireMemory(size, 4 * sizeof(double) + sizeof(vtkIdType));
  requireMemory(static_cast<vtkIdType>(paths.size()), 4 * sizeof(double) + 3 * sizeof(vtkIdType));
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  const auto lengths = writeLines(scale, paths, size, output, progress);
  addArray<vtkIdTypeArray>(
    "TargetId", paths, [](const PathOfTarget& path) { return static_cast<vtkIdType>(path.target); },
    output);
  addArray<vtkIdTypeArray>(
    "SourceId", paths,
    [](const PathOfTarget& path)
    { return path.end.source == NoId ? vtkIdType(-1) : static_cast<vtkIdType>(path.end.source); },
    output);
  output->GetCellData()->AddArray(lengths);
  addArray<vtkDoubleArray>(
    "TargetSnapDistance", paths,
    [&scale](const PathOfTarget& path) { return scale.toUser(path.snapDistance); }, output);
  if (choice.arcLengths)
  {
    addArray<vtkDoubleArray>(
      "SourceArcLength", paths,
      [&scale](const PathOfTarget& path) { return scale.toUser(path.end.arcLength); }, output);
  }
  if (choice.angles)
  {
    addArray<vtkDoubleArray>(
      "SourceAngle", paths, [](const PathOfTarget& path) { return path.end.angle; }, output);
  }
}

}
