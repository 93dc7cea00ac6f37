// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DeviationRules_h
#define geodesic_DeviationRules_h

#include "refinement/EdgeDistances.h"
#include "refinement/PartShapes.h"
#include "refinement/RedGreenClosure.h"

namespace geodesic
{

/// The rules of splits by deviation: an edge over the tolerance is split where its deviation is
/// largest, moved away from the ends by the table of section 6.2. Where a part's smallest angle
/// would be too small the table yields: the edge is split halfway to its middle, or there. Others,
/// which are split to close, are split in the middle.
class DeviationRules : public SplitRules
{
public:
  /// All must outlive this.
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
