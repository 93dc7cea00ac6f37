// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeDistances_h
#define geodesic_EdgeDistances_h

#include "refinement/RefinementWorkers.h"

#include <vector>

namespace geodesic
{

/// How far the distance along the edges of a mesh under refinement is from the interpolant,
/// measured once an edge.
class EdgeDistances
{
public:
  /// Both must outlive this.
  EdgeDistances(const RedGreenMesh& triangles, RefinementWorkers& workers)
    : triangles_(triangles)
    , workers_(workers)
  {
  }

  /// The largest deviations of an edge.
  Deviation deviation(Id edge);

  /// Measures those of the edges that have not been measured, side by side.
  void measure(const std::vector<Id>& edges);
  /// The largest deviations of an edge that has been measured; may be called from several threads.
  Deviation measured(Id edge) const { return this->ofEdge_[edge].deviation; }

  /// The distance on an edge, at a fraction of the way from its first end.
  double onEdge(Id edge, double weight)
  {
    return this->workers_.first().distances.onEdge(edge, weight);
  }

  /// Edges from this number on have never been.
  void forget(Id firstEdge);

private:
  struct Measured
  {
    Deviation deviation;
    bool known = false;
  };

  const RedGreenMesh& triangles_;
  RefinementWorkers& workers_;
  std::vector<Measured> ofEdge_;
  /// Work space.
  std::vector<Id> unknown_;
};

}

#endif
