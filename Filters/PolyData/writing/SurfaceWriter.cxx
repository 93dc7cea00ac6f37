// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/SurfaceWriter.h"

#include "PolyData/Memory.h"
#include "PolyData/PolyDataBlocks.h"
#include "PolyData/writing/OutputPoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

namespace geodesic
{

namespace
{

/// How a new point lies among the corners of the face around it.
struct Blend
{
  std::array<Id, 3> corners{};
  std::array<double, 3> weights{};
  std::size_t count = 0;

  void add(Id corner, double weight)
  {
    const auto end = this->corners.begin() + static_cast<std::ptrdiff_t>(this->count);
    const auto k = static_cast<std::size_t>(
      std::find(this->corners.begin(), end, corner) - this->corners.begin());
    if (k == this->count)
    {
      this->corners[this->count++] = corner;
    }
    this->weights[k] += weight;
  }

  vtkIdType nearest() const
  {
    const auto end = this->weights.begin() + static_cast<std::ptrdiff_t>(this->count);
    const auto k = std::max_element(this->weights.begin(), end) - this->weights.begin();
    return this->corners[static_cast<std::size_t>(k)];
  }
};

std::vector<Blend> blendsOf(const RefinedMesh& refined)
{
  std::vector<Blend> blends(refined.points.size());
  for (std::size_t i = 0; i < blends.size(); ++i)
  {
    const RefinedPoint& point = refined.points[i];
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double weight = k == 0 ? 1.0 - point.weight : point.weight;
      const Id parent = point.parents[k];
      if (parent < refined.numberOfInputPoints)
      {
        blends[i].add(parent, weight);
        continue;
      }
      const Blend& other = blends[parent - refined.numberOfInputPoints];
      for (std::size_t j = 0; j < other.count; ++j)
      {
        blends[i].add(other.corners[j], weight * other.weights[j]);
      }
    }
  }
  return blends;
}

void interpolate(vtkAbstractArray* array, const Blend& blend, vtkIdType point, vtkIdList* corners)
{
  corners->SetNumberOfIds(static_cast<vtkIdType>(blend.count));
  for (std::size_t k = 0; k < blend.count; ++k)
  {
    corners->SetId(static_cast<vtkIdType>(k), blend.corners[k]);
  }
  std::array<double, 3> weights = blend.weights;
  array->InterpolateTuple(point, corners, array, weights.data());
}

unsigned char commonFlags(vtkUnsignedCharArray* ghosts, const Blend& blend)
{
  unsigned char flags = 0xff;
  for (std::size_t k = 0; k < blend.count; ++k)
  {
    flags = static_cast<unsigned char>(flags & ghosts->GetValue(blend.corners[k]));
  }
  return flags;
}

bool isLabel(vtkPointData* data, int index)
{
  vtkAbstractArray* array = data->GetAbstractArray(index);
  const int type = array->GetDataType();
  return !vtkDataArray::SafeDownCast(array) || type == VTK_ID_TYPE || type == VTK_BIT ||
    data->IsArrayAnAttribute(index) == vtkDataSetAttributes::PEDIGREEIDS;
}

/// So many are fast, and the watcher hears of each part. For 10,000 and more VTK starts threads; if
/// there is too little memory for them, the process ends.
constexpr vtkIdType TuplesAtOnce = 8192;

vtkUnsignedCharArray* asGhosts(vtkAbstractArray* array)
{
  const char* name = array->GetName();
  return name && std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0
    ? vtkUnsignedCharArray::SafeDownCast(array)
    : nullptr;
}

/// Copies the data of a mesh's input points and gives its new points interpolated data: numbers
/// linearly in the face, strings, ids and bits those of the nearest corner. A new point is a ghost
/// in the ways that all corners around it are. Global ids are dropped.
void interpolatePointData(
  const RefinedMesh& refined, vtkPointData* from, vtkPointData* to, const Job& job)
{
  const auto old = static_cast<vtkIdType>(refined.numberOfInputPoints);
  const vtkIdType count = old + static_cast<vtkIdType>(refined.points.size());
  requireMemory(count, bytesATuple(from));
  to->CopyAllocate(from, count); // this leaves global ids out
  if (to->GetNumberOfArrays() == 0)
  {
    return;
  }
  to->SetNumberOfTuples(count);
  for (vtkIdType first = 0; first < old; first += TuplesAtOnce)
  {
    to->CopyData(from, first, std::min(TuplesAtOnce, old - first), first);
  }
  const std::vector<Blend> blends = blendsOf(refined);
  vtkNew<vtkIdList> corners;
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    const double arrays = to->GetNumberOfArrays();
    const Job ofArray = job.part(i / arrays, (i + 1) / arrays);
    vtkAbstractArray* array = to->GetAbstractArray(i);
    vtkUnsignedCharArray* ghosts = asGhosts(array);
    const bool isLabelArray = isLabel(to, i);
    for (std::size_t j = 0; j < blends.size(); ++j)
    {
      ofArray.reachItem(j, blends.size());
      const vtkIdType point = old + static_cast<vtkIdType>(j);
      if (ghosts)
      {
        ghosts->SetValue(point, commonFlags(ghosts, blends[j]));
      }
      else if (isLabelArray)
      {
        array->SetTuple(point, blends[j].nearest(), array);
      }
      else
      {
        interpolate(array, blends[j], point, corners);
      }
    }
  }
}

