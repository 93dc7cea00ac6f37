// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeDistances_h
#define geodesic_EdgeDistances_h

#include "refinement/RefinementWorkers.h"

#include <vector>

namespace geodesic
{

/// The deviation between the distance along the edges of a mesh under refinement and the
/// interpolant. Each edge is measured once.
class EdgeDistances
{
public:
  /// Both arguments must outlive this.
  EdgeDistances(const RedGreenMesh& triangles, RefinementWorkers& workers)
    : triangles_(triangles)
    , workers_(workers)
  {
  }

  /// The largest deviations of an edge; measures it if necessary.
  Deviation deviation(Id edge);

  /// Measures all edges that have not been measured yet, in parallel.
  void measure(const std::vector<Id>& edges);
  /// The largest deviations of a measured edge; may be called from several threads.
  Deviation measured(Id edge) const { return this->ofEdge_[edge].deviation; }

  /// The distance on an edge at a fraction of its length from its first end.
  double onEdge(Id edge, double weight)
  {
    return this->workers_.first().distances.onEdge(edge, weight);
  }

  /// Forgets the edges from this number on, which no longer exist.
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
