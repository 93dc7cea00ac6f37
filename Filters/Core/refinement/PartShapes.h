// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PartShapes_h
#define geodesic_PartShapes_h

#include "refinement/RedGreenMesh.h"

namespace geodesic
{

/// The smallest angles that splits make, and how small they may be.
///
/// A part's angle is too small under 14 degrees and under 0.6 of the input face's smallest, and
/// under 3 degrees while the edge is far over the tolerance.
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

  /// How small an angle may be in the parts of a face, when an edge of such a deviation is
  /// split.
  double allowedAngle(Id face, double deviation) const;

  /// The smallest angle of the triangles that close a leaf of the face.
  double smallestAngle(Id face, const RedGreenMesh::Closing& closing) const;

  /// The smallest angle of a leaf's four parts when one edge is split at the weight, the others
  /// where they are or in the middle.
  double smallestAngleOfFour(Id triangle, Id splitEdge, double weight);

  /// Whether an edge of such a deviation may be split at the weight, for the shapes of the leaves
  /// around it.
  bool maySplit(Id edge, double weight, double deviation);

  /// Whether a leaf with such deviations around it has a closing of good shapes.
  bool mayClose(Id triangle, double deviation) const;

private:
  RedGreenMesh& triangles_;
  double tolerance_;
};

}

#endif
