// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/LineWriter.h"

#include "PolyData/Inputs.h"
#include "PolyData/Memory.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

namespace geodesic
{

namespace
{

constexpr const char* ArrayName = "GeodesicDistance";

/// The points and cells of an output, which are added one by one.
struct LineCells
{
  explicit LineCells(const PowerOfTwoScale& ofMesh)
    : scale(ofMesh)
  {
    this->points->SetDataTypeToDouble();
  }

  vtkIdType addPoint(const Vec3& place)
  {
    return this->points->InsertNextPoint(this->scale.toUser(place).data());
  }

  /// Adds a curve as a polyline, or as a vertex where it is one point.
  void addCurve(const TriangleMesh& mesh, const SourceCurve& curve)
  {
    vtkCellArray* cells = curve.points.size() > 1 ? this->lines : this->vertices;
    const vtkIdType first = this->points->GetNumberOfPoints();
    cells->InsertNextCell(static_cast<int>(curve.points.size()));
    for (std::size_t i = 0; i < numberOfPlaces(curve); ++i)
    {
      cells->InsertCellPoint(this->addPoint(position(mesh, curve.points[i])));
    }
    if (curve.isClosed())
    {
      cells->InsertCellPoint(first);
    }
  }

  /// Without the last point of a closed curve, which is its first one again.
  static std::size_t numberOfPlaces(const SourceCurve& curve)
  {
    return curve.points.size() - (curve.isClosed() ? 1 : 0);
  }

  void write(vtkPolyData* output) const
  {
    output->SetPoints(this->points);
    output->SetVerts(this->vertices);
    output->SetLines(this->lines);
  }

  const PowerOfTwoScale& scale;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
};

/// Calls visit(curve) in the order of the cells: vertices come before lines.
template <typename Visit>
void forEachInOrderOfCells(const std::vector<SourceCurve>& curves, const Visit& visit)
{
  for (const bool arePoints : { true, false })
  {
    for (const SourceCurve& curve : curves)
    {
      if ((curve.points.size() == 1) == arePoints)
      {
        visit(curve);
      }
    }
  }
}

/// Asks for the memory of curves, and of other points: a point with a value, its id and its line's,
/// and an offset, twice while an array grows to twice its size.
void requireMemoryOf(const std::vector<SourceCurve>& curves, std::size_t otherPoints = 0)
{
  const std::size_t size = std::accumulate(curves.begin(), curves.end(), otherPoints,
    [](std::size_t sum, const SourceCurve& curve) { return sum + curve.points.size(); });
  requireMemory(static_cast<vtkIdType>(size), 4 * (4 * sizeof(double) + 3 * sizeof(vtkIdType)));
}

/// Adds a cell array with one value a path.
template <typename Array, typename ValueOf>
void addArray(const char* name, const std::vector<PathOfTarget>& paths, vtkPolyData* output,
  const ValueOf& valueOf)
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
  const std::vector<PathOfTarget>& paths, vtkIdType size, vtkPolyData* output, const Job& job)
{
  LineCells cells(scale);
  cells.points->Allocate(size);
  cells.lines->AllocateExact(static_cast<vtkIdType>(paths.size()), size);
  const auto left = makeArray<vtkDoubleArray>(ArrayName, size);
  auto lengths = makeArray<vtkDoubleArray>(ArrayName, static_cast<vtkIdType>(paths.size()));
  for (std::size_t path = 0; path < paths.size(); ++path)
  {
    const std::vector<Vec3>& places = paths[path].points;
    const vtkIdType first = cells.points->GetNumberOfPoints();
    cells.lines->InsertNextCell(static_cast<int>(places.size()));
    for (const Vec3& place : places)
    {
      cells.lines->InsertCellPoint(cells.addPoint(place));
    }
    double length = 0.0;
    for (std::size_t i = places.size(); i-- > 0;)
    {
      const vtkIdType point = first + static_cast<vtkIdType>(i);
      job.reachItem(static_cast<std::size_t>(point), static_cast<std::size_t>(size));
      length += i + 1 < places.size() ? norm(places[i + 1] - places[i]) : 0.0;
      left->SetValue(point, scale.distanceToUser(length));
    }
    lengths->SetValue(static_cast<vtkIdType>(path), scale.distanceToUser(length));
  }
  cells.write(output);
  output->GetPointData()->SetScalars(left);
  return lengths;
}

/// The last point of a path has the cell of the last piece.
void writeCells(const std::vector<PathOfTarget>& paths, vtkIdType size, vtkPolyData* output)
{
  const auto cells = makeArray<vtkIdTypeArray>("FaceId", size);
  vtkIdType* next = size > 0 ? cells->GetPointer(0) : nullptr;
  for (const PathOfTarget& path : paths)
  {
    next = std::copy(path.cells.begin(), path.cells.end(), next);
    *next++ = path.cells.back();
  }
  output->GetPointData()->AddArray(cells);
}

}

