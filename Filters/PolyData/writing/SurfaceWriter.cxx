// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/SurfaceWriter.h"

#include "PolyData/Memory.h"
#include "PolyData/ParallelFor.h"
#include "PolyData/writing/PointDataInterpolation.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geodesic
{

namespace
{

void writePoints(
  const RefinedMesh& refined, vtkPoints* from, vtkPolyData* output, const LoopProgress& progress)
{
  if (!from)
  {
    return; // an empty block
  }
  const auto old = static_cast<vtkIdType>(refined.numberOfInputPoints);
  const int type = from->GetDataType();
  vtkNew<vtkPoints> points;
  // Integers could not hold the new points.
  points->SetDataType(type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  requireMemory(old + static_cast<vtkIdType>(refined.points.size()), 3 * sizeof(double));
  points->SetNumberOfPoints(old + static_cast<vtkIdType>(refined.points.size()));
  points->GetData()->InsertTuples(0, old, 0, from->GetData());
  for (std::size_t i = 0; i < refined.points.size(); ++i)
  {
    progress.at(i, refined.points.size());
    points->SetPoint(old + static_cast<vtkIdType>(i), refined.points[i].position.data());
  }
  output->SetPoints(points);
}

/// The array of some cell data with the same name and type as one of the output, which tasks may
/// copy from side by side; null where there is none such.
vtkDataArray* numbersLike(vtkAbstractArray* array, vtkCellData* data)
{
  vtkAbstractArray* found = array->GetName() ? data->GetAbstractArray(array->GetName()) : nullptr;
  const bool isAlike = found && found->GetDataType() == array->GetDataType() &&
    found->GetNumberOfComponents() == array->GetNumberOfComponents() &&
    found->GetDataType() != VTK_BIT; // several share a byte
  return isAlike && vtkDataArray::SafeDownCast(array) ? vtkDataArray::SafeDownCast(found) : nullptr;
}

/// Gives each triangle the data of the cell that it is a part of.
///
/// \param cellOf (vtkIdType triangle) -> vtkIdType
template <typename CellOf>
void copyCellData(vtkCellData* from, vtkIdType count, const CellOf& cellOf, vtkCellData* to,
  const ParallelFor& parallelFor, const LoopProgress& progress)
{
  to->CopyGlobalIdsOff(); // the parts of one cell would share one
  to->CopyAllocate(from, count);
  std::vector<std::pair<vtkDataArray*, vtkDataArray*>> numbers;
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = to->GetAbstractArray(i);
    numbers.emplace_back(numbersLike(array, from), vtkDataArray::SafeDownCast(array));
  }
  const bool areAllNumbers = std::all_of(
    numbers.begin(), numbers.end(), [](const auto& arrays) { return arrays.first != nullptr; });
  for (const auto& [source, target] : numbers)
  {
    if (areAllNumbers)
    {
      target->SetNumberOfTuples(count);
    }
  }
  if (numbers.empty())
  {
    return;
  }
  const auto copy = [&](std::size_t begin, std::size_t end)
  {
    for (auto i = static_cast<vtkIdType>(begin); i < static_cast<vtkIdType>(end); ++i)
    {
      const vtkIdType cell = cellOf(i);
      if (!areAllNumbers)
      {
        to->CopyData(from, cell, i);
        continue;
      }
      for (const auto& [source, target] : numbers)
      {
        target->SetTuple(i, cell, source);
      }
    }
  };
  const ParallelFor one;
  forRanges(areAllNumbers ? parallelFor : one, static_cast<std::size_t>(count), progress, copy);
}

void writeCells(const SurfaceBlock& block, const RefinedMesh& refined, vtkCellData* from,
  vtkPolyData* output, const LoopProgress& progress)
{
  const ParallelFor parallelFor = smpParallelFor();
  const auto count = static_cast<vtkIdType>(refined.triangles.size());
  constexpr vtkIdType idsATriangle = 5; // three points, an offset and the original cell
  requireMemory(count + 1, idsATriangle * sizeof(vtkIdType) + bytesATuple(from));
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfValues(3 * count);
  vtkNew<vtkIdTypeArray> originals;
  originals->SetName("OriginalCellIds");
  originals->SetNumberOfValues(count);
  offsets->SetValue(count, 3 * count);
  forRanges(parallelFor, refined.triangles.size(),
    progress.between(0.0, from->GetNumberOfArrays() > 0 ? 0.5 : 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto cell = static_cast<vtkIdType>(i);
        offsets->SetValue(cell, 3 * cell);
        for (std::size_t k = 0; k < 3; ++k)
        {
          points->SetValue(3 * cell + static_cast<vtkIdType>(k), refined.triangles[i][k]);
        }
        originals->SetValue(cell, block.inputCell(refined.faces[i]));
      }
    });
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, points);
  copyCellData(
    from, count, [&originals](vtkIdType i) { return originals->GetValue(i); },
    output->GetCellData(), parallelFor, progress.between(0.5, 1.0));
  output->SetPolys(triangles);
  output->GetCellData()->AddArray(originals);
}

}

void writeWhole(const SurfaceBlock& block, vtkPolyData* input, vtkPolyData* output,
  const ProgressCallback& callback)
{
  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->SetPolys(block.triangles);
  if (block.areInputCells)
  {
    output->GetCellData()->PassData(input->GetCellData());
    return;
  }
  vtkCellData* from = input->GetCellData();
  const vtkIdType count = block.numberOfTriangles();
  requireMemory(count, bytesATuple(from));
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  copyCellData(
    from, count, [&block](vtkIdType i) { return block.inputCell(i); }, output->GetCellData(),
    smpParallelFor(), progress);
}

void writeRefined(const SurfaceBlock& block, const RefinedMesh& refined, vtkPolyData* input,
  vtkPolyData* output, const ProgressCallback& callback)
{
  constexpr double pointsDone = 0.1;
  constexpr double pointDataDone = 0.5;
  LoopProgress progress(callback);
  progress.nextUntil(pointsDone);
  writePoints(refined, input->GetPoints(), output, progress);
  interpolatePointData(
    refined, input->GetPointData(), output->GetPointData(), pointDataDone, progress);
  progress.nextUntil(1.0);
  writeCells(block, refined, input->GetCellData(), output, progress);
}

}
