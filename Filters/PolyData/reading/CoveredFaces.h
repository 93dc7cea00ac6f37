// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CoveredFaces_h
#define geodesic_CoveredFaces_h

#include "Job.h"
#include "PolyData/reading/SourceCells.h"
#include "mesh/Box.h"

#include <array>
#include <functional>
#include <vector>

namespace geodesic
{

/// A cell of a surface: its rank, its block there, and its number in the block's input.
using SurfaceCell = std::array<vtkIdType, 3>;

/// The faces of a source as a mesh of triangles of their own, which tells where they lie.
class SourceFaceMesh
{
public:
  /// \param faces at least one.
  /// \param coordinatePrecision relative precision of the points' coordinates.
  SourceFaceMesh(const std::vector<SourceFace>& faces, double coordinatePrecision);

  /// A point inside each face, where it is widest.
  std::vector<LocatedPolyline> pointsInside() const;

  /// Finds the faces of a surface, of all ranks, that each face of the source consists of within
  /// the precision of coordinates. If it is a cell of the surface, which may have been cut, these
  /// are the cell's own faces, whatever else lies on it; otherwise all that lie in it, if they fill
  /// it. A source's face that also lies in parts of other faces has none. All ranks call this
  /// together, and get the same.
  ///
  /// \param cellOf a face that this rank owns.
  /// \throws Aborted
  std::vector<std::vector<RankAddress>> findCovered(const MeshPartition& surface,
    const std::function<SurfaceCell(Id)>& cellOf, const Job& job) const;

private:
  bool covers(std::size_t by, const TriangleMesh& surface, Id face) const;
  bool holds(std::size_t by, const Vec3& point) const;
  double area2(std::size_t of) const;

  double precision_;
  TriangleMesh mesh_;
  Box box_;
  /// The face of each triangle, and the first triangle of each face.
  std::vector<std::size_t> faces_;
  std::vector<Id> first_;
};

}

#endif
