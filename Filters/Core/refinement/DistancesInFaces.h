// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistancesInFaces_h
#define geodesic_DistancesInFaces_h

#include "field/FaceDistance.h"
#include "field/SegmentEnvelope.h"
#include "refinement/Deviation.h"
#include "refinement/RedGreenMesh.h"

#include <optional>

namespace geodesic
{

/// The distance at points and along segments of a mesh under refinement, measured in the faces that
/// contain them. Each thread has its own object, with its own memory; the mesh does not change
/// while several threads measure.
///
/// In an approximate field the faces at a point may have different distances there. The point's own
/// distance is the smallest of them.
class DistancesInFaces
{
public:
  /// \param field with windows kept; must outlive this, like the triangles.
  DistancesInFaces(const DistanceField& field, const RedGreenMesh& triangles)
    : field_(field)
    , triangles_(triangles)
  {
  }

  /// The distance in a face, valid until the next call. The last face is cached: refinement often
  /// asks for the same face repeatedly, and building it costs as much as measuring some segments.
  const FaceDistance& face(Id face);

  double atPoint(Id point) const;
  /// The distance at a point according to one of its faces.
  ///
  /// \param place of the point in the face's plane.
  double atPoint(Id point, const FaceDistance& face, Vec2 place) const;

  /// The largest deviations of an edge in any of its refined faces.
  Deviation ofEdge(Id edge);
  /// The largest deviations of the segment between two points of a face.
  Deviation between(Id a, Id b, const FaceDistance& face);

  /// The distance on an edge at a fraction of its length from its first end.
  double onEdge(Id edge, double weight);

private:
  template <typename Visit>
  void forEachRefinedFace(const RedGreenMesh::Edge& edge, Visit&& visit) const;

  const DistanceField& field_;
  const RedGreenMesh& triangles_;
  std::optional<FaceDistance> last_;
  SegmentEnvelope envelope_;
};

}

#endif
