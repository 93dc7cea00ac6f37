// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PartShapes_h
#define geodesic_PartShapes_h

#include "refinement/RedGreenMesh.h"

namespace geodesic
{

/// The smallest angles that splits make, and how small they may be.
///
/// A part's angle is too small if it is under 14 degrees and under 0.6 of the input face's smallest
/// angle; if the edge is far over the tolerance, under 3 degrees.
class PartShapes
{
public:
  /// \param triangles must outlive this.
  /// \param tolerance of the refinement.
  PartShapes(RedGreenMesh& triangles, double tolerance)
    : triangles_(triangles)
    , tolerance_(tolerance)
  {
  }

  /// The smallest angle allowed in the parts of a face if an edge with this deviation is split.
  double allowedAngle(Id face, double deviation) const;

  /// The smallest angle of the triangles that close a leaf of the face.
  double smallestAngle(Id face, const RedGreenMesh::Closing& closing) const;

  /// The smallest angle of a leaf's four parts if one edge is split at the weight, and the others
  /// where they are split already or in the middle.
  double smallestAngleOfFour(Id triangle, Id splitEdge, double weight);

  /// Whether the shapes of the leaves around an edge with this deviation permit splitting it at the
  /// weight.
  bool maySplit(Id edge, double weight, double deviation);

  /// Whether a leaf with such deviations around it has a closing with good shapes.
  bool mayClose(Id triangle, double deviation) const;

private:
  RedGreenMesh& triangles_;
  double tolerance_;
};

}

#endif
