// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Triangulator_h
#define geodesic_Triangulator_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/reading/VertexOfPoint.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
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
  /// Whether a ghost array marks that cell as a duplicate.
  std::vector<bool> isDuplicate;
  /// The first triangle of each block, then the number of all.
  std::vector<std::size_t> firstOfBlock;

  bool hasDuplicates() const
  {
    return std::find(this->isDuplicate.begin(), this->isDuplicate.end(), true) !=
      this->isDuplicate.end();
  }

  /// Calls visit(first, last) for each cell that has triangles, in their order: with its first
  /// triangle and the one after its last.
  template <typename Visit>
  void forEachCell(Visit&& visit) const
  {
    for (std::size_t block = 0; block + 1 < this->firstOfBlock.size(); ++block)
    {
      const std::size_t end = this->firstOfBlock[block + 1];
      for (std::size_t first = this->firstOfBlock[block]; first < end;)
      {
        std::size_t last = first + 1;
        while (last < end && this->cells[last] == this->cells[first])
        {
          ++last;
        }
        visit(first, last);
        first = last;
      }
    }
  }
};

/// Collects the triangles of one block's cells, without those that have two corners at one vertex.
class Triangulator
{
public:
  /// \param block whose cells are to be added.
  /// \param firstPoint the number of the block's point 0 among those of all blocks.
  /// \param triangles to which triangles are added; like vertexOf it must outlive this.
  Triangulator(const PolyDataBlock& block, Id firstPoint, const VertexOfPoint& vertexOf,
    TriangleList& triangles);
  ~Triangulator();

  /// A cell's number in its block, and whether a ghost array marks it as a duplicate, which is not
  /// counted.
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

  /// How many faces with two corners at one vertex were left out, duplicates not counted.
  vtkIdType facesWithRepeatedPoint() const { return this->facesWithRepeatedPoint_; }
  /// Whether there was a cell other than a triangle, duplicate or not.
  bool hasOtherCells() const { return this->hasOtherCells_; }

private:
  Id pointOf(vtkIdType id) const { return this->firstPoint_ + static_cast<Id>(id); }
  Id vertexOf(vtkIdType id) const { return this->vertexOfPoint_(this->pointOf(id)); }
  void addTriangle(const Cell& cell, vtkIdType a, vtkIdType b, vtkIdType c);
  void leaveOut(const Cell& cell);
  void cutEars(const Cell& cell);
  vtkIdType corner(vtkIdType i) const;
  void addFan(const Cell& cell);

  const PolyDataBlock& block_;
  vtkPoints* points_;
  Id firstPoint_;
  const VertexOfPoint& vertexOfPoint_;
  TriangleList& triangles_;
  vtkIdType facesWithRepeatedPoint_ = 0;
  bool hasOtherCells_ = false;
  std::vector<vtkIdType> outline_;
  vtkNew<vtkPolygon> polygon_;
  vtkNew<vtkIdList> ears_;
};

}

#endif
