// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicFarthestPoints.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/Inputs.h"
#include "PolyData/Memory.h"
#include "field/FarthestPoints.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <string>
#include <vector>

using namespace geodesic;

vtkStandardNewMacro(vtkGeodesicFarthestPoints);

namespace
{

/// Tells of points in parts of the surface without a source. Behind barriers they are as meant.
void NoteUnreached(
  const PolyDataSurface& surface, const std::vector<double>& distances, Notes& notes)
{
  const TriangleMesh& mesh = surface.mesh();
  Id count = 0;
  Id first = NoId;
  for (Id point = 0; point < surface.numberOfPoints && !surface.barriers; ++point)
  {
    const Id vertex = surface.vertexOf(point);
    if (vertex < mesh.numberOfVertices() && mesh.cornersAt(vertex).size() > 0 &&
      !(distances[vertex] < Infinity))
    {
      first = count++ == 0 ? point : first;
    }
  }
  if (count > 0)
  {
    notes.add(NoteOn::Surface, "unreached",
      std::to_string(count) +
        " points are left out, as no path leads to them from the source, such as point " +
        std::to_string(first) + ": give a point of the source in each part of the surface.");
  }
}

/// The first point at each vertex of the mesh.
std::vector<vtkIdType> FirstPoints(const PolyDataSurface& surface)
{
  std::vector<vtkIdType> points(surface.mesh().numberOfVertices());
  for (Id point = surface.numberOfPoints; point-- > 0;)
  {
    const Id vertex = surface.vertexOf(point);
    if (vertex < points.size())
    {
      points[vertex] = static_cast<vtkIdType>(point);
    }
  }
  return points;
}

}

//------------------------------------------------------------------------------
vtkTable* vtkGeodesicFarthestPoints::GetOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
int vtkGeodesicFarthestPoints::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
ExecutionPlan vtkGeodesicFarthestPoints::Plan() const
{
  ExecutionPlan plan;
  plan.stages = { Stage::SolveForTargets, Stage::Write };
  plan.supportsPieces = false;
  return plan;
}

//------------------------------------------------------------------------------
void vtkGeodesicFarthestPoints::Compute(
  const Inputs& inputs, FilterExecution& execution, vtkInformationVector* outputVector)
{
  if (!inputs.rank.isWorking())
  {
    return;
  }
  const PolyDataSurface& surface = *inputs.surface;
  const FarthestPoints found = farthestPoints(surface.mesh(), inputs.sources.curves,
    static_cast<std::size_t>(this->NumberOfPoints), execution.begin(Stage::SolveForTargets));
  NoteUnreached(surface, found.vertexDistances, execution.notes());

  execution.begin(Stage::Write);
  const auto rows = static_cast<vtkIdType>(found.points.size());
  const auto ids = makeArray<vtkIdTypeArray>("PointId", rows);
  const auto distances = makeArray<vtkDoubleArray>("GeodesicDistance", rows);
  const std::vector<vtkIdType> pointOf = FirstPoints(surface);
  for (vtkIdType row = 0; row < rows; ++row)
  {
    const FarthestPoint& point = found.points[static_cast<std::size_t>(row)];
    ids->SetValue(row, pointOf[point.vertex]);
    distances->SetValue(row, surface.scale.distanceToUser(point.distance));
  }
  vtkTable* table = vtkTable::GetData(outputVector);
  table->AddColumn(ids);
  table->AddColumn(distances);
}

//------------------------------------------------------------------------------
void vtkGeodesicFarthestPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
}
