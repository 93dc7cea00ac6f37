// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceSnap_h
#define geodesic_SurfaceSnap_h

#include "mesh/SurfacePoint.h"

namespace geodesic
{

/// A point in space, put onto the surface.
struct SnappedPoint
{
  SurfacePoint place;
  /// From the point in space to the place, measured from a corner of the face.
  Vec3 offset{};
  /// The length of the offset to the place as stored by its coordinates.
  double distance = 0.0;
  /// The precision of the place: points closer together than this are one.
  double tolerance = 0.0;
};

/// Puts a point onto the closest point of a face, and from there onto a vertex or an edge of the
/// face within the precision of the coordinates (Tolerance.h). Faces may be needles.
///
/// \param coordinatePrecision relative precision of the point's coordinates.
SnappedPoint snapToFace(
  const TriangleMesh& mesh, Id face, const Vec3& point, double coordinatePrecision);

}

#endif
