// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/FaceLocator.h"

#include "PolyData/Memory.h"
#include "mesh/SurfaceSnap.h"

#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <exception>
#include <string>

namespace geodesic
{

namespace
{

constexpr Id FacesInPart = Id(1) << 16;
constexpr Id Samples = 4096;

}

FaceLocator::FaceLocator(const TriangleMesh& mesh, const ProgressCallback& progress)
  : mesh_(mesh)
{
  requireMemory(mesh.numberOfVertices(), 3 * sizeof(double));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.numberOfVertices());
  for (Id v = 0; v < mesh.numberOfVertices(); ++v)
  {
    points->SetPoint(v, mesh.point(v).data());
  }
  for (Id first = 0; first < mesh.numberOfFaces();
       first += std::min(FacesInPart, mesh.numberOfFaces() - first))
  {
    if (progress && !progress(static_cast<double>(first) / mesh.numberOfFaces()))
    {
      throw Aborted();
    }
    this->addPart(points, first, first + std::min(FacesInPart, mesh.numberOfFaces() - first));
  }
  for (Id face = 0; face < mesh.numberOfFaces() && mesh.report().zeroAreaFaces > 0; ++face)
  {
    if (mesh.shape(face).hasZeroArea())
    {
      this->zeroAreaFaces_.push_back(face);
    }
  }
  const Id stride = mesh.numberOfFaces() / Samples + 1;
  for (Id face = 0; face < mesh.numberOfFaces(); face += stride)
  {
    this->samples_.push_back(face);
  }
}

FaceLocator::~FaceLocator() = default;

void FaceLocator::addPart(vtkPoints* points, Id first, Id last)
{
  constexpr vtkIdType idsAFace = 4; // three points and an offset
  requireMemory(last - first + 1, idsAFace * sizeof(vtkIdType));
  vtkNew<vtkCellArray> faces;
  faces->AllocateExact(last - first, 3 * static_cast<vtkIdType>(last - first));
  for (Id face = first; face < last; ++face)
  {
    const Triangle& t = this->mesh_.triangle(face);
    faces->InsertNextCell(
      { static_cast<vtkIdType>(t[0]), static_cast<vtkIdType>(t[1]), static_cast<vtkIdType>(t[2]) });
  }
  vtkNew<vtkPolyData> part;
  part->SetPoints(points);
  part->SetPolys(faces);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(part);
  // Where memory runs out for one of VTK's threads, it ends the process: here there is just this
  // one.
  std::exception_ptr failure;
  const auto build = [&]()
  {
    try
    {
      locator->BuildLocator();
    }
    catch (...)
    {
      failure = std::current_exception(); // LocalScope has to restore the user's settings
    }
  };
  vtkSMPTools::LocalScope(vtkSMPTools::Config(std::string("Sequential")), build);
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  this->parts_.emplace_back(locator);
}

void FaceLocator::tryFace(Id face, const Vec3& point)
{
  const double distance = snapToFace(this->mesh_, face, point, 0.0).distance;
  if (distance < this->distance_)
  {
    this->face_ = face;
    this->distance_ = distance;
  }
}

// A search without a radius is slow in parts that are far away.
Id FaceLocator::closest(const Vec3& point)
{
  const auto corner = [&](Id face)
  { return norm(this->mesh_.point(this->mesh_.triangle(face)[0]) - point); };
  this->distance_ = Infinity;
  this->tryFace(*std::min_element(this->samples_.begin(), this->samples_.end(),
                  [&](Id a, Id b) { return corner(a) < corner(b); }),
    point);
  for (const Id face : this->zeroAreaFaces_)
  {
    this->tryFace(face, point);
  }
  for (std::size_t i = 0; i < this->parts_.size(); ++i)
  {
    Vec3 closest;
    vtkIdType found = -1;
    int subId = 0;
    double distance2 = 0.0;
    int inside = 0;
    if (this->distance_ > 0.0 &&
      this->parts_[i]->FindClosestPointWithinRadius(const_cast<double*>(point.data()),
        this->distance_, closest.data(), this->cell_, found, subId, distance2, inside) != 0 &&
      found >= 0)
    {
      this->tryFace(static_cast<Id>(i) * FacesInPart + static_cast<Id>(found), point);
    }
  }
  return this->face_;
}

}