/// Gives each new point or cell the data of an old one.
///
/// \param oldOf (vtkIdType) -> vtkIdType
template <typename OldOf>
void copyData(vtkDataSetAttributes* from, vtkIdType count, const OldOf& oldOf,
  vtkDataSetAttributes* to, const Job& job = {})
{
  to->CopyAllocate(from, count);
  if (to->GetNumberOfArrays() == 0)
  {
    return;
  }
  vtkNew<vtkIdList> olds;
  vtkNew<vtkIdList> news;
  for (vtkIdType first = 0; first < count; first += TuplesAtOnce)
  {
    job.reachItem(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    const vtkIdType size = std::min(TuplesAtOnce, count - first);
    olds->SetNumberOfIds(size);
    news->SetNumberOfIds(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      olds->SetId(i, oldOf(first + i));
      news->SetId(i, first + i);
    }
    to->CopyData(from, olds, news);
  }
}

void writeCells(const SurfaceBlock& block, const RefinedMesh& refined, vtkCellData* from,
  vtkPolyData* output, const Job& job)
{
  const auto count = static_cast<vtkIdType>(refined.triangles.size());
  // Three points, an offset and the original cell.
  constexpr auto ofIds = static_cast<vtkIdType>(5 * sizeof(vtkIdType));
  requireMemory(count + 1, ofIds + bytesATuple(from));
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfValues(3 * count);
  offsets->SetValue(count, 3 * count);
  const auto originals = makeArray<vtkIdTypeArray>("OriginalCellIds", count);
  const double idsWritten = from->GetNumberOfArrays() > 0 ? 0.5 : 1.0;
  job.part(0.0, idsWritten)
    .loop(refined.triangles.size(),
      [&](std::size_t i)
      {
        const auto cell = static_cast<vtkIdType>(i);
        offsets->SetValue(cell, 3 * cell);
        for (std::size_t k = 0; k < 3; ++k)
        {
          points->SetValue(3 * cell + static_cast<vtkIdType>(k), refined.triangles[i][k]);
        }
        originals->SetValue(cell, block.inputCell(refined.faces[i]));
      });
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, points); // of one size alone, VTK 9.6 would make no array of offsets
  output->GetCellData()->CopyGlobalIdsOff(); // the parts of one cell would share one
  copyData(
    from, count, [&originals](vtkIdType i) { return originals->GetValue(i); },
    output->GetCellData(), job.part(idsWritten, 1.0));
  output->SetPolys(triangles);
  output->GetCellData()->AddArray(originals);
}

void keepPoints(vtkIdList* used, vtkPolyData* data)
{
  const vtkIdType count = used->GetNumberOfIds();
  requireMemory(count, 3 * static_cast<vtkIdType>(sizeof(double)));
  vtkNew<vtkPoints> points;
  points->SetDataType(data->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  data->GetPoints()->GetData()->GetTuples(used, points->GetData());
  data->SetPoints(points);

  vtkNew<vtkPointData> kept;
  requireMemory(count, bytesATuple(data->GetPointData()));
  kept->CopyAllOn();
  copyData(
    data->GetPointData(), count, [used](vtkIdType i) { return used->GetId(i); }, kept);
  data->GetPointData()->ShallowCopy(kept);
}

}

