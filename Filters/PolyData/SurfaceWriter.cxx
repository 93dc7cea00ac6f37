// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/SurfaceWriter.h"

#include "PolyData/Memory.h"
#include "PolyData/PointDataInterpolation.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

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

void writeCells(const SurfaceBlock& block, const RefinedMesh& refined, vtkCellData* from,
  vtkPolyData* output, const LoopProgress& progress)
{
  const auto count = static_cast<vtkIdType>(refined.triangles.size());
  constexpr vtkIdType idsATriangle = 5; // three points, an offset and the original cell
  requireMemory(count + 1, idsATriangle * sizeof(vtkIdType) + bytesATuple(from));
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(count, 3 * count);
  vtkNew<vtkIdTypeArray> originals;
  originals->SetName("OriginalCellIds");
  originals->SetNumberOfTuples(count);
  vtkCellData* to = output->GetCellData();
  to->CopyGlobalIdsOff();
  to->CopyAllocate(from, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    progress.at(static_cast<std::size_t>(i), refined.triangles.size());
    const Triangle& triangle = refined.triangles[static_cast<std::size_t>(i)];
    const vtkIdType cell = block.inputCell(refined.faces[static_cast<std::size_t>(i)]);
    triangles->InsertNextCell({ static_cast<vtkIdType>(triangle[0]),
      static_cast<vtkIdType>(triangle[1]), static_cast<vtkIdType>(triangle[2]) });
    originals->SetValue(i, cell);
    to->CopyData(from, cell, i);
  }
  output->SetPolys(triangles);
  to->AddArray(originals);
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
  vtkCellData* to = output->GetCellData();
  const vtkIdType count = block.numberOfTriangles();
  requireMemory(count, bytesATuple(from));
  to->CopyGlobalIdsOff(); // the triangles of one polygon would share one
  to->CopyAllocate(from, count);
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    progress.at(static_cast<std::size_t>(i), static_cast<std::size_t>(count));
    to->CopyData(from, block.inputCell(i), i);
  }
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
