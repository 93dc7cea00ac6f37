// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/GhostCells.h"

#include "PolyData/reading/CellTriangles.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace geodesic
{

GhostCells::GhostCells(vtkPolyData* data)
{
  auto* flags = vtkUnsignedCharArray::SafeDownCast(
    data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!flags || flags->GetNumberOfComponents() != 1 ||
    flags->GetNumberOfTuples() < data->GetNumberOfCells())
  {
    return;
  }
  constexpr int marks = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells() && !this->flags_; ++cell)
  {
    this->flags_ = (flags->GetValue(cell) & marks) != 0 ? flags : nullptr;
  }
}

bool GhostCells::isDuplicate(vtkIdType cell) const
{
  return this->flags_ && (this->flags_->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

bool GhostCells::isHidden(vtkIdType cell) const
{
  return this->flags_ && (this->flags_->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0;
}

vtkIdType GhostCells::countOwn(vtkIdType first, vtkIdType last) const
{
  vtkIdType count = 0;
  for (vtkIdType cell = first; cell < last; ++cell)
  {
    count += this->isDuplicate(cell) || this->isHidden(cell) ? 0 : 1;
  }
  return count;
}

namespace
{

using Triple = std::array<Id, 3>;

/// Vertices in place of points.
class Vertices
{
public:
  explicit Vertices(const std::vector<Id>& vertexOfPoint)
    : vertexOfPoint_(vertexOfPoint)
  {
  }
  Id of(Id point) const
  {
    return this->vertexOfPoint_.empty() ? point : this->vertexOfPoint_[point];
  }
  /// The same for all triangles on the same vertices.
  Triple of(const Triangle& triangle) const
  {
    Triple triple = { this->of(triangle[0]), this->of(triangle[1]), this->of(triangle[2]) };
    std::sort(triple.begin(), triple.end());
    return triple;
  }

private:
  const std::vector<Id>& vertexOfPoint_;
};

/// Of cells that were cut into several triangles, takes the cut of an original over to its
/// duplicates.
class CutCopier
{
public:
  CutCopier(const std::vector<Id>& vertexOfPoint, const std::vector<SurfaceBlock>& blocks,
    TriangleList& triangles)
    : vertices_(vertexOfPoint)
    , blocks_(blocks)
    , triangles_(triangles)
  {
  }

  void run()
  {
    this->forEachCut(true,
      [this](std::size_t first, std::size_t last)
      { this->duplicates_[this->verticesOf(first, last)].push_back(first); });
    if (this->duplicates_.empty())
    {
      return;
    }
    this->forEachCut(false,
      [this](std::size_t first, std::size_t last)
      {
        const auto found = this->duplicates_.find(this->verticesOf(first, last));
        if (found == this->duplicates_.end())
        {
          return;
        }
        for (const std::size_t duplicate : found->second)
        {
          this->copy(first, last, duplicate);
        }
      });
  }

private:
  /// Calls with the first triangle of each cell that has several, and the one after its last.
  template <typename Visitor>
  void forEachCut(bool marked, Visitor&& visit)
  {
    forEachCell(this->blocks_, this->triangles_,
      [&](std::size_t first, std::size_t last)
      {
        if (last > first + 1 && this->triangles_.isDuplicate[first] == marked)
        {
          visit(first, last);
        }
      });
  }

  std::vector<Id> verticesOf(std::size_t first, std::size_t last) const
  {
    std::set<Id> vertices;
    for (std::size_t i = first; i < last; ++i)
    {
      for (const Id point : this->triangles_.corners[i])
      {
        vertices.insert(this->vertices_.of(point));
      }
    }
    return { vertices.begin(), vertices.end() };
  }

  /// Cells on the same corners have as many triangles, unless they touch themselves.
  void copy(std::size_t first, std::size_t last, std::size_t duplicate)
  {
    std::map<Id, Id> ownPoints;
    const std::size_t count = last - first;
    const auto& cells = this->triangles_.cells;
    if (duplicate + count > cells.size() || cells[duplicate + count - 1] != cells[duplicate])
    {
      return;
    }
    for (std::size_t i = duplicate; i < duplicate + count; ++i)
    {
      for (const Id point : this->triangles_.corners[i])
      {
        ownPoints.emplace(this->vertices_.of(point), point);
      }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      Triangle triangle = this->triangles_.corners[first + i];
      for (Id& corner : triangle)
      {
        const auto own = ownPoints.find(this->vertices_.of(corner));
        if (own == ownPoints.end())
        {
          return;
        }
        corner = own->second;
      }
      this->triangles_.corners[duplicate + i] = triangle;
    }
  }

  Vertices vertices_;
  const std::vector<SurfaceBlock>& blocks_;
  TriangleList& triangles_;
  std::map<std::vector<Id>, std::vector<std::size_t>> duplicates_;
};

}

std::vector<std::uint8_t> findCopies(const std::vector<Id>& vertexOfPoint,
  const std::vector<SurfaceBlock>& blocks, TriangleList& triangles)
{
  CutCopier(vertexOfPoint, blocks, triangles).run();
  const Vertices vertices(vertexOfPoint);
  // Of the places where marked triangles are, those that are taken.
  std::map<Triple, bool> isTaken;
  for (std::size_t i = 0; i < triangles.corners.size(); ++i)
  {
    if (triangles.isDuplicate[i])
    {
      isTaken.emplace(vertices.of(triangles.corners[i]), false);
    }
  }
  for (std::size_t i = 0; i < triangles.corners.size(); ++i)
  {
    const auto place =
      !triangles.isDuplicate[i] ? isTaken.find(vertices.of(triangles.corners[i])) : isTaken.end();
    if (place != isTaken.end())
    {
      place->second = true;
    }
  }
  std::vector<std::uint8_t> isCopy(triangles.corners.size(), 0);
  for (std::size_t i = 0; i < triangles.corners.size(); ++i)
  {
    if (triangles.isDuplicate[i])
    {
      bool& taken = isTaken[vertices.of(triangles.corners[i])];
      isCopy[i] = taken ? 1 : 0;
      taken = true;
    }
  }
  return isCopy;
}

}
