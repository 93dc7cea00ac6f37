// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolyDataSurface_h
#define geodesic_PolyDataSurface_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/PowerOfTwoScale.h"
#include "PolyData/ranks/BorrowedValues.h"
#include "mesh/BarrierFaces.h"
#include "mesh/Box.h"
#include "mesh/MeshPartition.h"

#include "vtkCellArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace geodesic
{

/// The part of a surface that is one vtkPolyData.
struct SurfaceBlock
{
  /// What messages call it, and how many cells it has: see PolyDataBlock.
  PartName name;
  vtkIdType numberOfInputCells = 0;
  /// Its points among those of all blocks.
  Id firstPoint = 0;
  Id numberOfPoints = 0;
  /// Its triangles among those of all blocks.
  Id firstTriangle = 0;
  /// The triangles, on the block's own points.
  vtkSmartPointer<vtkCellArray> triangles;
  /// Whether these are the cells of the input.
  bool areInputCells = false;
  /// Otherwise the input's cell that each triangle came from.
  std::vector<vtkIdType> inputCells;

  vtkIdType numberOfTriangles() const { return this->triangles->GetNumberOfCells(); }
  vtkIdType inputCell(vtkIdType triangle) const
  {
    return this->areInputCells ? triangle : this->inputCells[static_cast<std::size_t>(triangle)];
  }
};

/// The block that a point or a triangle belongs to, by its number.
///
/// \param first &SurfaceBlock::firstPoint or &SurfaceBlock::firstTriangle.
std::size_t blockOf(const std::vector<SurfaceBlock>& blocks, Id item, Id SurfaceBlock::*first);
/// The input's points at a triangle's corners.
Triangle pointsOfTriangle(const std::vector<SurfaceBlock>& blocks, Id triangle);

/// Says which vertex each point of all blocks is. If each point is a vertex of its own with the
/// same number, there is no table.
class VertexOfPoint
{
public:
  Id operator()(Id point) const { return this->table_.empty() ? point : this->table_[point]; }
  Triangle operator()(const Triangle& points) const
  {
    return { (*this)(points[0]), (*this)(points[1]), (*this)(points[2]) };
  }
  bool isIdentity() const { return this->table_.empty(); }

  /// Adds points behind all others.
  ///
  /// \param numberOfPoints that there are.
  void append(Id numberOfPoints, const std::vector<Id>& vertices)
  {
    if (this->table_.empty() && !vertices.empty())
    {
      this->table_.resize(numberOfPoints);
      std::iota(this->table_.begin(), this->table_.end(), Id(0));
    }
    this->table_.insert(this->table_.end(), vertices.begin(), vertices.end());
  }

  /// \param numbers the new number of each vertex; empty if none changes.
  void renumber(std::vector<Id> numbers)
  {
    if (numbers.empty())
    {
      return;
    }
    if (this->table_.empty())
    {
      this->table_ = std::move(numbers);
      return;
    }
    for (Id& vertex : this->table_)
    {
      vertex = numbers[vertex];
    }
  }

private:
  std::vector<Id> table_;
};

/// What a triangle of a surface, or a part of it, is.
enum class TriangleRole : std::uint8_t
{
  /// A face that paths may enter: one of the input faces of the mesh.
  Open,
  /// A face that they may not enter: one of the input faces of BarrierFaces.
  Barrier,
  /// Marked as a duplicate, by a ghost array, of another triangle that is here: no face.
  Copy,
  /// Without area, on edges of faces: no face.
  Segment
};

/// A point that triangles are cut at, where the block has none of its own: between two of its
/// points.
struct CutPoint
{
  std::array<Id, 2> parents;
  /// The fraction of the way from the first to the second.
  double weight;
};

/// A vertex of a rank's points, as all ranks know it.
struct GlobalVertex
{
  /// The same on all ranks for one vertex, and for no other. A vertex of the mesh has its number
  /// in the whole, a vertex of barriers only a larger one. NoId without any face.
  GlobalId globalId{ NoId };
  Vec3 position{};
  /// Who has faces of the mesh at the vertex, and its number there; the id is NoId if nobody has.
  RankAddress holder{ -1, NoId };
};

/// What was noticed while a surface was read. Of all ranks together.
struct SurfaceReport
{
  vtkIdType droppedVertexCells = 0;
  vtkIdType droppedLineCells = 0;
  /// Faces with two corners at one point, before or after merging; left out.
  vtkIdType facesWithRepeatedPoint = 0;
  /// Polygons whose outline crosses itself, so that their triangles overlap. The first one's block
  /// and cell are known in one process only.
  vtkIdType crossingOutlines = 0;
  std::size_t blockOfFirstCrossing = 0;
  vtkIdType cellOfFirstCrossing = -1;
  /// Vertices on the boundary of the surface, its blocks or ranks' pieces that were joined with
  /// others within the precision of coordinates or the user's tolerance.
  vtkIdType joinedSeamPoints = 0;
  /// Edges of the boundary that lie beside others, and how far apart they are at most, on the
  /// mesh's scale; see findCracks().
  vtkIdType crackEdges = 0;
  double crackWidth = 0.0;
  /// The edges of the mesh.
  vtkIdType edges = 0;

  /// Makes the report of one rank's piece that of all ranks, which call this together.
  void addRanks(const MeshPartition& partition);
  void addCrossingOutline(std::size_t block, vtkIdType cell)
  {
    if (this->crossingOutlines++ == 0)
    {
      this->blockOfFirstCrossing = block;
      this->cellOfFirstCrossing = cell;
    }
  }
};

/// What this rank has of a surface of one or more vtkPolyData as the engine takes it, and the way
/// back to points and cells. One process has all of it. Points and triangles are numbered through
/// all blocks. Made by readSurface().
///
/// Barriers are triangles of the surface, and outputs have all of them, but they are not faces of
/// the mesh: see BarrierFaces.
///
/// The mesh has no faces without area: triangles beside them are cut into parts
/// (removeFacesWithoutArea). Parts are numbered through all blocks, too, and are the triangles
/// themselves on nearly all surfaces.
struct PolyDataSurface
{
  /// The mesh of the faces that paths may enter, the open triangles of all blocks, with the halo.
  MeshPartition partition{ noMesh() };
  /// Values for the vertices of this rank's points that no face of the mesh here has.
  BorrowedValues valuesElsewhere;
  /// The mesh of the barriers of all blocks; null if no rank has barriers.
  std::unique_ptr<BarrierFaces> barriers;
  /// For each vertex of this rank's barriers the one that vertexOf() names.
  std::vector<Id> barrierVertices;
  /// The vertex that stands for a point of the input. Vertices of the mesh come first, then remote
  /// ones. Without a table each point of the input is a vertex of the mesh, of the same number.
  VertexOfPoint vertexOf;
  std::vector<SurfaceBlock> blocks;
  Id numberOfPoints = 0;
  /// The corners of each part, and the triangle that it was cut from, ascending; empty if the parts
  /// are the triangles that the output has if it is not refined.
  std::vector<Triangle> corners;
  std::vector<Id> triangles;
  /// Of parts on the same vertices the mesh has one: partOf() tells which.
  Id numberOfParts = 0;
  /// The points of parts behind those of the input.
  std::vector<CutPoint> cutPoints;
  /// The role of each part; empty if all are open.
  std::vector<TriangleRole> roles;
  /// The parts that are open, unless all are, and those that are barriers.
  std::vector<Id> openParts;
  std::vector<Id> barrierParts;
  /// What the mesh, and all that is computed on it, is larger by than the input.
  PowerOfTwoScale scale;
  /// Around the points that triangles use, on the mesh; of the whole surface.
  Box box;
  /// The diagonal of the box.
  double diagonal = 0.0;
  SurfaceReport report;

  const TriangleMesh& mesh() const { return this->partition.mesh(); }
  Exchange& exchange() const { return this->partition.exchange(); }
  /// Takes names and cells of an input with the same content in place of those of the input that
  /// this was made of, which need not be kept any longer then.
  void useBlocks(const std::vector<PolyDataBlock>& inputs);

  /// Gives values at the mesh's vertices one at each vertex that vertexOf() names. All ranks call
  /// this together.
  ///
  /// \param none the value where there is no face.
  template <typename Value>
  void completeValues(const Value& none, std::vector<Value>& values) const
  {
    values.resize(this->mesh().numberOfVertices(), none);
    this->valuesElsewhere.append(none, values, this->exchange());
  }
  GlobalVertex vertexOfMesh(Id vertex) const
  {
    const bool hasFaces = this->mesh().cornersAt(vertex).size() > 0;
    return { this->partition.globalId(vertex), this->mesh().point(vertex),
      { this->exchange().rank(), hasFaces ? vertex : NoId } };
  }
  /// The remote vertices: those that no face of the mesh here has. All ranks call this together.
  std::vector<GlobalVertex> remoteVertices() const;

  /// How many parts are surface, on all ranks, which call this together. The others are copies by
  /// ghost arrays.
  std::uint64_t countPartsOfAllRanks() const;
  /// Whether a part is an open face or a barrier.
  bool isFace(Id part) const
  {
    return (this->roles.empty() || this->roles[part] < TriangleRole::Copy) &&
      hasThreeVertices(this->verticesAt(part));
  }
  bool isCopy(Id part) const
  {
    return !this->roles.empty() && this->roles[part] == TriangleRole::Copy;
  }
  /// The points at a part's corners.
  Triangle cornersOf(Id part) const
  {
    return this->corners.empty() ? pointsOfTriangle(this->blocks, part) : this->corners[part];
  }
  /// The vertices at a part's corners.
  Triangle verticesAt(Id part) const { return this->vertexOf(this->cornersOf(part)); }
  Id triangleOfPart(Id part) const
  {
    return this->triangles.empty() ? part : this->triangles[part];
  }
  /// The part that a face of the mesh came from, which this rank owns; and its triangle.
  Id partOf(Id face) const
  {
    const Id open = this->partition.triangleOf(face);
    return this->openParts.empty() ? open : this->openParts[open];
  }
  Id triangleOf(Id face) const { return this->triangleOfPart(this->partOf(face)); }
  /// The triangle that a face of the barriers came from, which this rank owns.
  Id triangleOfBarrier(Id face) const
  {
    return this->triangleOfPart(this->barrierParts[this->barriers->surface().triangleOf(face)]);
  }
  /// The block of a triangle, and the cell of the block's input that it came from.
  std::pair<std::size_t, vtkIdType> inputCellOf(Id triangle) const
  {
    const std::size_t index = this->blockOf(triangle, &SurfaceBlock::firstTriangle);
    const SurfaceBlock& block = this->blocks[index];
    return { index, block.inputCell(triangle - block.firstTriangle) };
  }
  /// "cell 17 of the surface (input port 0)"
  std::string nameOfCell(Id triangle) const;
  /// The cells of the input that faces of any rank come from, by a number in the whole input: all
  /// cells of all blocks, in their order, and of the ranks that have a piece, one after another.
  /// All ranks that have a piece call this together.
  std::vector<vtkIdType> inputCellsOf(const std::vector<RankAddress>& faces) const;
  std::size_t blockOf(Id item, Id SurfaceBlock::*first) const
  {
    return geodesic::blockOf(this->blocks, item, first);
  }

private:
  static const TriangleMesh& noMesh();
};

/// An edge of a face, from one vertex to another, and the face's third vertex, by any numbers.
using FaceEdge = std::array<std::uint64_t, 3>;
/// The ends of an edge, the lower one first.
std::array<std::uint64_t, 2> endsOf(const FaceEdge& edge);
/// The edges that have one face, in their order. Faces on the same vertices count as one.
std::vector<FaceEdge> edgesOfOneFace(const std::vector<FaceEdge>& edges);

/// Numbers the vertices that triangles use, in their order, and changes the corners to these
/// numbers.
///
/// \param numberOfVertices all of them.
/// \returns the vertices that are used.
std::vector<Id> numberUsedVertices(std::vector<Triangle>& triangles, std::size_t numberOfVertices);

}

#endif
