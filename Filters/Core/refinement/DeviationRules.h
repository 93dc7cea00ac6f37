// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DeviationRules_h
#define geodesic_DeviationRules_h

#include "refinement/EdgeDistances.h"
#include "refinement/PartShapes.h"
#include "refinement/RedGreenClosure.h"

namespace geodesic
{

/// Splits edges by deviation: an edge over the tolerance is split where its deviation is largest,
/// moved away from the ends by the table of section 6.2. If that makes a part's smallest angle too
/// small, the split moves halfway to the edge's middle, or to the middle. Edges that are split only
/// to close a triangle are split in the middle.
class DeviationRules : public SplitRules
{
public:
  /// All arguments must outlive this.
  DeviationRules(
    RedGreenMesh& triangles, EdgeDistances& distances, PartShapes& shapes, double tolerance)
    : triangles_(triangles)
    , distances_(distances)
    , shapes_(shapes)
    , tolerance_(tolerance)
  {
  }

  RedGreenMesh::Placement place(Id edge) override;
  bool mayClose(Id triangle) override;

  /// The largest deviation of a triangle's edges.
  double largestAround(Id triangle);

private:
  double weightOf(Id edge);

  RedGreenMesh& triangles_;
  EdgeDistances& distances_;
  PartShapes& shapes_;
  double tolerance_;
};

}

#endif
