// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/UnusedPoints.h"

#include "PolyData/CellLoop.h"
#include "PolyData/Memory.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <vector>

namespace geodesic
{

namespace
{

constexpr vtkIdType Unused = -1;

/// For each point its number among those that are used, or Unused.
///
/// \param used gets the points that are used, in their order.
std::vector<vtkIdType> numbersOfUsedPoints(vtkPolyData* data, vtkIdList* used)
{
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(data->GetNumberOfPoints()), Unused);
  forEachCell(data->GetPolys(),
    [&numbers](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        numbers[static_cast<std::size_t>(ids[i])] = 0;
      }
    });
  used->Allocate(data->GetNumberOfPoints());
  for (std::size_t point = 0; point < numbers.size(); ++point)
  {
    if (numbers[point] != Unused)
    {
      numbers[point] = used->InsertNextId(static_cast<vtkIdType>(point));
    }
  }
  return numbers;
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
  kept->CopyAllocate(data->GetPointData(), count);
  for (int i = 0; i < kept->GetNumberOfArrays(); ++i)
  {
    kept->GetAbstractArray(i)->SetNumberOfTuples(count);
  }
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    places->SetId(i, i);
  }
  kept->CopyData(data->GetPointData(), used, places);
  data->GetPointData()->ShallowCopy(kept);
}

void renumberPolygons(const std::vector<vtkIdType>& numbers, vtkPolyData* data)
{
  const vtkIdType count = data->GetPolys()->GetNumberOfCells();
  const vtkIdType size = data->GetPolys()->GetNumberOfConnectivityIds();
  requireMemory(count + 1 + size, sizeof(vtkIdType));
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(count, size);
  forEachCell(data->GetPolys(),
    [&](vtkIdType corners, const vtkIdType* ids)
    {
      polygons->InsertNextCell(static_cast<int>(corners));
      for (vtkIdType i = 0; i < corners; ++i)
      {
        polygons->InsertCellPoint(numbers[static_cast<std::size_t>(ids[i])]);
      }
    });
  data->SetPolys(polygons);
}

}

void removeUnusedPoints(vtkPolyData* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  requireMemory(count, 2 * static_cast<vtkIdType>(sizeof(vtkIdType)));
  vtkNew<vtkIdList> used;
  const std::vector<vtkIdType> numbers = numbersOfUsedPoints(data, used);
  if (used->GetNumberOfIds() < count)
  {
    keepPoints(used, data);
    renumberPolygons(numbers, data);
  }
}

}
