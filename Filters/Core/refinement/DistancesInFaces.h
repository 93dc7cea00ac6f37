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

/// The distance at the points and along the segments of a mesh under refinement, measured in the
/// faces that hold them. Each thread has its own, for the memory that it works in; the mesh stays
/// as it is while several are at work.
///
/// In an approximate field the faces at a point may have different distances there. The point's own
/// is the smallest of them.
class DistancesInFaces
{
public:
  /// \param field with windows kept; like the triangles it must outlive this.
  DistancesInFaces(const DistanceField& field, const RedGreenMesh& triangles)
    : field_(field)
    , triangles_(triangles)
  {
  }

  /// The distance in a face. Valid until another face is asked for: refinement asks for one face
  /// many times in turn, and making it costs as much as some segments.
  const FaceDistance& face(Id face);

  double atPoint(Id point) const;
  /// As one of the faces at the point has it.
  ///
  /// \param place of the point in the face's plane.
  double atPoint(Id point, const FaceDistance& face, Vec2 place) const;

  /// The largest deviations of an edge, in any of the faces around it that are refined.
  Deviation ofEdge(Id edge);
  /// The same of the connection of two points of a face.
  Deviation between(Id a, Id b, const FaceDistance& face);

  /// The distance on an edge, at a fraction of the way from its first end.
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
