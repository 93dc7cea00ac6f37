// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/PointDataInterpolation.h"

#include "PolyData/Memory.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
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

vtkUnsignedCharArray* asGhosts(vtkAbstractArray* array)
{
  const char* name = array->GetName();
  return name && std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0
    ? vtkUnsignedCharArray::SafeDownCast(array)
    : nullptr;
}

}

void interpolatePointData(const RefinedMesh& refined, vtkPointData* from, vtkPointData* to,
  double end, LoopProgress& progress)
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
  to->CopyData(from, 0, old, 0);
  const std::vector<Blend> blends = blendsOf(refined);
  vtkNew<vtkIdList> corners;
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    const int left = to->GetNumberOfArrays() - i;
    progress.nextUntil(progress.end() + (end - progress.end()) / left);
    vtkAbstractArray* array = to->GetAbstractArray(i);
    vtkUnsignedCharArray* ghosts = asGhosts(array);
    const bool isLabelArray = isLabel(to, i);
    for (std::size_t j = 0; j < blends.size(); ++j)
    {
      progress.at(j, blends.size());
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

}
