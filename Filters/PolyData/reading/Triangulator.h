// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Triangulator_h
#define geodesic_Triangulator_h

#include "PolyData/PolyDataBlocks.h"
#include "Types.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <vector>

class vtkIdList;
class vtkPoints;
class vtkPolygon;

namespace geodesic
{

/// The triangles of all blocks, one after another.
struct TriangleList
{
  /// Points at the corners, numbered through all blocks.
  std::vector<Triangle> corners;
  /// The cell of its block that each triangle came from.
  std::vector<vtkIdType> cells;
  /// Whether that cell is marked as a duplicate by a ghost array.
  std::vector<bool> isDuplicate;
};

/// Collects the triangles of one block's cells, without those that have two corners at one vertex.
class Triangulator
{
public:
  /// \param block whose cells are to be added.
  /// \param firstPoint the number of the block's point 0 among those of all blocks.
  /// \param vertexOfPoint which vertex each point of all blocks is; empty where each is its own.
  /// \param triangles to which triangles are added; like vertexOfPoint it must outlive this.
  Triangulator(const PolyDataBlock& block, Id firstPoint, const std::vector<Id>& vertexOfPoint,
    TriangleList& triangles);
  ~Triangulator();

  /// A cell's number in its block, and whether a ghost array marks it as a duplicate: it is not
  /// counted then.
  struct Cell
  {
    vtkIdType number;
    bool isDuplicate;
  };

  /// Adds a triangle, or cuts a polygon into triangles.
  ///
  /// \throws MeshError where the cell names a point that does not exist.
  void addPolygon(const Cell& cell, vtkIdType size, const vtkIdType* ids);
  void addStrip(const Cell& cell, vtkIdType size, const vtkIdType* ids);

  /// What was added, without duplicates.
  struct Report
  {
    vtkIdType polygons = 0;
    vtkIdType strips = 0;
    /// Faces with two corners at one vertex, which were left out.
    vtkIdType facesWithRepeatedPoint = 0;
  };
  const Report& report() const { return this->report_; }
  /// Whether there was a cell other than a triangle, duplicate or not.
  bool hasOtherCells() const { return this->hasOtherCells_; }

private:
  Id pointOf(vtkIdType id) const { return this->firstPoint_ + static_cast<Id>(id); }
  Id vertexOf(vtkIdType id) const
  {
    return this->vertexOfPoint_.empty() ? this->pointOf(id)
                                        : this->vertexOfPoint_[this->pointOf(id)];
  }
  void check(const Cell& cell, vtkIdType size, const vtkIdType* ids) const;
  void addTriangle(const Cell& cell, vtkIdType a, vtkIdType b, vtkIdType c);
  void leaveOut(const Cell& cell);
  void cutEars(const Cell& cell);
  vtkIdType corner(vtkIdType i) const;
  void addFan(const Cell& cell);

  const PolyDataBlock& block_;
  vtkPoints* points_;
  Id firstPoint_;
  const std::vector<Id>& vertexOfPoint_;
  TriangleList& triangles_;
  Report report_;
  bool hasOtherCells_ = false;
  std::vector<vtkIdType> outline_;
  vtkNew<vtkPolygon> polygon_;
  vtkNew<vtkIdList> ears_;
};

}

#endif
