// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TrianglePoints_h
#define geodesic_TrianglePoints_h

#include "PolyData/reading/PolyDataSurface.h"
#include "refinement/RefinedMesh.h"

namespace geodesic
{

/// Finds the points of a triangle that is no face of the mesh, in the places of points that a face
/// with the same vertices has. They are the same points, or others beside them where the two have
/// points of their own, as along a seam.
class TrianglePoints
{
public:
  /// \param refined to which points are added. Nothing else may add points to it.
  TrianglePoints(const PolyDataSurface& surface, RefinedMesh& refined)
    : surface_(surface)
    , refined_(refined)
    , numbering_(refined)
  {
  }

  /// What follows is about this triangle, given by the input's points.
  void begin(const Triangle& triangle)
  {
    this->corners_ = triangle;
    this->vertices_ = this->surface_.verticesOf(triangle);
  }
  const Triangle& vertices() const { return this->vertices_; }

  /// The triangle's own point in the place of a point on one of its vertices, or of one that has
  /// split the connection of two such points.
  Id like(Id point);

private:
  const PolyDataSurface& surface_;
  RefinedMesh& refined_;
  SplitPointNumbering numbering_;
  Triangle corners_{};
  Triangle vertices_{};
};

}

#endif
