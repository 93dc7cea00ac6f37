// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LeafClosings_h
#define geodesic_LeafClosings_h

#include "refinement/ClosingCheck.h"
#include "refinement/PartShapes.h"

#include <vector>

namespace geodesic
{

/// Finds the best closings of leaves and checks them against the tolerance, many leaves in
/// parallel: they are independent until edges are split.
class LeafClosings
{
public:
  /// How a leaf is closed, and the quality of the closing.
  struct Closed
  {
    Id way = 0;
    ClosingCheck::Result check;
  };

  /// All arguments must outlive this.
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

  /// For each leaf, the best of the ways to flip its inner edges: the one with the best shapes
  /// among those that pass, or, if none passes, the one with the smallest error. Ways with bad
  /// shapes are used only if there is no other. Valid until the next call.
  const std::vector<Closed>& findBest(const std::vector<Id>& leaves);

  /// A bound of the leaf's current closing, close to a difference that does occur.
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
