// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/PathWriter.h"

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

/// The arrays of the output, filled path by path.
class PathArrays
{
public:
  PathArrays(const PowerOfTwoScale& scale, const PathEndChoice& choice)
    : scale_(scale)
    , choice_(choice)
  {
    this->points_->SetDataTypeToDouble();
    this->left_->SetName("GeodesicDistance");
    this->lengths_->SetName("GeodesicDistance");
    this->targetIds_->SetName("TargetId");
    this->sourceIds_->SetName("SourceId");
    this->snapDistances_->SetName("TargetSnapDistance");
    this->arcLengths_->SetName("SourceArcLength");
    this->angles_->SetName("SourceAngle");
  }

  void allocate(vtkIdType paths, vtkIdType points)
  {
    // A point, what is left and its id; a path's offset and six arrays.
    requireMemory(points, 4 * sizeof(double) + sizeof(vtkIdType));
    requireMemory(paths, 4 * sizeof(double) + 3 * sizeof(vtkIdType));
    this->points_->SetNumberOfPoints(points);
    this->left_->SetNumberOfTuples(points);
    this->lines_->AllocateExact(paths, points);
    this->lengths_->Allocate(paths);
    this->targetIds_->Allocate(paths);
    this->sourceIds_->Allocate(paths);
    this->snapDistances_->Allocate(paths);
    this->arcLengths_->Allocate(paths);
    this->angles_->Allocate(paths);
  }

  void add(const PathOfTarget& path)
  {
    const std::vector<Vec3>& places = path.points;
    const auto count = static_cast<vtkIdType>(places.size());
    const vtkIdType first = this->nextPoint_;
    this->lines_->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->points_->SetPoint(
        first + i, this->scale_.toUser(places[static_cast<std::size_t>(i)]).data());
      this->lines_->InsertCellPoint(first + i);
    }
    double left = 0.0;
    for (vtkIdType i = count; i-- > 0;)
    {
      const auto at = static_cast<std::size_t>(i);
      left += i + 1 < count ? norm(places[at + 1] - places[at]) : 0.0;
      this->left_->SetValue(first + i, this->toUser(left));
    }
    this->lengths_->InsertNextValue(this->toUser(left));
    this->targetIds_->InsertNextValue(static_cast<vtkIdType>(path.target));
    this->sourceIds_->InsertNextValue(
      path.end.source == NoId ? vtkIdType(-1) : static_cast<vtkIdType>(path.end.source));
    this->snapDistances_->InsertNextValue(this->scale_.toUser(path.snapDistance));
    this->arcLengths_->InsertNextValue(this->scale_.toUser(path.end.arcLength));
    this->angles_->InsertNextValue(path.end.angle);
    this->nextPoint_ += count;
  }

  void giveTo(vtkPolyData* output) const
  {
    output->SetPoints(this->points_);
    output->SetLines(this->lines_);
    vtkCellData* cellData = output->GetCellData();
    cellData->AddArray(this->targetIds_);
    cellData->AddArray(this->sourceIds_);
    cellData->AddArray(this->lengths_);
    cellData->AddArray(this->snapDistances_);
    if (this->choice_.arcLengths)
    {
      cellData->AddArray(this->arcLengths_);
    }
    if (this->choice_.angles)
    {
      cellData->AddArray(this->angles_);
    }
    output->GetPointData()->SetScalars(this->left_);
  }

private:
  double toUser(double length) const
  {
    const double result = this->scale_.toUser(length);
    if (!(result < Infinity))
    {
      throw MeshError("Paths on the surface (input port 0) are longer than numbers can be. Scale "
                      "the surface, the source and the targets upstream.");
    }
    return result;
  }

  const PowerOfTwoScale& scale_;
  PathEndChoice choice_;
  vtkIdType nextPoint_ = 0;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> lines_;
  vtkNew<vtkDoubleArray> left_;
  vtkNew<vtkDoubleArray> lengths_;
  vtkNew<vtkIdTypeArray> targetIds_;
  vtkNew<vtkIdTypeArray> sourceIds_;
  vtkNew<vtkDoubleArray> snapDistances_;
  vtkNew<vtkDoubleArray> arcLengths_;
  vtkNew<vtkDoubleArray> angles_;
};

}

void writePaths(const PowerOfTwoScale& scale, const std::vector<PathOfTarget>& paths,
  const PathEndChoice& choice, vtkPolyData* output, const ProgressCallback& callback)
{
  std::size_t points = 0;
  for (const PathOfTarget& path : paths)
  {
    points += path.points.size();
  }
  PathArrays arrays(scale, choice);
  arrays.allocate(static_cast<vtkIdType>(paths.size()), static_cast<vtkIdType>(points));
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  std::size_t done = 0; // points: paths may be long
  for (const PathOfTarget& path : paths)
  {
    arrays.add(path);
    for (std::size_t i = 0; i < path.points.size(); ++i)
    {
      progress.at(done++, points);
    }
  }
  arrays.giveTo(output);
}

}
