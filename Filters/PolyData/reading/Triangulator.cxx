// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/Triangulator.h"

#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkVersionMacros.h"

namespace geodesic
{

Triangulator::Triangulator(
  const PolyDataBlock& block, Id firstPoint, const VertexOfPoint& vertexOf, TriangleList& triangles)
  : block_(block)
  , points_(block.data->GetPoints())
  , firstPoint_(firstPoint)
  , vertexOfPoint_(vertexOf)
  , triangles_(triangles)
{
}

Triangulator::~Triangulator() = default;

void Triangulator::addPolygon(const Cell& cell, vtkIdType size, const vtkIdType* ids)
{
  requirePoints<MeshError>(this->block_, cell.number, size, ids);
  if (size == 3)
  {
    this->addTriangle(cell, ids[0], ids[1], ids[2]);
    return;
  }
  this->hasOtherCells_ = true;
  this->outline_.clear();
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (this->vertexOf(ids[i]) != this->vertexOf(ids[(i + 1) % size]))
    {
      this->outline_.push_back(ids[i]);
    }
  }
  if (this->outline_.size() < 3)
  {
    this->leaveOut(cell);
    return;
  }
  this->cutEars(cell);
}

void Triangulator::addStrip(const Cell& cell, vtkIdType size, const vtkIdType* ids)
{
  requirePoints<MeshError>(this->block_, cell.number, size, ids);
  this->hasOtherCells_ = true;
  for (vtkIdType i = 0; i + 2 < size; ++i)
  {
    const vtkIdType odd = i % 2;
    this->addTriangle(cell, ids[i + odd], ids[i + 1 - odd], ids[i + 2]);
  }
}

void Triangulator::addTriangle(const Cell& cell, vtkIdType a, vtkIdType b, vtkIdType c)
{
  const Triangle points = { this->pointOf(a), this->pointOf(b), this->pointOf(c) };
  if (!hasThreeVertices(this->vertexOfPoint_(points)))
  {
    this->leaveOut(cell);
    return;
  }
  this->triangles_.corners.push_back(points);
  this->triangles_.cells.push_back(cell.number);
  this->triangles_.isDuplicate.push_back(cell.isDuplicate);
}

void Triangulator::leaveOut(const Cell& cell)
{
  this->facesWithRepeatedPoint_ += cell.isDuplicate ? 0 : 1;
}

void Triangulator::cutEars(const Cell& cell)
{
  const auto size = static_cast<vtkIdType>(this->outline_.size());
  this->polygon_->Initialize(static_cast<int>(size), this->outline_.data(), this->points_);
#if VTK_VERSION_NUMBER >= 90300000000ULL
  this->polygon_->TriangulateLocalIds(0, this->ears_);
#else
  this->polygon_->Triangulate(this->ears_);
#endif
  const vtkIdType corners = this->ears_->GetNumberOfIds();
  if (corners != 3 * (size - 2))
  {
    this->addFan(cell); // no area or an outline that crosses itself: any triangles conduct
    return;
  }
  for (vtkIdType i = 0; i < corners; i += 3)
  {
    this->addTriangle(cell, this->corner(i), this->corner(i + 1), this->corner(i + 2));
  }
}

vtkIdType Triangulator::corner(vtkIdType i) const
{
  return this->outline_[static_cast<std::size_t>(this->ears_->GetId(i))];
}

void Triangulator::addFan(const Cell& cell)
{
  for (std::size_t i = 1; i + 1 < this->outline_.size(); ++i)
  {
    this->addTriangle(cell, this->outline_[0], this->outline_[i], this->outline_[i + 1]);
  }
}

}
