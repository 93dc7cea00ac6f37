// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolyDataSurface_h
#define geodesic_PolyDataSurface_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/PowerOfTwoScale.h"
#include "PolyData/ranks/BarriersOnRanks.h"
#include "PolyData/ranks/RemoteVertices.h"
#include "mesh/BarrierFaces.h"
#include "mesh/MeshPartition.h"
#include "mesh/TriangleMesh.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <optional>
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

/// What a triangle of a surface is.
enum class TriangleRole : std::uint8_t
{
  /// A face that paths may enter: one of the input faces of the mesh.
  Open,
  /// A face that they may not enter: one of the input faces of BarrierFaces.
  Barrier,
  /// Marked as a duplicate, by a ghost array, of another triangle that is here: no face.
  Copy
};

/// What vertices of a piece are in the whole surface, those of barriers too.
struct PieceVertices
{
  /// The same on all ranks for one vertex, and for no other. Of vertices of the mesh it is the
  /// part's number in the whole, of those that only barriers have it is larger; NoId where there is
  /// no face.
  std::vector<Id> numbers;
  std::vector<Vec3> positions;
};

/// A surface of one or more vtkPolyData as the engine takes it, and the way back to their points
/// and cells. Points and triangles are numbered through all blocks. Made by readSurface().
///
/// Barriers are triangles of the surface, of which outputs have all, but no faces of the mesh: see
/// BarrierFaces.
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
    /// Vertices on the boundaries of blocks or of ranks' pieces that are one with another within
    /// the precision of coordinates.
    vtkIdType joinedSeamPoints = 0;
    /// See TriangleMesh::Report.
    vtkIdType duplicateFaces = 0;
    vtkIdType zeroAreaFaces = 0;
    /// Points that no face uses, barrier or not.
    vtkIdType isolatedPoints = 0;
    /// The edges of the mesh.
    vtkIdType edges = 0;

    /// Adds what another rank's piece has.
    void add(const Report& other);
  };

  /// A surface that is whole in this process.
  ///
  /// \param mesh its vertices are the points, or what vertexOfPoint says; its input faces are the
  ///        open triangles of all blocks.
  /// \param barriers whose input faces are the triangles that are barriers; null where none is.
  /// \param vertexOfPoint the vertex that stands for each point; empty where each is its own.
  /// \param roles of the triangles; empty where all are open.
  /// \param scale of the mesh against the points.
  /// \param diagonal of the bounding box of the points that triangles use.
  PolyDataSurface(std::unique_ptr<TriangleMesh> mesh, std::unique_ptr<BarrierFaces> barriers,
    std::vector<Id> vertexOfPoint, std::vector<SurfaceBlock> blocks,
    std::vector<TriangleRole> roles, const PowerOfTwoScale& scale, double diagonal,
    const Report& report);
  /// A piece of a surface that several ranks have together.
  ///
  /// \param part its input triangles are the open triangles of all blocks.
  /// \param barriers whose part's input triangles are those that are barriers; null where no rank
  ///        has any.
  /// \param borrowed the vertices that are not the part's own: their numbers follow those of the
  ///        part's mesh.
  PolyDataSurface(std::unique_ptr<MeshPartition> part, std::unique_ptr<BarriersOnRanks> barriers,
    RemoteVertices borrowed, std::vector<Id> vertexOfPoint, std::vector<SurfaceBlock> blocks,
    std::vector<TriangleRole> roles, const PowerOfTwoScale& scale, double diagonal,
    const Report& report);

  /// The faces that paths may enter; of a piece with those around it.
  const TriangleMesh& mesh() const { return this->partition_->mesh(); }
  /// What this rank has of the surface; in one process all of it.
  const MeshPartition& partition() const { return *this->partition_; }
  /// Of a piece, gives values at the mesh's vertices one at each vertex that vertexOf() names. All
  /// ranks call this together. Does nothing where the surface is whole.
  ///
  /// \param none the value where there is no face.
  template <typename Value>
  void completeValues(const Value& none, std::vector<Value>& values) const
  {
    if (this->borrowed_)
    {
      values.resize(this->mesh().numberOfVertices(), none);
      this->borrowed_->append(none, values, this->partition_->exchange());
    }
  }
  /// Of a piece. All ranks call this together.
  PieceVertices pieceVertices() const;
  /// Whether there are others: barriers, of a piece on any rank.
  bool hasBarriers() const { return this->barriers_ || this->barriersOnRanks_; }
  /// These; null where there are none, and for a piece.
  BarrierFaces* barriers() const { return this->barriers_.get(); }
  /// Those of a surface in pieces; null where there are none.
  BarriersOnRanks* barriersOnRanks() const { return this->barriersOnRanks_.get(); }
  /// Makes a mesh of all faces, barriers or not, on the same vertices; not of a piece.
  ///
  /// \param progress called now and then; returning false throws Aborted.
  std::unique_ptr<TriangleMesh> meshWithBarriers(const ProgressCallback& progress) const;
  /// The same of a piece. All ranks call this together.
  ///
  /// \param numbers filled with one for each vertex of the result's own: PieceVertices::numbers.
  std::unique_ptr<MeshPartition> partWithBarriers(
    std::vector<Id>& numbers, const ProgressCallback& progress) const;
  /// Of all ranks together.
  const Report& report() const { return this->report_; }
  /// What the mesh, and all that is computed on it, is larger by than the input.
  const PowerOfTwoScale& scale() const { return this->scale_; }
  /// Of the bounding box of the points that triangles use, on the mesh; of the whole surface.
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
  /// The vertices at the corners of a triangle that is given by points.
  Triangle verticesOf(const Triangle& points) const
  {
    return { this->vertexOf(points[0]), this->vertexOf(points[1]), this->vertexOf(points[2]) };
  }
  Id numberOfPoints() const;
  /// Whether some of the input's points are one vertex.
  bool hasMergedPoints() const { return !this->vertexOfPoint_.empty(); }

  /// The triangles that the output has where it is not refined. Of those on the same vertices the
  /// mesh has one: triangleOf() tells which.
  Id numberOfTriangles() const;
  /// Of these, the ones that are surface; the others are copies by ghost arrays.
  Id numberOfOwnTriangles() const { return this->numberOfTriangles() - this->numberOfCopies_; }
  TriangleRole role(Id triangle) const
  {
    return this->roles_.empty() ? TriangleRole::Open : this->roles_[triangle];
  }
  bool isCopy(Id triangle) const { return this->role(triangle) == TriangleRole::Copy; }
  /// The input's points at a triangle's corners.
  Triangle triangle(Id triangle) const;
  /// The triangle that a face of the mesh came from; not of a piece.
  Id triangleOf(Id face) const
  {
    const Id input = this->mesh().inputFace(face);
    return this->openTriangles_.empty() ? input : this->openTriangles_[input];
  }
  /// The triangles that are barriers.
  const std::vector<Id>& barrierTriangles() const { return this->barrierTriangles_; }
  /// The triangle that a face of the barriers' mesh came from; of a piece one that this rank owns.
  Id triangleOfBarrier(Id face) const
  {
    return this
      ->barrierTriangles_[this->barriersOnRanks_ ? this->barriersOnRanks_->triangleOf(face)
                                                 : this->barriers_->mesh().inputFace(face)];
  }
  /// The input's points at the corners of a face of the mesh.
  Triangle cornerPoints(Id face) const { return this->triangle(this->triangleOf(face)); }
  /// The block that a point or a triangle belongs to.
  std::size_t blockOfPoint(Id point) const;
  std::size_t blockOfTriangle(Id triangle) const;

private:
  /// What pieces and whole surfaces have in common.
  PolyDataSurface(std::vector<Id> vertexOfPoint, std::vector<SurfaceBlock> blocks,
    std::vector<TriangleRole> roles, const PowerOfTwoScale& scale, double diagonal,
    const Report& report);
  void sortRoles();

  /// In one process the mesh of the partition; else null.
  std::unique_ptr<TriangleMesh> mesh_;
  std::unique_ptr<MeshPartition> partition_;
  std::optional<RemoteVertices> borrowed_;
  std::unique_ptr<BarrierFaces> barriers_;
  std::unique_ptr<BarriersOnRanks> barriersOnRanks_;
  std::vector<Id> vertexOfPoint_;
  std::vector<SurfaceBlock> blocks_;
  std::vector<TriangleRole> roles_;
  /// Of all triangles the open ones; empty where all are.
  std::vector<Id> openTriangles_;
  std::vector<Id> barrierTriangles_;
  Id numberOfCopies_ = 0;
  PowerOfTwoScale scale_;
  double diagonal_;
  Report report_;
};

/// The first few of some ids, for an error message: "3, 17, 20 and 5 more".
std::string listIds(const std::vector<vtkIdType>& ids);

}

#endif
