// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LeafClosings_h
#define geodesic_LeafClosings_h

#include "refinement/DeviationRules.h"

#include <array>
#include <utility>
#include <vector>

namespace geodesic
{

/// Finds the best closings of leaves and checks them against the tolerance, many leaves in
/// parallel: they are independent until edges are split.
class LeafClosings
{
public:
  /// How well the triangles that close a leaf in one way approximate the distance.
  struct Check
  {
    Id way = 0;
    /// Certified bound of the difference to the distance of all faces.
    double bound = 0.0;
    /// A difference that does occur.
    double sample = 0.0;
    /// Whether the leaf may stay as it is.
    bool passed = true;
    /// The limit for differences within the leaf's face.
    double limit = Infinity;
  };

  /// All arguments must outlive this.
  ///
  /// \param tolerance of the refinement.
  LeafClosings(RedGreenMesh& triangles, RefinementWorkers& workers, const DeviationRules& rules,
    double tolerance)
    : triangles_(triangles)
    , workers_(workers)
    , rules_(rules)
    , tolerance_(tolerance)
  {
  }

  /// For each leaf, the best of the ways to flip its inner edges: the one with the best shapes
  /// among those that pass, or, if none passes, the one with the smallest error. Ways with bad
  /// shapes are used only if there is no other.
  std::vector<Check> findBest(const std::vector<Id>& leaves);

  /// A bound of the leaf's current closing, close to a difference that does occur.
  double tightBound(Id leaf);

  /// Checks a way to close a leaf whose edges, including the halves of split ones, exist and have
  /// been measured. Several workers may do this at the same time.
  ///
  /// \param tight whether to search for a bound near a difference that does occur.
  Check check(RefinementWorker& worker, Id leaf, Id way, bool tight) const;

private:
  /// The deviations of the segments across a leaf, each between two points.
  using Across = std::vector<std::pair<std::pair<Id, Id>, Deviation>>;

  Check checkTriangle(RefinementWorker& worker, const FaceDistance& face,
    const RedGreenMesh::Closing& closing, const std::array<Id, 3>& t, Across& across,
    bool tight) const;
  double worstPartOfEdges(Id leaf) const;
  void measureEdges(const std::vector<Id>& leaves);
  Check findBest(RefinementWorker& worker, Id leaf) const;

  RedGreenMesh& triangles_;
  RefinementWorkers& workers_;
  const DeviationRules& rules_;
  double tolerance_;
};

}

#endif
