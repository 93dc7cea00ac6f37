// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DeviationRules_h
#define geodesic_DeviationRules_h

#include "refinement/RedGreenClosure.h"
#include "refinement/RefinementWorkers.h"

namespace geodesic
{

/// Splits edges by deviation: an edge over the tolerance is split where its deviation is largest,
/// moved away from the ends by the table of section 6.2. If that makes a part's smallest angle too
/// small, the split moves halfway to the edge's middle, or to the middle. Edges that are split only
/// to close a triangle are split in the middle.
///
/// A part's angle is too small if it is under 14 degrees and under 0.6 of the input face's smallest
/// angle; if the edge is far over the tolerance, under 4 degrees.
///
/// An edge of thin leaves alone is cut where the fewest pieces come out. From a sharp corner on,
/// these get longer only so fast that the angles of strips do not fall under half the input face's
/// smallest (StripCorner). If such an angle is smaller nevertheless, when all edges are within the
/// tolerance, points on one side of the strip are much closer than on the other; then the longer
/// part of an edge there is split, too.
class DeviationRules : public SplitRules
{
public:
  /// \param triangles, workers must outlive this.
  /// \param tolerance of the refinement.
  DeviationRules(RedGreenMesh& triangles, RefinementWorkers& workers, double tolerance)
    : triangles_(triangles)
    , workers_(workers)
    , tolerance_(tolerance)
  {
  }

  RedGreenMesh::Placement place(Id edge) override;
  /// Whether the leaf has a closing with good shapes; better ones are asked for if an edge is split
  /// more than once, as such a leaf has no other way to be closed.
  bool mayClose(Id leaf) override;
  /// The longer of two parts of edges whose lengths are too different for good shapes.
  Id edgeToSplit(Id leaf) override;
  /// The same if a part would have a smaller angle than the input face: it may get smaller again.
  Id edgeToSplitBeforeParts(Id leaf) override;

  /// The smallest angle allowed in the parts of a face if an edge with this deviation is split.
  double allowedAngle(Id face, double deviation) const;
  /// The smallest angle allowed in the triangles that close a leaf.
  double allowedAngle(Id leaf) const;
  /// The smallest angle of the triangles that close a leaf in one of the ways.
  double smallestAngle(Id leaf, Id way) const;

  /// Whether a new part of an edge must be split whatever the triangles at it look like: it is over
  /// the tolerance, and longer than these are high, which are thin.
  bool mustSplit(Id part) const;

private:
  bool mayClose(Id leaf, double allowed) const;
  double weightOf(Id edge) const;
  bool isBetweenThinLeaves(Id edge) const;
  StripCorners cornersAt(Id edge) const;
  std::vector<double> waysOfPoints(Id edge, Id corner) const;
  bool isAnyOverTolerance(Id leaf) const;
  Id longerPart(Id leaf, Id way, double allowed) const;
  double leastAngleOf(Id face) const;
  double smallestAngleOfFour(Id triangle, Id splitEdge, double weight) const;

  RedGreenMesh& triangles_;
  RefinementWorkers& workers_;
  double tolerance_;
};

}

#endif