std::vector<RefinedBlock> partsByBlock(
  const PolyDataSurface& surface, RefinedMesh refined, std::vector<SourceValues> values)
{
  std::vector<RefinedBlock> parts(surface.blocks.size());
  if (parts.size() == 1)
  {
    parts.front() = { std::move(refined), std::move(values) };
    return parts;
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    parts[i].mesh.numberOfInputPoints = surface.blocks[i].numberOfPoints;
  }
  // The block of each new point and its number there: points between it and others need them.
  std::vector<std::size_t> blocks;
  std::vector<Id> numbers;
  const auto numberOf = [&](Id point, const SurfaceBlock& block)
  {
    return point < refined.numberOfInputPoints ? point - block.firstPoint
                                               : numbers[point - refined.numberOfInputPoints];
  };
  for (std::size_t i = 0; i < refined.points.size(); ++i)
  {
    RefinedPoint& point = refined.points[i];
    const Id first = point.parents[0];
    blocks.push_back(first < refined.numberOfInputPoints
        ? surface.blockOf(first, &SurfaceBlock::firstPoint)
        : blocks[first - refined.numberOfInputPoints]);
    for (Id& parent : point.parents)
    {
      parent = numberOf(parent, surface.blocks[blocks[i]]);
    }
    auto& [part, valuesOfPart] = parts[blocks[i]];
    numbers.push_back(part.numberOfInputPoints + static_cast<Id>(part.points.size()));
    part.points.push_back(point);
    if (!values.empty())
    {
      valuesOfPart.push_back(values[i]);
    }
  }
  refined.points = {};
  values = {};
  for (std::size_t i = 0; i < refined.triangles.size(); ++i)
  {
    const std::size_t index = surface.blockOf(refined.faces[i], &SurfaceBlock::firstTriangle);
    const SurfaceBlock& block = surface.blocks[index];
    Triangle triangle = refined.triangles[i];
    for (Id& corner : triangle)
    {
      corner = numberOf(corner, block);
    }
    parts[index].mesh.triangles.push_back(triangle);
    parts[index].mesh.faces.push_back(refined.faces[i] - block.firstTriangle);
  }
  return parts;
}

void writeWhole(const BlockToWrite& to, const Job& job)
{
  const auto& [block, input, output, pointType] = to;
  output->SetPoints(storePoints(input->GetPoints(), pointType, {}, {}, job));
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
  output->GetCellData()->CopyGlobalIdsOff();
  copyData(
    from, count, [&to](vtkIdType i) { return to.block.inputCell(i); }, output->GetCellData(), job);
}

void writeRefined(
  const BlockToWrite& to, const RefinedMesh& refined, const PowerOfTwoScale& scale, const Job& job)
{
  const auto& [block, input, output, pointType] = to;
  constexpr double pointsDone = 0.1;
  constexpr double pointDataDone = 0.5;
  output->SetPoints(
    storePoints(input->GetPoints(), pointType, refined.points, scale, job.part(0.0, pointsDone)));
  interpolatePointData(
    refined, input->GetPointData(), output->GetPointData(), job.part(pointsDone, pointDataDone));
  writeCells(block, refined, input->GetCellData(), output, job.part(pointDataDone, 1.0));
}

void removeUnusedPoints(vtkPolyData* data)
{
  constexpr vtkIdType unused = -1;
  const vtkIdType count = data->GetNumberOfPoints();
  requireMemory(count, 2 * static_cast<vtkIdType>(sizeof(vtkIdType)));
  // The number of each point among those that are used.
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(count), unused);
  forEachCell(data->GetPolys(),
    [&numbers](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        numbers[static_cast<std::size_t>(ids[i])] = 0;
      }
    });
  vtkNew<vtkIdList> used;
  used->Allocate(count);
  for (std::size_t point = 0; point < numbers.size(); ++point)
  {
    if (numbers[point] != unused)
    {
      numbers[point] = used->InsertNextId(static_cast<vtkIdType>(point));
    }
  }
  if (used->GetNumberOfIds() == count)
  {
    return;
  }
  keepPoints(used, data);
  const vtkIdType cells = data->GetNumberOfPolys();
  const vtkIdType ids = data->GetPolys()->GetNumberOfConnectivityIds();
  requireMemory(cells + 1 + ids, sizeof(vtkIdType));
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(cells, ids);
  forEachCell(data->GetPolys(),
    [&numbers, &polygons](vtkIdType, const vtkIdType* points)
    {
      const auto number = [&](int k) { return numbers[static_cast<std::size_t>(points[k])]; };
      polygons->InsertNextCell({ number(0), number(1), number(2) });
    });
  data->SetPolys(polygons);
}

}
