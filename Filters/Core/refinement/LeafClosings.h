// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LeafClosings_h
#define geodesic_LeafClosings_h

#include "refinement/ClosingCheck.h"
#include "refinement/PartShapes.h"

#include <vector>

namespace geodesic
{

/// Finds how leaves are closed best and holds them against the tolerance, many leaves side by side:
/// they have nothing to do with each other until edges are split.
class LeafClosings
{
public:
  /// How a leaf is closed, and what that is worth.
  struct Closed
  {
    Id way = 0;
    ClosingCheck::Result check;
  };

  /// All must outlive this.
  ///
  /// \param tolerance of the refinement.
  LeafClosings(RedGreenMesh& triangles, EdgeDistances& edges, const PartShapes& shapes,
    RefinementWorkers& workers, double tolerance)
    : triangles_(triangles)
    , edges_(edges)
    , shapes_(shapes)
    , workers_(workers)
    , check_(triangles, edges, tolerance)
  {
  }

  /// For each leaf, of the ways to flip its inner edges: of those that pass the one of the best
  /// shapes, and where none does that of the smallest error. Ways of bad shapes are taken where
  /// there is no other. Valid until the next call.
  const std::vector<Closed>& findBest(const std::vector<Id>& leaves);

  /// The bound of a leaf as it is closed now, near a difference that occurs.
  double tightBound(Id leaf);

private:
  void measureEdges(const std::vector<Id>& leaves);
  Closed findBest(RefinementWorker& worker, Id leaf) const;
  double largestAround(Id leaf) const;

  RedGreenMesh& triangles_;
  EdgeDistances& edges_;
  const PartShapes& shapes_;
  RefinementWorkers& workers_;
  ClosingCheck check_;
  std::vector<Closed> best_;
};

}

#endif
