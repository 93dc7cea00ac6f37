// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/OutputPoints.h"

#include "PolyData/Memory.h"
#include "Tolerance.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace geodesic
{

namespace
{

/// How far numbers up to this size are rounded in single precision.
double singleRounding(double largest)
{
  const int exponent = std::max(std::ilogb(largest), FLT_MIN_EXP - 1);
  return std::ldexp(0.5, exponent - (FLT_MANT_DIG - 1));
}

/// The rounding in space of places on the surface in single precision.
double singleRounding(const PolyDataSurface& surface)
{
  const Vec3 largest = surface.scale.toUser(surface.box.largestCoordinates());
  return norm(surface.scale.toEngine(
    Vec3{ singleRounding(largest[0]), singleRounding(largest[1]), singleRounding(largest[2]) }));
}

/// How far points of this rank's input are from the vertices that they were made.
double largestJoint(
  const PolyDataSurface& surface, const std::vector<PolyDataBlock>& inputs, const Job& job)
{
  const TriangleMesh& mesh = surface.mesh();
  double largest = 0.0;
  for (std::size_t i = 0; i < inputs.size() && !surface.vertexOf.isIdentity(); ++i)
  {
    const SurfaceBlock& block = surface.blocks[i];
    const auto inRange = [&](std::size_t begin, std::size_t end)
    {
      double farthest = 0.0;
      for (std::size_t point = begin; point < end; ++point)
      {
        const Id vertex = surface.vertexOf(block.firstPoint + static_cast<Id>(point));
        // Others are on barriers, for which nothing is certified, or another rank's copies.
        if (vertex < mesh.numberOfVertices() && mesh.cornersAt(vertex).size() > 0)
        {
          Vec3 place;
          inputs[i].data->GetPoints()->GetPoint(static_cast<vtkIdType>(point), place.data());
          farthest = std::max(farthest, norm(surface.scale.toEngine(place) - mesh.point(vertex)));
        }
      }
      return farthest;
    };
    for (const double farthest : job.resultsOfRanges(block.numberOfPoints, inRange))
    {
      largest = std::max(largest, farthest);
    }
  }
  return largest;
}

/// Points that are not there have the type of VTK's new ones.
int typeOf(vtkPoints* points)
{
  return points ? points->GetDataType() : VTK_FLOAT;
}

}

Displacements displacementsOfPoints(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& inputs, int precision, const Job& job)
{
  const bool toSingle = precision == vtkAlgorithm::SINGLE_PRECISION;
  const double rounding = toSingle ? singleRounding(surface) : 0.0;
  const bool areSingle = std::all_of(inputs.begin(), inputs.end(),
    [](const PolyDataBlock& input) { return typeOf(input.data->GetPoints()) == VTK_FLOAT; });
  const double ofInput = largestJoint(surface, inputs, job) + (areSingle ? 0.0 : rounding);
  // Each coordinate is summed up first.
  const double ofSum = std::sqrt(3.0) * tolerance::PositionRoundings * tolerance::Rounding *
    surface.box.largestCoordinate();
  return { surface.exchange().largestOf(ofInput), ofSum + rounding };
}

void requireRangeOf(int precision, const PolyDataSurface& surface)
{
  if (precision == vtkAlgorithm::SINGLE_PRECISION &&
    surface.scale.toUser(surface.box.largestCoordinate()) > FLT_MAX)
  {
    throw MeshError("Coordinates of the surface (input port 0) are too large for single precision. "
                    "Set OutputPointsPrecision to the default or to double precision.");
  }
}

int typeOfPoints(vtkPoints* input, int precision, bool hasNewPoints)
{
  if (precision == vtkAlgorithm::DEFAULT_PRECISION)
  {
    return hasNewPoints ? VTK_DOUBLE : typeOf(input);
  }
  return precision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE;
}

vtkSmartPointer<vtkPoints> storePoints(vtkPoints* input, int type,
  const std::vector<RefinedPoint>& added, const PowerOfTwoScale& scale, const Job& job)
{
  if (added.empty() && typeOf(input) == type)
  {
    return input;
  }
  const vtkIdType old = input ? input->GetNumberOfPoints() : 0;
  const vtkIdType count = old + static_cast<vtkIdType>(added.size());
  const std::size_t size = type == VTK_FLOAT ? sizeof(float) : sizeof(double);
  requireMemory(count, static_cast<vtkIdType>(3 * size));
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(count);
  if (input)
  {
    points->GetData()->InsertTuples(0, old, 0, input->GetData());
  }
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    job.reachItem(i, added.size());
    points->SetPoint(old + static_cast<vtkIdType>(i), scale.toUser(added[i].position).data());
  }
  return points;
}

}
