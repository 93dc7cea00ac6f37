// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolyDataSurface_h
#define geodesic_PolyDataSurface_h

#include "mesh/TriangleMesh.h"
#include "source/PolylineLocator.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <vector>

class vtkCellArray;
class vtkPoints;
class vtkPolyData;

namespace geodesic
{

/// The surface of a vtkPolyData as the engine takes it, and the way back to the input's points and
/// cells. It holds the input's points (never changing them) but not the input.
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

  /// Triangulates polygons and strips, and merges the points that lie at exactly one place.
  ///
  /// \param progress called now and then; returning false throws Aborted.
  /// \throws MeshError where there is no face, a coordinate is not finite or a cell names a point
  ///         that does not exist; Aborted.
  PolyDataSurface(
    vtkPolyData* input, bool mergeCoincidentPoints, const ProgressCallback& progress = {});

  const TriangleMesh& mesh() const { return *this->mesh_; }
  const Report& report() const { return this->report_; }
  double diagonal() const { return this->diagonal_; }

  /// The vertex that stands for a point of the input.
  Id vertexOf(vtkIdType point) const
  {
    return this->vertexOfPoint_.empty() ? static_cast<Id>(point)
                                        : this->vertexOfPoint_[static_cast<std::size_t>(point)];
  }

  vtkIdType numberOfPoints() const;
  /// Whether some of the input's points are one vertex.
  bool hasMergedPoints() const { return !this->vertexOfPoint_.empty(); }

  /// The triangles that the output has where it is not refined. Of those on the same vertices the
  /// mesh has one: TriangleMesh::inputFace tells which.
  vtkIdType numberOfTriangles() const;
  /// The input's points at a triangle's corners.
  Triangle triangle(Id triangle) const;
  /// The input's points at the corners of a face of the mesh.
  Triangle cornerPoints(Id face) const { return this->triangle(this->mesh_->inputFace(face)); }
  /// The input's cell that a triangle came from.
  vtkIdType inputCell(Id triangle) const
  {
    return this->inputCells_.empty() ? triangle : this->inputCells_[triangle];
  }

  /// Finds places on the surface; what that takes is built when it is needed, and kept.
  PolylineLocator& locator() { return *this->locator_; }

  /// Gives the output the input's points with their data, the triangles, and for each the data of
  /// the cell that it came from. The input is the one that this surface was made from.
  void copyTo(vtkPolyData* input, vtkPolyData* output, const ProgressCallback& progress = {}) const;

private:
  void readTriangles(
    vtkPolyData* input, std::vector<Triangle>& corners, const LoopProgress& progress);
  void keepTriangles(vtkPolyData* input, const std::vector<Triangle>& corners);

  std::unique_ptr<TriangleMesh> mesh_;
  Report report_;
  double diagonal_ = 0.0;
  vtkSmartPointer<vtkPoints> points_;
  /// Empty where every point is a vertex of its own.
  std::vector<Id> vertexOfPoint_;
  /// Empty where every point is a vertex of its own.
  std::vector<vtkIdType> pointOfVertex_;
  vtkSmartPointer<vtkCellArray> triangles_;
  /// The input's cell that each triangle came from; empty where the triangles are the input's
  /// cells.
  std::vector<vtkIdType> inputCells_;
  std::unique_ptr<PolylineLocator> locator_;
};

/// The first few of some ids, for an error message: "3, 17, 20 and 5 more".
std::string listIds(const std::vector<vtkIdType>& ids);

}

#endif