void writeCurves(const TriangleMesh& mesh, const PowerOfTwoScale& scale, const Sources& sources,
  const std::vector<std::vector<double>>& arcLengths, vtkPolyData* output)
{
  const std::vector<SourceCurve>& curves = sources.curves;
  requireMemoryOf(curves);
  LineCells cells(scale);
  const auto lengths = makeArray<vtkDoubleArray>("SourceArcLength", 0);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    cells.addCurve(mesh, curves[c]);
    for (std::size_t i = 0; !arcLengths.empty() && i < LineCells::numberOfPlaces(curves[c]); ++i)
    {
      lengths->InsertNextValue(arcLengths[c][i]);
    }
  }
  cells.write(output);
  if (!arcLengths.empty())
  {
    output->GetPointData()->AddArray(lengths);
  }
  const auto ids = makeArray<vtkIdTypeArray>("SourceId", 0);
  forEachInOrderOfCells(
    curves, [&](const SourceCurve& curve) { ids->InsertNextValue(sources.ids[curve.source]); });
  output->GetCellData()->AddArray(ids);
}

void writeIsolines(
  const WrittenIsolines& written, const PowerOfTwoScale& scale, vtkPolyData* output, const Job& job)
{
  const Isolines& isolines = written.isolines;
  requireMemoryOf(written.curves, isolines.points.size());
  LineCells cells(scale);
  const auto lineIds = makeArray<vtkIdTypeArray>("LineId", 0);
  vtkIdType line = 0;
  const auto numberPoints = [&]
  {
    while (lineIds->GetNumberOfTuples() < cells.points->GetNumberOfPoints())
    {
      lineIds->InsertNextValue(line);
    }
    ++line;
  };
  forEachInOrderOfCells(written.curves,
    [&](const SourceCurve& curve)
    {
      cells.addCurve(written.meshOfCurves, curve);
      numberPoints();
    });
  const auto atPoints = makeArray<vtkDoubleArray>(ArrayName, cells.points->GetNumberOfPoints());
  const auto atCells =
    makeArray<vtkDoubleArray>(ArrayName, static_cast<vtkIdType>(written.curves.size()));
  atPoints->Fill(0.0);
  atCells->Fill(0.0);
  std::vector<vtkIdType> numbers(isolines.points.size(), -1);
  for (std::size_t i = 0; i < isolines.lines.size(); ++i)
  {
    job.reachItem(i, isolines.lines.size());
    const Isoline& isoline = isolines.lines[i];
    const double value = written.values[isoline.value];
    cells.lines->InsertNextCell(static_cast<int>(isoline.points.size()));
    atCells->InsertNextValue(value);
    for (const Id point : isoline.points)
    {
      if (numbers[point] < 0)
      {
        numbers[point] = cells.addPoint(position(written.mesh, isolines.points[point]));
        atPoints->InsertNextValue(value);
      }
      cells.lines->InsertCellPoint(numbers[point]);
    }
    numberPoints();
  }
  cells.write(output);
  output->GetPointData()->SetScalars(atPoints);
  output->GetPointData()->AddArray(lineIds);
  output->GetCellData()->SetScalars(atCells);
}

void writePaths(const PowerOfTwoScale& scale, const std::vector<PathOfTarget>& paths,
  const PathArrayChoice& choice, vtkPolyData* output, const Job& job)
{
  vtkIdType size = 0;
  for (const PathOfTarget& path : paths)
  {
    size += static_cast<vtkIdType>(path.points.size());
  }
  // A point, what is left, its id and its cell; a path's offset and six arrays.
  requireMemory(size, 4 * sizeof(double) + 2 * sizeof(vtkIdType));
  requireMemory(static_cast<vtkIdType>(paths.size()), 4 * sizeof(double) + 3 * sizeof(vtkIdType));
  const auto lengths = writeLines(scale, paths, size, output, job);
  if (choice.cells)
  {
    writeCells(paths, size, output);
  }
  addArray<vtkIdTypeArray>("TargetId", paths, output,
    [](const PathOfTarget& path) { return static_cast<vtkIdType>(path.target); });
  addArray<vtkIdTypeArray>(
    "SourceId", paths, output, [](const PathOfTarget& path) { return path.sourceId; });
  output->GetCellData()->AddArray(lengths);
  addArray<vtkDoubleArray>("TargetSnapDistance", paths, output,
    [&scale](const PathOfTarget& path) { return scale.toUser(path.snapDistance); });
  if (choice.arcLengths)
  {
    addArray<vtkDoubleArray>("SourceArcLength", paths, output,
      [&scale](const PathOfTarget& path) { return scale.toUser(path.end.arcLength); });
  }
  if (choice.angles)
  {
    addArray<vtkDoubleArray>(
      "SourceAngle", paths, output, [](const PathOfTarget& path) { return path.end.angle; });
  }
}

}
