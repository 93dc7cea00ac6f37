// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolyDataSurface_h
#define geodesic_PolyDataSurface_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/PowerOfTwoScale.h"
#include "mesh/TriangleMesh.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkCellArray;

namespace geodesic
{

/// The part of a surface that is one vtkPolyData.
struct SurfaceBlock
{
  /// Its points among those of all blocks.
  Id firstPoint = 0;
  Id numberOfPoints = 0;
  /// Its triangles among those of all blocks.
  Id firstTriangle = 0;
  /// The triangles, with the block's own points.
  vtkSmartPointer<vtkCellArray> triangles;
  /// Whether these are the cells of the input.
  bool areInputCells = false;
  /// Otherwise the input's cell that each triangle came from.
  std::vector<vtkIdType> inputCells;

  vtkIdType numberOfTriangles() const;
  vtkIdType inputCell(vtkIdType triangle) const
  {
    return this->areInputCells ? triangle : this->inputCells[static_cast<std::size_t>(triangle)];
  }
};

/// A surface of one or more vtkPolyData as the engine takes it, and the way back to their points
/// and cells. Points and triangles are numbered through all blocks. Made by readSurface().
class PolyDataSurface
{
public:
  /// What the input had besides plain triangles; TriangleMesh::Report tells the rest.
  struct Report
  {
    vtkIdType polygons = 0;
    vtkIdType strips = 0;
    vtkIdType droppedVertexCells = 0;
    vtkIdType droppedLineCells = 0;
    /// Faces with two corners at one point, before or after merging; left out.
    vtkIdType facesWithRepeatedPoint = 0;
  };

  /// \param mesh its vertices are the points, or what vertexOfPoint says; its input faces are the
  ///        triangles of all blocks, without copies.
  /// \param vertexOfPoint the vertex that stands for each point; empty where each is its own.
  /// \param isCopy whether a triangle is marked as a duplicate, by a ghost array, of another that
  /// is
  ///        here: it is not among the input faces of the mesh. Empty where there are none.
  /// \param scale of the mesh against the points.
  /// \param diagonal of the bounding box of the points that triangles use.
  PolyDataSurface(std::unique_ptr<TriangleMesh> mesh, std::vector<Id> vertexOfPoint,
    std::vector<SurfaceBlock> blocks, std::vector<std::uint8_t> isCopy,
    const PowerOfTwoScale& scale, double diagonal, const Report& report);

  const TriangleMesh& mesh() const { return *this->mesh_; }
  const Report& report() const { return this->report_; }
  /// What the mesh, and all that is computed on it, is larger by than the input.
  const PowerOfTwoScale& scale() const { return this->scale_; }
  /// Of the bounding box of the points that triangles use, on the mesh.
  double diagonal() const { return this->diagonal_; }
  const std::vector<SurfaceBlock>& blocks() const { return this->blocks_; }
  /// Takes the cells of an input with the same content for those of the input that this was made
  /// of, which need not be kept any longer then.
  void useCellsOf(const std::vector<PolyDataBlock>& inputs);

  /// The vertex that stands for a point of the input.
  Id vertexOf(Id point) const
  {
    return this->vertexOfPoint_.empty() ? point : this->vertexOfPoint_[point];
  }
  Id numberOfPoints() const;
  /// Whether some of the input's points are one vertex.
  bool hasMergedPoints() const { return !this->vertexOfPoint_.empty(); }

  /// The triangles that the output has where it is not refined. Of those on the same vertices the
  /// mesh has one: triangleOf() tells which.
  Id numberOfTriangles() const;
  /// Of these, the ones that are surface; the others are copies by ghost arrays.
  Id numberOfOwnTriangles() const { return this->numberOfTriangles() - this->numberOfCopies_; }
  bool isCopy(Id triangle) const { return !this->isCopy_.empty() && this->isCopy_[triangle] != 0; }
  /// The input's points at a triangle's corners.
  Triangle triangle(Id triangle) const;
  /// The triangle that a face of the mesh came from.
  Id triangleOf(Id face) const
  {
    const Id input = this->mesh_->inputFace(face);
    return this->ownTriangles_.empty() ? input : this->ownTriangles_[input];
  }
  /// The input's points at the corners of a face of the mesh.
  Triangle cornerPoints(Id face) const { return this->triangle(this->triangleOf(face)); }
  /// The block that a point or a triangle belongs to.
  std::size_t blockOfPoint(Id point) const;
  std::size_t blockOfTriangle(Id triangle) const;

private:
  std::unique_ptr<TriangleMesh> mesh_;
  std::vector<Id> vertexOfPoint_;
  std::vector<SurfaceBlock> blocks_;
  std::vector<std::uint8_t> isCopy_;
  /// The triangles without copies; empty where there are none.
  std::vector<Id> ownTriangles_;
  Id numberOfCopies_ = 0;
  PowerOfTwoScale scale_;
  double diagonal_;
  Report report_;
};

/// The first few of some ids, for an error message: "3, 17, 20 and 5 more".
std::string listIds(const std::vector<vtkIdType>& ids);

}

#endif
