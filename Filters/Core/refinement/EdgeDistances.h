// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeDistances_h
#define geodesic_EdgeDistances_h

#include "field/SegmentEnvelope.h"
#include "refinement/Deviation.h"
#include "refinement/FaceDistanceCache.h"
#include "refinement/RedGreenMesh.h"

#include <vector>

namespace geodesic
{

/// The distance at the points and along the edges of a mesh under refinement.
///
/// In an approximate field the faces at a point may have different distances there. The point's own
/// is the smallest of them.
class EdgeDistances
{
public:
  /// All must outlive this.
  EdgeDistances(const DistanceField& field, const RedGreenMesh& triangles, FaceDistanceCache& faces)
    : field_(field)
    , triangles_(triangles)
    , faces_(faces)
  {
  }

  double atPoint(Id point) const;
  /// As one of the faces at the point has it.
  ///
  /// \param place of the point in the face's plane.
  double atPoint(Id point, const FaceDistance& face, Vec2 place) const;

  /// The largest deviations of an edge, in any of the faces around it that are refined. Measured
  /// once an edge.
  Deviation deviation(Id edge);
  /// The same of the connection of two points of a face.
  Deviation deviationBetween(Id a, Id b, const FaceDistance& face);

  /// The distance on an edge, at a fraction of the way from its first end.
  double onEdge(Id edge, double weight);

  /// Edges from this number on have never been.
  void forget(Id firstEdge);

private:
  template <typename Visit>
  void forEachRefinedFace(const RedGreenMesh::Edge& edge, Visit&& visit) const;
  Deviation measure(const RedGreenMesh::Edge& edge);

  struct Measured
  {
    Deviation deviation;
    bool known = false;
  };

  const DistanceField& field_;
  const RedGreenMesh& triangles_;
  FaceDistanceCache& faces_;
  SegmentEnvelope envelope_;
  std::vector<Measured> ofEdge_;
};

}

#endif
